// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// patch_quality [DATA FOLDER]: boundary recall and under-segmentation error of our patches and of
// PCL's supervoxels at the same radii, by one evaluator, on the table-top views and on synthesized
// rooms.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "baselines/baselines.hpp"
#include "inputs.hpp"
#include "planescope/io.hpp"
#include "planescope/patches.hpp"
#include "planescope/synthesize.hpp"

namespace {

using namespace planescope;

/// Means over clouds. Points count that have a truth label.
struct Quality {
  double recall = 0;   ///< share of truth boundary cells that are patch boundary cells
  double error = 0;    ///< under-segmentation error: points that leak over a region's border
  double covered = 0;  ///< share of points in a patch
  double patches = 0;  ///< number
};

/// Cells of a grid, and which truth labels and patches the points in each one have.
using Cell = std::array<std::int32_t, 3>;
struct CellLabels {
  std::vector<std::uint32_t> truth;
  std::vector<std::int32_t> patches;
};

template <typename T>
void insert_once(std::vector<T>& values, T value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

std::map<Cell, CellLabels> cells_of(const PointCloud& cloud, const PatchGraph& graph) {
  std::map<Cell, CellLabels> cells;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.positions[i]) || cloud.labels[i] == 0) continue;
    const Eigen::Vector3f at = (cloud.positions[i] / graph.voxel_size).array().floor();
    CellLabels& cell = cells[{static_cast<std::int32_t>(at.x()), static_cast<std::int32_t>(at.y()),
                              static_cast<std::int32_t>(at.z())}];
    insert_once(cell.truth, cloud.labels[i]);
    if (graph.point_patch[i] != kNone) insert_once(cell.patches, graph.point_patch[i]);
  }
  return cells;
}

/// A cell is on a boundary if it and its 26 neighbours hold two labels: a tolerance of one voxel.
/// Boundary of patches: two patches; the rim of a hole is none.
double boundary_recall(const PointCloud& cloud, const PatchGraph& graph) {
  const std::map<Cell, CellLabels> cells = cells_of(cloud, graph);
  std::size_t boundary = 0, recalled = 0;
  for (const auto& entry : cells) {
    CellLabels around;
    for (std::int32_t x = -1; x <= 1; ++x)
      for (std::int32_t y = -1; y <= 1; ++y)
        for (std::int32_t z = -1; z <= 1; ++z) {
          const Cell& c = entry.first;
          const auto at = cells.find({c[0] + x, c[1] + y, c[2] + z});
          if (at == cells.end()) continue;
          for (const std::uint32_t t : at->second.truth) insert_once(around.truth, t);
          for (const std::int32_t p : at->second.patches) insert_once(around.patches, p);
        }
    if (around.truth.size() < 2) continue;
    ++boundary;
    if (around.patches.size() >= 2) ++recalled;
  }
  return boundary > 0 ? static_cast<double>(recalled) / static_cast<double>(boundary) : 1.0;
}

/// Neubert and Protzel, 2012: the sum over regions R and patches S that meet R of
/// min(|S n R|, |S \ R|), over the number of points.
void leak(const PointCloud& cloud, const PatchGraph& graph, Quality& quality) {
  std::map<std::pair<std::int32_t, std::uint32_t>, double> both;
  std::map<std::int32_t, double> size;
  double points = 0, covered = 0, error = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.positions[i]) || cloud.labels[i] == 0) continue;
    ++points;
    if (graph.point_patch[i] == kNone) continue;
    ++covered;
    ++both[{graph.point_patch[i], cloud.labels[i]}];
    ++size[graph.point_patch[i]];
  }
  for (const auto& [pair, count] : both) error += std::min(count, size[pair.first] - count);
  quality.error = error / points;
  quality.covered = covered / points;
}

Quality measure(const PointCloud& cloud, const PatchGraph& graph) {
  Quality quality;
  quality.recall = boundary_recall(cloud, graph);
  leak(cloud, graph, quality);
  quality.patches = static_cast<double>(graph.patches.size());
  return quality;
}

void print(const std::string& name, const Quality& q) {
  std::printf("%-34s %8.2f %10.3f %9.2f %9.0f\n", name.c_str(), 100 * q.recall, 100 * q.error,
              100 * q.covered, q.patches);
}

template <typename Read>
void compare(const std::string& name, std::size_t count, const Read& read,
             const PatchOptions& options) {
  Quality ours, theirs;
  const auto add = [count](Quality& mean, const Quality& one) {
    mean.recall += one.recall / static_cast<double>(count);
    mean.error += one.error / static_cast<double>(count);
    mean.covered += one.covered / static_cast<double>(count);
    mean.patches += one.patches / static_cast<double>(count);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const PointCloud cloud = read(i);
    add(ours, measure(cloud, make_patches(cloud, options)));
    add(theirs, measure(cloud, pcl_patches(cloud, options)));
  }
  print(name + ", ours", ours);
  print(name + ", PCL", theirs);
}

void run(const std::string& folder) {
  std::printf("%-34s %8s %10s %9s %9s\n", "means over clouds [%]", "recall", "leak", "covered",
              "patches");
  const auto views = bench::tabletop_views(bench::data_folder(folder));
  if (!views.empty())
    compare(
        "table-top views", views.size(), [&](std::size_t i) { return read_cloud(views[i]); },
        Options::tabletop().patches);
  compare(
      "rooms, evenly sampled", 5, [](std::size_t i) { return bench::room(1'000'000, i + 1); },
      bench::room_options(0.02, 0.10).patches);
  compare(
      "rooms, depth cameras", 5,
      [](std::size_t i) {
        SynthesisOptions options;
        options.views = 4;
        options.random_seed = i + 1;
        return synthesize(options).cloud;
      },
      bench::room_options(0.02, 0.10).patches);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? argv[1] : "");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "patch_quality: %s\n", error.what());
    return 1;
  }
}
