// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/truth_arguments.hpp"

#include <CLI/CLI.hpp>

#include "cli/values.hpp"
#include "planescope/error.hpp"

namespace planescope::cli {

void TruthArguments::declare(CLI::App& command) {
  command
      .add_option("--truth-divide", policy.divide,
                  "True objects are label / N: merges the parts of one object")
      ->check(CLI::Range(1u, 1'000'000u))
      ->type_name("N")
      ->group(kGroup);
  command.add_option("--truth-from", policy.from, "Count only true labels from N up")
      ->type_name("N")
      ->group(kGroup);
  command.add_option("--truth-ignore", ignore, "True labels that do not count, besides 0")
      ->type_name("N,N,...")
      ->group(kGroup);
  command
      .add_option("--unlabelled", unlabelled,
                  "Points in no segment: missed (never match, count in their region) | ignored")
      ->capture_default_str()
      ->type_name("NAME")
      ->group(kGroup);
  command
      .add_option("--objects-from", objects_from,
                  "Score the regions with true labels from N up apart too")
      ->check(CLI::PositiveNumber)
      ->type_name("N")
      ->group(kGroup);
}

void TruthArguments::check() {
  if (!ignore.empty()) policy.ignore = parse_labels("--truth-ignore", ignore);
  if (unlabelled != "missed" && unlabelled != "ignored") {
    throw Error(Error::Kind::Usage,
                "--unlabelled is `" + unlabelled + "`; it takes missed | ignored");
  }
  policy.unlabelled =
      unlabelled == "missed" ? TruthPolicy::Unlabelled::Missed : TruthPolicy::Unlabelled::Ignored;
}

ScoredLabels score(const TruthArguments& arguments, const std::vector<std::uint32_t>& predicted,
                   const std::vector<std::uint32_t>& truth) {
  const auto counted = apply_policy(predicted, truth, arguments.policy);
  ScoredLabels scores{score_labels(predicted, counted), {}};
  if (arguments.objects_from > 0) {
    scores.objects = score_objects(scores.all, arguments.objects_from, arguments.policy.divide);
  }
  return scores;
}

}  // namespace planescope::cli
