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
  std::vector<Plane> planes;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the cloud, to which planes relate
};

std::vector<std::uint32_t> labels_of(const fs::path& file) {
  PointCloud cloud = read_cloud(file);
  if (!cloud.has_labels()) {
    throw Error(Error::Kind::Input,
                file.string() + ": has no field `label`; name a cloud that has one");
  }
  return std::move(cloud.labels);
}

Prediction read_prediction(const Arguments& a) {
  Prediction prediction;
  if (!fs::is_directory(a.result)) {
    if (!a.truth_planes.empty()) {
      throw Error(Error::Kind::Usage,
                  "--truth-planes needs a result folder; " + a.result.string() + " is none");
    }
    prediction.labels = labels_of(a.result);
    return prediction;
  }
  Result result = load_result(a.result);
  prediction.labels = std::move(result.point_label);
  for (const SupportingPlane& plane : result.planes) prediction.planes.push_back(plane.plane);
  prediction.origin = result.cloud.origin;
  return prediction;
}

/// Truth labels under the policies of the command line. Label 0 stays 0 ("no truth"); with
/// --truth-divide the others are shifted by one, lest the first group become 0 too.
std::vector<std::uint32_t> read_truth(const Arguments& a, std::size_t size) {
  std::vector<std::uint32_t> truth = labels_of(a.truth);
  if (truth.size() != size) {
    throw Error(Error::Kind::Input, a.truth.string() + ": has " + std::to_string(truth.size()) +
                                        " points, " + a.result.string() + " has " +
                                        std::to_string(size) + "; name the cloud of that result");
  }
  for (std::uint32_t& label : truth) {
    if (label < a.truth_from) label = 0;
    if (label != 0 && a.truth_divide > 1) label = label / a.truth_divide + 1;
  }
  return truth;
}

Json labels_json(const Arguments& a, const LabelScores& s) {
  Json regions = Json::array();
  const std::uint32_t shift = a.truth_divide > 1 ? 1 : 0;
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
          {"mean_offset", p.mean_offset},
          {"max_angle", p.max_angle},
          {"max_offset", p.max_offset},
          {"manhattan_deviation", p.manhattan_deviation}};
}

void print_table(const LabelScores& s, const std::optional<PlaneScores>& p) {
  std::printf("weighted overlap              %8.4f\n", s.weighted_overlap);
  std::printf("overlap                       %8.4f\n", s.overlap);
  std::printf("over-segmentation             %8.4f\n", s.over_segmentation);
  std::printf("under-segmentation            %8.4f\n", s.under_segmentation);
  std::printf("adjusted Rand index           %8.4f\n", s.adjusted_rand);
  std::printf("variation of information      %8.4f bit\n", s.variation_of_information);
  std::printf("regions, segments             %8u %u\n", s.regions, s.segments);
  if (!p) return;
  std::printf("plane recall, precision       %8.4f %.4f\n", p->recall, p->precision);
  std::printf("structural planes' recall     %8.4f (of %u)\n", p->structural_recall,
              p->structural_planes);
  std::printf("planes found, invented        %8u %u\n", p->found_planes, p->invented);
  std::printf("plane angle error, largest    %8.4f %.4f deg\n", p->mean_angle, p->max_angle);
  std::printf("plane offset error, largest   %8.4f %.4f m\n", p->mean_offset, p->max_offset);
  std::printf("planes' deviation from 90 deg %8.4f deg\n", p->manhattan_deviation);
}

PlaneScores score_against(const fs::path& truth_file, const Prediction& prediction) {
  return score_planes(prediction.planes, read_true_planes(truth_file, prediction.origin));
}

void run(const Arguments& a) {
  const Prediction prediction = read_prediction(a);
  const auto truth = read_truth(a, prediction.labels.size());
  const LabelScores labels = score_labels(prediction.labels, truth);
  std::optional<PlaneScores> planes;
  if (!a.truth_planes.empty()) planes = score_against(a.truth_planes, prediction);
  if (a.console.json) {
    Json outcome = {{"labels", labels_json(a, labels)}};
    if (planes) outcome["planes"] = planes_json(*planes);
    std::printf("%s\n", outcome.dump(1).c_str());
  } else {
    print_table(labels, planes);
  }
  if (labels.weighted_overlap < a.require_overlap) {
    throw Error(Error::Kind::Mismatch,
                "weighted overlap is " + std::to_string(labels.weighted_overlap) +
                    "; --require-overlap asks for " + std::to_string(a.require_overlap));
  }
}

}  // namespace

Command add_evaluate(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("evaluate", "Score a segmentation against the truth");
  command->add_option("RESULT", a->result, "Result folder, or a cloud whose labels are scored")
      ->required();
  command->add_option("--truth", a->truth, "Cloud with the true labels; label 0 is not counted")
      ->required()
      ->type_name("CLOUD");
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
