// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planescope/evaluate.hpp"

namespace CLI {
class App;
}

namespace planescope::cli {

/// How truth is counted: what every subcommand that scores takes.
struct TruthArguments {
  static constexpr const char* kGroup = "What is scored";

  TruthPolicy policy;
  std::string unlabelled = "missed", ignore;
  std::uint32_t objects_from = 0;  ///< 0: objects are not scored apart

  /// Adds --truth-divide, --truth-from, --truth-ignore, --unlabelled, --objects-from.
  void declare(CLI::App& command);
  /// Completes `policy` from texts. \throws Error{Kind::Usage} bad text.
  void check();
};

/// Scores of labels, and of the objects among them.
struct ScoredLabels {
  LabelScores all;
  std::optional<ObjectScores> objects;
};

/// \param truth labels as the file has them. \throws as score_labels() and apply_policy().
ScoredLabels score(const TruthArguments& arguments, const std::vector<std::uint32_t>& predicted,
                   const std::vector<std::uint32_t>& truth);

}  // namespace planescope::cli
