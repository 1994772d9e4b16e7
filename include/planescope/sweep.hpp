// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planescope/evaluate.hpp"
#include "planescope/pipeline.hpp"

/// \file What an option changes: runs of one scene with one value after the other.
namespace planescope {

/// An option and the values to try.
struct SweepRange {
  std::string option;
  std::vector<std::string> values;  ///< as text that set_option() takes
};

/// `edges.concavity_tolerance=5:15:1` (from, to, step; at most 1000 values) or
/// `planes.solver=lsa_tr,lsa_tr+tabu`. \throws Error{Kind::Usage} something else, or no such option
/// or value.
SweepRange parse_sweep(const std::string& text);

/// One run.
struct SweepRow {
  std::string value;
  std::size_t patches = 0, planes = 0, segments = 0, edges_on = 0, edges_off = 0;
  /// Edges that differ from the stored run; nothing where the patches are others.
  std::optional<std::size_t> switched_on, switched_off;
  double agreement = 0;               ///< weighted overlap with the stored segments as the truth
  std::optional<LabelScores> scores;  ///< where a truth was given
};

/// Runs the scene with each value. Options of `patches.*` run the whole method on `cloud`, all
/// others the stages behind the patches: the answer is the same.
/// \param truth labels of the points to score against, or empty.
/// \throws Error{Kind::Usage} a value contradicts other options, or the method is a peer;
/// Error{Kind::Input} `patches.*`, and `cloud` does not give the stored segments again: the input
/// had normals, which result folders do not keep.
std::vector<SweepRow> sweep(const Segmentation& scene, const PointCloud& cloud,
                            const SweepRange& range, const std::vector<std::uint32_t>& truth = {},
                            const Progress& progress = {});

/// The rows as CSV with a header; what a row lacks is empty.
std::string sweep_csv(const SweepRange& range, const std::vector<SweepRow>& rows);

}  // namespace planescope
