// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "io/pcd_reader.hpp"
#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/io.hpp"
#include "planescope/result.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Arguments {
  Console console;
  fs::path result, truth, truth_planes;
  std::uint32_t truth_divide = 1, truth_from = 0;
  double require_overlap = 0;
};

/// What is scored.
struct Prediction {
  std::vector<std::uint32_t> labels;
  std::uint32_t width = 0, height = 1;
  std::vector<Plane> planes;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

/// All scores; borders of organised views only, planes where true ones were given.
struct Scores {
  LabelScores labels;
  std::optional<BoundaryScores> borders;
  std::optional<PlaneScores> planes;
};

PointCloud read_labelled(const fs::path& file) {
  PointCloud cloud = read_cloud(file);
  if (!cloud.has_labels()) {
    throw Error(Error::Kind::Input,
                file.string() + ": has no field `label`; name a cloud that has one");
  }
  return cloud;
}

Prediction read_prediction(const Arguments& a) {
  if (!fs::is_directory(a.result)) {
    if (!a.truth_planes.empty()) {
      throw Error(Error::Kind::Usage,
                  "--truth-planes needs a result folder; " + a.result.string() + " is none");
    }
    PointCloud cloud = read_labelled(a.result);
    return {std::move(cloud.labels), cloud.width, cloud.height, {}, cloud.origin};
  }
  Result result = load_result(a.result);
  const PointCloud& cloud = result.cloud;
  Prediction prediction{std::move(result.point_label), cloud.width, cloud.height, {}, cloud.origin};
  for (const SupportingPlane& plane : result.planes) prediction.planes.push_back(plane.plane);
  return prediction;
}

/// A column of the scored cloud itself: another field of the PCD file.
std::vector<std::uint32_t> read_field(const Arguments& a) {
  const fs::path file = fs::is_directory(a.result) ? a.result / "points.pcd" : a.result;
  const auto column = io::read_pcd_columns(file, {a.truth.string()}).extra.at(0);
  return {column.begin(), column.end()};
}

/// --truth names a file or, where there is none and the name could be one, a field.
std::vector<std::uint32_t> read_truth_labels(const Arguments& a) {
  const bool field = !fs::exists(a.truth) && !a.truth.has_parent_path() && !a.truth.has_extension();
  return field ? read_field(a) : read_labelled(a.truth).labels;
}

/// Truth under the policies of the command line.
std::vector<std::uint32_t> read_truth(const Arguments& a, std::size_t size) {
  std::vector<std::uint32_t> truth = read_truth_labels(a);
  if (truth.size() != size) {
    throw Error(Error::Kind::Input, a.truth.string() + ": has " + std::to_string(truth.size()) +
                                        " points, " + a.result.string() + " has " +
                                        std::to_string(size) + "; name the cloud of that result");
  }
  for (std::uint32_t& label : truth) {
    if (label < a.truth_from) label = 0;
  }
  return a.truth_divide > 1 ? merge_truth(truth, a.truth_divide) : truth;
}

Scores score(const Arguments& a, const Prediction& prediction) {
  const auto truth = read_truth(a, prediction.labels.size());
  Scores scores{score_labels(prediction.labels, truth), {}, {}};
  if (prediction.height > 1) {
    scores.borders = score_boundaries(prediction.labels, truth, prediction.width);
  }
  if (!a.truth_planes.empty()) {
    const auto faces = read_true_planes(a.truth_planes, prediction.origin);
    scores.planes = score_planes(prediction.planes, faces);
  }
  return scores;
}

Json labels_json(const Arguments& a, const LabelScores& s) {
  Json regions = Json::array();
  const std::uint32_t shift = a.truth_divide > 1 ? 1 : 0;  // of merge_truth()
  for (const RegionScore& region : s.per_region) {
    regions.push_back({{"truth", region.truth - shift},
                       {"points", region.points},
                       {"predicted", region.predicted},
                       {"overlap", region.overlap}});
  }
  return {{"weighted_overlap", s.weighted_overlap},
          {"overlap", s.overlap},
          {"over_segmentation", s.over_segmentation},
          {"under_segmentation", s.under_segmentation},
          {"adjusted_rand", s.adjusted_rand},
          {"variation_of_information", s.variation_of_information},
          {"regions", s.regions},
          {"segments", s.segments},
          {"per_region", std::move(regions)}};
}

Json planes_json(const PlaneScores& p) {
  return {{"recall", p.recall},
          {"structural_recall", p.structural_recall},
          {"precision", p.precision},
          {"true_planes", p.true_planes},
          {"structural_planes", p.structural_planes},
          {"found_planes", p.found_planes},
          {"invented", p.invented},
          {"repeated", p.repeated},
          {"mean_angle", p.mean_angle},
          {"max_angle", p.max_angle},
          {"mean_offset", p.mean_offset},
          {"max_offset", p.max_offset},
          {"manhattan_deviation", p.manhattan_deviation}};
}

void print_json(const Arguments& a, const Scores& scores) {
  Json outcome = {{"labels", labels_json(a, scores.labels)}};
  if (scores.borders) {
    outcome["borders"] = {{"recall", scores.borders->recall},
                          {"precision", scores.borders->precision}};
  }
  if (scores.planes) outcome["planes"] = planes_json(*scores.planes);
  std::printf("%s\n", outcome.dump(1).c_str());
}

void print_table(const Scores& scores) {
  const LabelScores& s = scores.labels;
  std::printf("weighted overlap WO        %7.4f\n", s.weighted_overlap);
  std::printf("overlap UO                 %7.4f\n", s.overlap);
  std::printf("over-segmentation F_os     %7.4f\n", s.over_segmentation);
  std::printf("under-segmentation F_us    %7.4f\n", s.under_segmentation);
  std::printf("adjusted Rand index        %7.4f\n", s.adjusted_rand);
  std::printf("variation of information   %7.4f bit\n", s.variation_of_information);
  std::printf("true regions, segments     %7u, %u\n", s.regions, s.segments);
  if (scores.borders) {
    std::printf("border recall, precision   %7.4f, %.4f\n", scores.borders->recall,
                scores.borders->precision);
  }
  if (!scores.planes) return;
  const PlaneScores& p = *scores.planes;
  std::printf("plane recall, precision    %7.4f, %.4f\n", p.recall, p.precision);
  std::printf("structural plane recall    %7.4f of %u\n", p.structural_recall, p.structural_planes);
  std::printf("planes found, invented     %7u, %u\n", p.found_planes, p.invented);
  std::printf("angle error mean, max      %7.4f, %.4f deg\n", p.mean_angle, p.max_angle);
  std::printf("offset error mean, max     %7.4f, %.4f m\n", p.mean_offset, p.max_offset);
  std::printf("pairs off parallel or 90   %7.4f deg\n", p.manhattan_deviation);
}

void run(const Arguments& a) {
  if (!(a.require_overlap >= 0 && a.require_overlap <= 1)) {  // nan too
    throw Error(Error::Kind::Usage,
                "--require-overlap is " + std::to_string(a.require_overlap) + "; it takes 0 to 1");
  }
  const Scores scores = score(a, read_prediction(a));
  if (a.console.json) {
    print_json(a, scores);
  } else {
    print_table(scores);
  }
  const double overlap = scores.labels.weighted_overlap;
  if (overlap < a.require_overlap) {
    throw Error(Error::Kind::Mismatch, "weighted overlap is " + std::to_string(overlap) +
                                           "; --require-overlap asks for " +
                                           std::to_string(a.require_overlap));
  }
}

}  // namespace

Command add_evaluate(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("evaluate", "Score a segmentation against the truth");
  command->add_option("RESULT", a->result, "Result folder, or a cloud whose labels are scored")
      ->required();
  command
      ->add_option("--truth", a->truth,
                   "Cloud with the true labels (0 is not counted), or the name of an integer "
                   "field of RESULT's own PCD file")
      ->required()
      ->type_name("CLOUD|FIELD");
  command
      ->add_option("--truth-divide", a->truth_divide,
                   "True objects are label / N: merges the parts of one object")
      ->check(CLI::Range(1u, 1'000'000u))
      ->type_name("N");
  command->add_option("--truth-from", a->truth_from, "Count only true labels from N up")
      ->type_name("N");
  command
      ->add_option("--truth-planes", a->truth_planes,
                   "True planes, as `planescope synthesize` writes them")
      ->type_name("JSON");
  command
      ->add_option("--require-overlap", a->require_overlap,
                   "Exit with 6 where the weighted overlap is below this, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("WO");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
