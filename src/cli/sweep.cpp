// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/truth_arguments.hpp"
#include "cli/values.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"
#include "planescope/stored_scene.hpp"
#include "planescope/sweep.hpp"
#include "planescope/sweep_plot.hpp"

namespace planescope::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  Console console;
  TruthArguments counted;
  std::filesystem::path folder, csv, plot, truth;
  std::string option, size;
};

std::vector<std::uint32_t> read_truth(const Arguments& a, const StoredScene& stored) {
  if (a.truth.empty()) return {};
  const std::vector<std::uint32_t> labels = read_cloud(a.truth).labels;
  if (labels.size() != stored.cloud.size())
    throw Error(Error::Kind::Input, a.truth.string() + ": has " + std::to_string(labels.size()) +
                                        " true labels, the scene has " +
                                        std::to_string(stored.cloud.size()) +
                                        " points; name the cloud that the scene was made from");
  return apply_policy(stored.scene.point_label, labels, a.counted.policy);
}

Json rows_json(const std::vector<SweepRow>& rows) {
  Json all = Json::array();
  const auto or_null = [](const auto& value) { return value ? Json(*value) : Json(); };
  for (const SweepRow& row : rows) {
    all.push_back({{"value", row.value},
                   {"patches", row.patches},
                   {"planes", row.planes},
                   {"segments", row.segments},
                   {"edges_on", row.edges_on},
                   {"edges_off", row.edges_off},
                   {"switched_on", or_null(row.switched_on)},
                   {"switched_off", or_null(row.switched_off)},
                   {"agreement", row.agreement}});
    if (!row.scores) continue;
    all.back()["weighted_overlap"] = row.scores->weighted_overlap;
    all.back()["overlap"] = row.scores->overlap;
    all.back()["over_segmentation"] = row.scores->over_segmentation;
    all.back()["under_segmentation"] = row.scores->under_segmentation;
  }
  return all;
}

void run(Arguments& a) {
  a.counted.check();
  const SweepRange range = parse_sweep(a.option);
  if (!a.plot.empty() && a.plot.extension() != ".png")
    throw Error(Error::Kind::Usage,
                "--plot is `" + a.plot.string() + "`; it takes a name that ends in .png");
  SweepPlotOptions plot;
  if (!a.size.empty()) plot.size = parse_size("--size", a.size);
  const StoredScene stored = load_scene(a.folder);
  plot.title = stored.input.name;
  const auto rows =
      sweep(stored.scene, stored.cloud, range, read_truth(a, stored), a.console.progress());
  const std::string csv = sweep_csv(range, rows);
  if (!a.plot.empty()) plot_sweep(range, rows, plot, a.plot);
  if (!a.csv.empty()) write_whole(a.csv, csv);
  for (const auto& file : {a.csv, a.plot})
    if (!file.empty()) a.console.say(file.string());
  if (a.console.json) {
    const Json all = {{"option", range.option}, {"rows", rows_json(rows)}};
    std::printf("%s\n", all.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
  } else if (a.csv.empty()) {
    std::fputs(csv.c_str(), stdout);
  }
}

}  // namespace

Command add_sweep(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("sweep", "What an option changes: CSV and a plot");
  command->add_option("DIR", a->folder, "Result folder of `planescope segment`")->required();
  command
      ->add_option("--option", a->option,
                   "Option of the engine and its values, as edges.concavity_tolerance=5:15:1 or "
                   "planes.solver=lsa_tr,lsa_tr+tabu")
      ->required()
      ->type_name("NAME=VALUES");
  command->add_option("-o,--output", a->csv, "Table (stdout)")->type_name("CSV");
  command->add_option("--plot", a->plot, "Segments, flipped edges and scores over the values")
      ->type_name("PNG");
  command->add_option("--size", a->size, "Size of the plot (1200x1000)")->type_name("WxH");
  command->add_option("--truth", a->truth, "Cloud with the true labels: scores are added")
      ->type_name("CLOUD");
  a->counted.declare(*command);
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
