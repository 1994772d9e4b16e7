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
#include "cli/memory.hpp"
#include "cli/truth_arguments.hpp"
#include "cli/values.hpp"
#include "io/pcd_reader.hpp"
#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/io.hpp"
#include "planescope/project.hpp"
#include "planescope/result.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Arguments {
  Console console;
  TruthArguments counted;
  LimitArguments limits;
  fs::path result, truth, truth_planes;
  std::string camera, pose;
  std::uint32_t splat = 0;
  double require_overlap = 0, nearest = 0;
};

/// What is scored.
struct Prediction {
  PointCloud cloud;
  std::vector<std::uint32_t> labels;
  std::uint32_t width = 0, height = 1;
  MethodInfo method;
  std::vector<Plane> planes;
};

/// All scores; borders of organised views only, planes where true ones were given.
struct Scores {
  ScoredLabels labels;
  std::optional<BoundaryScores> borders;
  std::optional<PlaneScores> planes;
  std::optional<double> holes;  ///< share of the counted pixels that the projection left empty
};

PointCloud read_labelled(const fs::path& file, const ReadLimits& limits) {
  PointCloud cloud = read_cloud(file, limits);
  if (!cloud.has_labels()) {
    throw Error(Error::Kind::Input,
                file.string() + ": has no field `label`; name a cloud that has one");
  }
  return cloud;
}

Prediction read_prediction(const Arguments& a) {
  Prediction prediction;
  if (fs::is_directory(a.result)) {
    Result result = load_result(a.result);
    prediction.cloud = std::move(result.cloud);
    prediction.labels = std::move(result.point_label);
    prediction.method = std::move(result.method);
    for (const SupportingPlane& plane : result.planes) prediction.planes.push_back(plane.plane);
  } else if (a.truth_planes.empty()) {
    prediction.cloud = read_labelled(a.result, a.limits.read());
    prediction.labels = prediction.cloud.labels;
  } else {
    throw Error(Error::Kind::Usage,
                "--truth-planes needs a result folder; " + a.result.string() + " is none");
  }
  prediction.width = prediction.cloud.width;
  prediction.height = prediction.cloud.height;
  return prediction;
}

/// Of another cloud of the same place.
std::vector<std::uint32_t> read_nearest(const Arguments& a, const PointCloud& cloud) {
  NearestLabels nearest = nearest_labels(read_labelled(a.truth), cloud, a.nearest);
  char text[120];
  std::snprintf(text, sizeof text,
                "truth is %.2f mm away on average; %zu points are further than %g m",
                1000 * nearest.mean_distance, nearest.beyond, a.nearest);
  a.console.say(text);
  return std::move(nearest.labels);
}

/// A column of the scored cloud itself: another field of the PCD file.
std::vector<std::uint32_t> read_field(const Arguments& a) {
  const fs::path file = fs::is_directory(a.result) ? a.result / "points.pcd" : a.result;
  const auto column = io::read_pcd_columns(file, {a.truth.string()}).extra.at(0);
  return {column.begin(), column.end()};
}

/// --truth names a file or, where there is none and the name could be one, a field.
std::vector<std::uint32_t> read_truth(const Arguments& a, const PointCloud& cloud) {
  if (a.nearest > 0) return read_nearest(a, cloud);
  const std::size_t size = cloud.size();
  const bool field = !fs::exists(a.truth) && !a.truth.has_parent_path() && !a.truth.has_extension();
  std::vector<std::uint32_t> truth =
      field ? read_field(a) : read_labelled(a.truth, a.limits.read()).labels;
  if (truth.size() != size) {
    throw Error(Error::Kind::Input, a.truth.string() + ": has " + std::to_string(truth.size()) +
                                        " points, " + a.result.string() + " has " +
                                        std::to_string(size) + "; name the cloud of that result");
  }
  return truth;
}

/// The result as the camera sees it, in place of its points. \returns the image's truth.
std::vector<std::uint32_t> project(const Arguments& a, Prediction& prediction) {
  PointCloud image = read_labelled(a.truth, a.limits.read());
  if (!image.organised()) {
    throw Error(Error::Kind::Input, a.truth.string() +
                                        ": is no organised view; --camera needs a labelled image, "
                                        "a cloud of more than one row");
  }
  const auto [fx, fy, cx, cy] = parse_intrinsics("--camera", a.camera);
  PinholeCamera camera{image.width, image.height, fx, fy, cx, cy};
  if (!a.pose.empty()) camera.pose = parse_pose("--pose", a.pose);
  prediction.labels = project_labels(prediction.cloud, prediction.labels, camera, a.splat);
  prediction.width = image.width;
  prediction.height = image.height;
  return std::move(image.labels);
}

double share_of_holes(const std::vector<std::uint32_t>& labels,
                      const std::vector<std::uint32_t>& truth) {
  std::size_t counted = 0, holes = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (truth[i] == 0) continue;
    ++counted;
    holes += labels[i] == kNoSegment ? 1 : 0;
  }
  return counted == 0 ? 0 : static_cast<double>(holes) / static_cast<double>(counted);
}

Scores score(const Arguments& a, Prediction& prediction) {
  const bool projected = !a.camera.empty();
  const auto truth = projected ? project(a, prediction) : read_truth(a, prediction.cloud);
  Scores scores{score(a.counted, prediction.labels, truth), {}, {}, {}};
  if (projected) scores.holes = share_of_holes(prediction.labels, truth);
  if (prediction.height > 1) {
    scores.borders = score_boundaries(prediction.labels,
                                      apply_policy(prediction.labels, truth, a.counted.policy),
                                      prediction.width);
  }
  if (a.truth_planes.empty()) return scores;
  const auto faces = read_true_planes(a.truth_planes, prediction.cloud.origin);
  if (prediction.method.has_planes) {
    scores.planes = score_planes(prediction.planes, faces);
  } else {
    a.console.say(prediction.method.name + " has no planes to score");
  }
  return scores;
}

Json labels_json(const TruthArguments& counted, const LabelScores& s) {
  Json regions = Json::array();
  const std::uint32_t shift = counted.policy.divide > 1 ? 1 : 0;  // of merge_truth()
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

Json policy_json(const TruthArguments& counted) {
  return {{"divide", counted.policy.divide},
          {"from", counted.policy.from},
          {"ignore", counted.policy.ignore},
          {"unlabelled", counted.unlabelled}};
}

void print_json(const Arguments& a, const Scores& scores) {
  Json outcome = {{"policy", policy_json(a.counted)},
                  {"labels", labels_json(a.counted, scores.labels.all)}};
  if (scores.labels.objects && scores.labels.objects->regions > 0) {
    outcome["objects"] = {{"weighted_overlap", scores.labels.objects->weighted_overlap},
                          {"overlap", scores.labels.objects->overlap},
                          {"regions", scores.labels.objects->regions}};
  }
  if (scores.holes) outcome["projection"] = {{"holes", *scores.holes}};
  if (scores.borders) {
    outcome["borders"] = {{"recall", scores.borders->recall},
                          {"precision", scores.borders->precision}};
  }
  if (scores.planes) outcome["planes"] = planes_json(*scores.planes);
  std::printf("%s\n", outcome.dump(1).c_str());
}

void print_table(const Scores& scores) {
  const LabelScores& s = scores.labels.all;
  std::printf("weighted overlap WO        %7.4f\n", s.weighted_overlap);
  std::printf("overlap UO                 %7.4f\n", s.overlap);
  std::printf("over-segmentation F_os     %7.4f\n", s.over_segmentation);
  std::printf("under-segmentation F_us    %7.4f\n", s.under_segmentation);
  std::printf("adjusted Rand index        %7.4f\n", s.adjusted_rand);
  std::printf("variation of information   %7.4f bit\n", s.variation_of_information);
  std::printf("true regions, segments     %7u, %u\n", s.regions, s.segments);
  if (scores.labels.objects && scores.labels.objects->regions > 0) {
    std::printf("objects alone: WO, UO      %7.4f, %.4f\n", scores.labels.objects->weighted_overlap,
                scores.labels.objects->overlap);
  }
  if (scores.holes) std::printf("holes of the projection    %7.4f\n", *scores.holes);
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

void run(Arguments& a) {
  a.counted.check();
  a.limits.apply();
  if (a.camera.empty() && (!a.pose.empty() || a.splat > 0)) {
    throw Error(Error::Kind::Usage, "--pose and --splat need --camera FX,FY,CX,CY");
  }
  if (!(a.require_overlap >= 0 && a.require_overlap <= 1)) {  // nan too
    throw Error(Error::Kind::Usage,
                "--require-overlap is " + std::to_string(a.require_overlap) + "; it takes 0 to 1");
  }
  Prediction prediction = read_prediction(a);
  const Scores scores = score(a, prediction);
  if (a.console.json) {
    print_json(a, scores);
  } else {
    print_table(scores);
  }
  const double overlap = scores.labels.all.weighted_overlap;
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
      ->add_option("--truth-planes", a->truth_planes,
                   "True planes, as `planescope synthesize` writes them")
      ->type_name("JSON");
  command
      ->add_option("--require-overlap", a->require_overlap,
                   "Exit with 6 where the weighted overlap is below this, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("WO");
  command
      ->add_option("--camera", a->camera,
                   "Score the image that this pinhole camera has of RESULT; --truth is a labelled "
                   "view of that size, in its pixels")
      ->type_name("FX,FY,CX,CY");
  command->add_option("--pose", a->pose, "Camera to world, as in TUM's trajectories (the origin)")
      ->type_name("TX,TY,TZ,QX,QY,QZ,QW");
  command->add_option("--splat", a->splat, "A point covers N pixels around its own too (0)")
      ->check(CLI::Range(0, 64))
      ->type_name("N");
  command
      ->add_option("--truth-nearest", a->nearest,
                   "--truth is another cloud of the same place: each point counts as its nearest "
                   "one there, within this distance [m]")
      ->check(CLI::Range(1e-6, 10.0))
      ->type_name("M");
  a->counted.declare(*command);
  a->limits.declare(*command);
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
