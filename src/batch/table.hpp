// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch/measures.hpp"
#include "batch/statistics.hpp"

/// \file The table over all scenes of a batch, from its folder alone.
namespace planescope {

/// A row: a method, or the difference of two.
struct TableRow {
  std::string method;
  std::string against;  ///< of a difference, taken scene by scene; empty: the method itself
  std::map<std::string, Estimate> cells;  ///< by TableMeasure::key
};

/// A job without scores.
struct TableFailure {
  std::string scene, method, reason;
};

/// Scores of one job.
struct TableScene {
  std::string scene, method;
  MeasureValues values;
};

/// Means over the scenes that a method has finished (of time: the median), and paired differences
/// over those that both methods have: ours, or the last method, against each other one.
struct BatchTable {
  std::size_t scenes = 0;
  std::vector<TableRow> methods, differences;
  std::vector<TableFailure> failures;
  std::vector<TableScene> per_scene;
};

/// Gathers the jobs of the batch in `folder`, whichever shards did them. A job that has not been
/// run with the plan's settings counts as failed.
/// \throws Error{Kind::Input} no batch is there.
BatchTable summarise(const std::filesystem::path& folder);

/// The table for people; failures below it.
std::string to_markdown(const BatchTable& table);
/// For a paper: booktabs, one row a method, then the differences; needs \usepackage{booktabs}.
std::string to_latex(const BatchTable& table);
/// `method,against,measure,value,low,high,scenes`, unscaled.
std::string to_csv(const BatchTable& table);
/// Everything, with the scores of each scene, unscaled.
std::string to_json(const BatchTable& table);

/// table.md, table.tex, table.csv and table.json into the batch's folder, each whole.
/// \throws Error{Kind::Input} it cannot be written.
void write_table(const BatchTable& table, const std::filesystem::path& folder);

}  // namespace planescope
