// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "planescope/graph_picture.hpp"

namespace CLI {
class App;
}

namespace planescope::cli {

/// How the graph is coloured, on the command line.
class GraphArguments {
 public:
  /// Adds --graph-color, --only and --truth-divide.
  void declare(CLI::App& command);

  /// The graph is to be drawn by render_graph().
  bool given() const { return !color_.empty() || !only_.empty(); }

  /// \throws Error{Kind::Usage} bad text.
  GraphOptions options() const;

  /// Labels of a truth with the parts of an object merged, as --truth-divide says.
  void merge(std::vector<std::uint32_t>& truth) const;

 private:
  std::string color_, only_;
  std::uint32_t divide_ = 1;
};

}  // namespace planescope::cli
