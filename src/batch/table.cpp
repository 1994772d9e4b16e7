// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/table.hpp"

#include <algorithm>

#include "batch/job.hpp"
#include "io/whole_file.hpp"

namespace planescope {
namespace {

using Values = std::map<std::string, std::vector<double>>;  // by measure

TableRow make_row(const std::string& method, const std::string& against, const Values& values) {
  TableRow row{method, against, {}};
  for (const TableMeasure& measure : measures()) {
    const auto found = values.find(measure.key);
    if (found == values.end()) continue;
    row.cells[measure.key] =
        bootstrap(found->second, measure.median ? Statistic::Median : Statistic::Mean);
  }
  return row;
}

TableRow mean_row(const BatchTable& table, const std::string& method) {
  Values values;
  for (const TableScene& scene : table.per_scene) {
    if (scene.method != method) continue;
    for (const auto& [key, value] : scene.values) values[key].push_back(value);
  }
  return make_row(method, "", values);
}

/// Scene by scene, where both have the measure.
TableRow difference_row(const BatchTable& table, const std::string& method,
                        const std::string& against) {
  std::map<std::string, const MeasureValues*> others;
  for (const TableScene& scene : table.per_scene)
    if (scene.method == against) others[scene.scene] = &scene.values;
  Values values;
  for (const TableScene& scene : table.per_scene) {
    const auto other = others.find(scene.scene);
    if (scene.method != method || other == others.end()) continue;
    for (const auto& [key, value] : scene.values) {
      const auto found = other->second->find(key);
      if (found != other->second->end()) values[key].push_back(value - found->second);
    }
  }
  return make_row(method, against, values);
}

void add_job(const PlannedJob& job, const std::filesystem::path& folder, BatchTable& table) {
  const auto record = read_record(job_folder(folder, job.scene, job.method));
  if (!record || record->settings_key != job.settings_key) {
    table.failures.push_back({job.scene, job.method, "not run yet with these settings"});
  } else if (!record->done) {
    table.failures.push_back({job.scene, job.method, record->reason});
  } else {
    table.per_scene.push_back({job.scene, job.method, record->values});
  }
}

}  // namespace

BatchTable summarise(const std::filesystem::path& folder) {
  const StoredPlan plan = read_plan(folder);
  BatchTable table;
  table.scenes = plan.scenes.size();
  for (const PlannedJob& job : plan.jobs) add_job(job, folder, table);
  for (const std::string& method : plan.methods) table.methods.push_back(mean_row(table, method));
  const bool has_ours = std::ranges::find(plan.methods, "ours") != plan.methods.end();
  const std::string first = has_ours || plan.methods.empty() ? "ours" : plan.methods.back();
  for (const std::string& method : plan.methods)
    if (method != first) table.differences.push_back(difference_row(table, first, method));
  return table;
}

void write_table(const BatchTable& table, const std::filesystem::path& folder) {
  write_whole(folder / "table.md", to_markdown(table));
  write_whole(folder / "table.tex", to_latex(table));
  write_whole(folder / "table.csv", to_csv(table));
  write_whole(folder / "table.json", to_json(table));
}

}  // namespace planescope
