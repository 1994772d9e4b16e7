// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// \file What a batch's table tells of a method on a scene, and where it comes from.
namespace planescope {

/// One column of the table.
struct TableMeasure {
  std::string key;    ///< in JSON and CSV: `weighted_overlap`
  std::string title;  ///< in Markdown: `WO %`
  std::string latex;  ///< its title in LaTeX
  std::string
      source;        ///< JSON pointer in the scores of `planescope evaluate --json`; empty: a time
  double scale = 1;  ///< shown times this: 100 for percent
  int digits = 2;    ///< shown behind the point
  bool median = false;  ///< the table tells the median over scenes, not the mean
};

/// Key of the time that a method took: all of its stages, without reading and writing.
inline constexpr const char* kTimeMeasure = "time_ms";

/// Every measure, in the order of the columns.
const std::vector<TableMeasure>& measures();

/// Values of one scene by the measures' keys; those that do not apply (planes of a method without
/// planes) are absent.
using MeasureValues = std::map<std::string, double>;

/// \param scores_json output of `planescope evaluate --json`, or an empty path: not scored;
/// \param run_json run.json of the result.
/// \throws Error{Kind::Input} a file is missing or malformed.
MeasureValues read_measures(const std::filesystem::path& scores_json,
                            const std::filesystem::path& run_json);

}  // namespace planescope
