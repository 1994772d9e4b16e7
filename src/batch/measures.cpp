// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/measures.hpp"

#include "json_file.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using Json = nlohmann::json;

constexpr const char* kHint = "run the batch again";

/// All but reading and writing.
constexpr const char* kStages[] = {"patches",    "hypotheses", "selection",
                                   "assignment", "edges",      "segments"};

}  // namespace

const std::vector<TableMeasure>& measures() {
  static const std::vector<TableMeasure> all = {
      {"weighted_overlap", "WO %", "WO", "/labels/weighted_overlap", 100, 2, false},
      {"overlap", "UO %", "UO", "/labels/overlap", 100, 2, false},
      {"over_segmentation", "F_os %", "$F_{os}$", "/labels/over_segmentation", 100, 2, false},
      {"under_segmentation", "F_us %", "$F_{us}$", "/labels/under_segmentation", 100, 2, false},
      {"adjusted_rand", "ARI", "ARI", "/labels/adjusted_rand", 1, 4, false},
      {"variation_of_information", "VI bit", "VI", "/labels/variation_of_information", 1, 3, false},
      {"objects_weighted_overlap", "WO objects %", "WO obj.", "/objects/weighted_overlap", 100, 2,
       false},
      {"objects_overlap", "UO objects %", "UO obj.", "/objects/overlap", 100, 2, false},
      {"plane_recall", "plane recall %", "recall", "/planes/recall", 100, 1, false},
      {"structural_recall", "structural recall %", "struct.", "/planes/structural_recall", 100, 1,
       false},
      {"plane_precision", "plane precision %", "precision", "/planes/precision", 100, 1, false},
      {"plane_angle", "angle error deg", "angle", "/planes/mean_angle", 1, 3, false},
      {"plane_offset", "offset error mm", "offset", "/planes/mean_offset", 1000, 2, false},
      {"manhattan_deviation", "off parallel or 90 deg", "dev.", "/planes/manhattan_deviation", 1, 3,
       false},
      {kTimeMeasure, "median time s", "time", "", 1e-3, 3, true},
  };
  return all;
}

MeasureValues read_measures(const std::filesystem::path& scores_json,
                            const std::filesystem::path& run_json) {
  MeasureValues values;
  if (!scores_json.empty()) {
    const Json scores = read_json(scores_json, kHint);
    for (const TableMeasure& measure : measures()) {
      if (measure.source.empty()) continue;
      const Json::json_pointer place(measure.source);
      if (scores.contains(place) && scores[place].is_number())
        values[measure.key] = scores[place].get<double>();
    }
  }
  const Json run = read_json(run_json, kHint);
  double time = 0;
  for (const char* stage : kStages) {
    const Json::json_pointer place(std::string("/timings_ms/") + stage);
    if (!run.contains(place) || !run[place].is_number())
      throw Error(Error::Kind::Input,
                  run_json.string() + ": has no time of the stage " + stage + "; " + kHint);
    time += run[place].get<double>();
  }
  values[kTimeMeasure] = time;
  return values;
}

}  // namespace planescope
