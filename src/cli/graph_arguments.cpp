// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/graph_arguments.hpp"

#include <CLI/CLI.hpp>
#include <array>

#include "planescope/error.hpp"
#include "planescope/truth_errors.hpp"

namespace planescope::cli {

void GraphArguments::declare(CLI::App& command) {
  const std::string group = "The graph";
  command
      .add_option("--graph-color", color_,
                  "Draw the graph as tubes over faded points, coloured by state | rule | margin | "
                  "truth (with --truth)")
      ->type_name("WHAT")
      ->group(group);
  command
      .add_option("--only", only_,
                  "Only edges that are: off, on, rule=NAME, margin<X; joined by commas")
      ->type_name("WHICH")
      ->group(group);
  command
      .add_option("--truth-divide", divide_,
                  "True objects are label / N: merges the parts of one object")
      ->check(CLI::Range(1u, 1'000'000u))
      ->type_name("N")
      ->group(group);
}

GraphOptions GraphArguments::options() const {
  static constexpr std::array<std::pair<const char*, EdgeColor>, 4> kNames = {
      {{"state", EdgeColor::State},
       {"rule", EdgeColor::Rule},
       {"margin", EdgeColor::Margin},
       {"truth", EdgeColor::Truth}}};
  GraphOptions options;
  bool known = color_.empty();
  for (const auto& [name, value] : kNames) {
    if (color_ != name) continue;
    options.color = value;
    known = true;
  }
  if (!known)
    throw Error(Error::Kind::Usage,
                "--graph-color is `" + color_ + "`; it takes state | rule | margin | truth");
  if (!only_.empty()) options.only = parse_edge_filter(only_);
  return options;
}

void GraphArguments::merge(std::vector<std::uint32_t>& truth) const {
  truth = object_labels(std::move(truth), divide_);
}

}  // namespace planescope::cli
