// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// planescope_ablation [DATA FOLDER] [--rooms N] [--first SEED]: what each part of the method is
// worth, as a Markdown table. A row is the method with one part taken away: the mean difference to
// the full method over the scenes, [2.5th, 97.5th percentile] of 10,000 paired bootstrap resamples.
// Scenes: the table-top views (truth as the labels say), and N (10) synthesized rooms of 500,000
// evenly spread points and N seen by 8 cameras, from seed SEED (1) on; all with `auto`. Plane
// scores at (5 degrees, 5 cm).
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>

#include "ablation_variants.hpp"
#include "batch/statistics.hpp"
#include "inputs.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/io.hpp"

namespace {

using namespace planescope;

struct Column {
  const char* title;
  bool rooms;
  int digits;
  double scale;
};

constexpr std::array<Column, 7> kColumns = {{{"views: WO %", false, 2, 100},
                                             {"UO %", false, 2, 100},
                                             {"rooms: WO %", true, 2, 100},
                                             {"UO %", true, 2, 100},
                                             {"recall %", true, 1, 100},
                                             {"precision %", true, 1, 100},
                                             {"deviation deg", true, 2, 1}}};

// By variant and column: a value a scene.
using Values = std::vector<std::array<std::vector<double>, kColumns.size()>>;

std::vector<std::uint32_t> truth_of(const bench::AblationScene& scene) {
  std::vector<std::uint32_t> truth = scene.cloud.labels;
  if (!scene.is_tabletop) return truth;
  for (std::uint32_t& label : truth) {
    if (label != 0 && label < 10) label = 1;  // parts of the table
  }
  return truth;
}

// Scores in the order of the columns that apply.
std::vector<double> score(const bench::AblationScene& scene, const Segmentation& found,
                          const std::vector<std::uint32_t>& truth) {
  const LabelScores labels = score_labels(found.point_label, truth);
  std::vector<double> scores = {labels.weighted_overlap, labels.overlap};
  if (scene.is_tabletop) return scores;
  std::vector<Plane> planes;
  for (const SupportingPlane& plane : found.planes) planes.push_back(plane.plane);
  const PlaneScores p = score_planes(planes, scene.planes);
  scores.insert(scores.end(), {p.recall, p.precision, p.manhattan_deviation});
  return scores;
}

void add_scene(const bench::AblationScene& scene, Values& values) {
  const std::vector<std::uint32_t> truth = truth_of(scene);
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t v) {
    const Segmentation found = bench::run(scene, bench::variants()[v]);
    std::size_t next = 0;
    const std::vector<double> scores = score(scene, found, truth);
    for (std::size_t c = 0; c < kColumns.size(); ++c) {
      if (kColumns[c].rooms != scene.is_tabletop)
        values[v][c].push_back(kColumns[c].scale * scores[next++]);
    }
  });
  std::fprintf(stderr, "%s\n", scene.name.c_str());
}

void add_room(std::uint64_t seed, std::uint32_t views, Values& values) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.points = 500'000;
  options.views = views;
  SynthesizedScene room = synthesize(options);
  const std::string name = "room " + std::to_string(seed) + (views > 0 ? ", views" : ", even");
  add_scene(bench::prepare(name, std::move(room.cloud), std::move(room.planes)), values);
}

std::string mean(const std::vector<double>& values, const Column& column) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", column.digits, statistic(values, Statistic::Mean));
  return text;
}

std::string difference(std::vector<double> values, const std::vector<double>& full,
                       const Column& column) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= full[i];
  const Estimate e = bootstrap(values, Statistic::Mean);
  if (e.low == 0 && e.high == 0) return "0";
  char text[96];
  std::snprintf(text, sizeof text, "%+.*f [%+.*f, %+.*f]", column.digits, e.value, column.digits,
                e.low, column.digits, e.high);
  return text;
}

void print(const Values& values) {
  std::string head = "| |", rule = "|---|";
  for (const Column& column : kColumns) {
    head += std::string(" ") + column.title + " |";
    rule += "---|";
  }
  std::printf("%s\n%s\n", head.c_str(), rule.c_str());
  for (std::size_t v = 0; v < values.size(); ++v) {
    std::string line = "| " + bench::variants()[v].name + " |";
    for (std::size_t c = 0; c < kColumns.size(); ++c) {
      const std::vector<double>& column = values[v][c];
      line += ' ';
      line += column.empty() ? "-"
              : v == 0       ? mean(column, kColumns[c])
                             : difference(column, values[0][c], kColumns[c]);
      line += " |";
    }
    std::printf("%s\n", line.c_str());
  }
}

int run(const std::string& folder, std::uint64_t rooms, std::uint64_t first) {
  Values values(bench::variants().size());
  const auto views = bench::tabletop_views(bench::data_folder(folder));
  if (views.empty())
    std::fprintf(stderr, "planescope_ablation: no mosd_learn/*.pcd; name the data folder\n");
  for (const auto& view : views) {
    bench::AblationScene scene = bench::prepare(view.stem().string(), read_cloud(view), {});
    scene.is_tabletop = true;
    add_scene(scene, values);
  }
  for (std::uint64_t seed = first; seed < first + rooms; ++seed) {
    add_room(seed, 0, values);
    add_room(seed, 8, values);
  }
  if (views.empty() && rooms == 0) return 3;
  print(values);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder;
  std::uint64_t rooms = 10, first = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--rooms" && i + 1 < argc)
      rooms = std::strtoull(argv[++i], nullptr, 10);
    else if (argument == "--first" && i + 1 < argc)
      first = std::strtoull(argv[++i], nullptr, 10);
    else
      folder = argument;
  }
  try {
    return run(folder, rooms, first);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "planescope_ablation: %s\n", error.what());
    return 1;
  }
}
