// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// tabletop_scores [DATA FOLDER] [--merge-parts] [--views]: WO and UO [%] of every method over the
// table-top views, means of the views' scores; then over the regions with labels from 20 up, the
// objects. Truth: the labels as the files have them (the published reference scores of the peers
// are on these), or, with --merge-parts, label / 10, which makes the parts of an object one region.
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "baselines/baselines.hpp"
#include "inputs.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/io.hpp"
#include "planescope/pipeline.hpp"

namespace {

using namespace planescope;

using Labels = std::vector<std::uint32_t>;

struct Method {
  std::string name;
  std::function<Labels(const PointCloud&)> run;
};

std::vector<Method> methods() {
  return {
      {"ours, tabletop", [](const auto& c) { return segment(c, Options::tabletop()).point_label; }},
      {"ours, auto", [](const auto& c) { return segment(c, Options::automatic(c)).point_label; }},
      {"ransac", [](const auto& c) { return ransac(c).point_label; }},
      {"lccp", [](const auto& c) { return lccp(c).point_label; }},
      {"cpc", [](const auto& c) { return cpc(c).point_label; }},
  };
}

/// Region labels; the table's (below 10) become 1, so that 0 stays "no truth".
Labels truth_of(const PointCloud& cloud, bool merge_parts) {
  Labels truth = cloud.labels;
  for (std::uint32_t& label : truth) {
    if (label != 0 && label < 10) label = 1;
    if (merge_parts && label >= 10) label = label / 10 * 10;
  }
  return truth;
}

struct Score {
  double wo = 0, uo = 0, object_wo = 0, object_uo = 0;
  void add(const Score& s, double weight) {
    wo += weight * s.wo;
    uo += weight * s.uo;
    object_wo += weight * s.object_wo;
    object_uo += weight * s.object_uo;
  }
};

Score score(const Labels& predicted, const Labels& truth) {
  const LabelScores all = score_labels(predicted, truth);
  Score result{all.weighted_overlap, all.overlap};
  double points = 0, regions = 0;
  for (const RegionScore& region : all.per_region) {
    if (region.truth < 20) continue;
    points += static_cast<double>(region.points);
    regions += 1;
    result.object_wo += static_cast<double>(region.points) * region.overlap;
    result.object_uo += region.overlap;
  }
  if (regions > 0) result.object_wo /= points, result.object_uo /= regions;
  return result;
}

void print(const std::string& name, const Score& s) {
  std::printf("%-28s %7.2f %7.2f %12.2f %12.2f\n", name.c_str(), 100 * s.wo, 100 * s.uo,
              100 * s.object_wo, 100 * s.object_uo);
}

int run(const std::string& folder, bool merge_parts, bool each_view) {
  const auto views = bench::tabletop_views(bench::data_folder(folder));
  if (views.empty()) {
    std::fprintf(stderr, "tabletop_scores: no mosd_learn/*.pcd; name the data folder\n");
    return 3;
  }
  std::printf("%-28s %7s %7s %12s %12s\n", "", "WO", "UO", "WO objects", "UO objects");
  const std::vector<Method> all = methods();
  std::vector<Score> mean(all.size());
  for (const auto& view : views) {
    const PointCloud cloud = read_cloud(view);
    const Labels truth = truth_of(cloud, merge_parts);
    for (std::size_t m = 0; m < all.size(); ++m) {
      const Score found = score(all[m].run(cloud), truth);
      mean[m].add(found, 1.0 / static_cast<double>(views.size()));
      if (each_view) print(view.stem().string() + " " + all[m].name, found);
    }
  }
  for (std::size_t m = 0; m < all.size(); ++m) print("mean " + all[m].name, mean[m]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder;
  bool merge_parts = false, each_view = false;
  for (const std::string& argument : std::vector<std::string>(argv + 1, argv + argc)) {
    if (argument == "--merge-parts")
      merge_parts = true;
    else if (argument == "--views")
      each_view = true;
    else
      folder = argument;
  }
  try {
    return run(folder, merge_parts, each_view);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tabletop_scores: %s\n", error.what());
    return 1;
  }
}
