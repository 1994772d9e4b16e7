// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "planescope/pipeline.hpp"

namespace CLI {
class App;
}

namespace planescope::cli {

/// All methods, ours last, as in the paper's figures.
const std::vector<std::string>& method_names();

/// \throws Error{Kind::Usage} no such method, or a peer in a program that was built without them.
void check_method(const std::string& option, const std::string& method);

/// `ransac,lccp,ours`: one or more, each once. \throws Error{Kind::Usage} as check_method().
std::vector<std::string> parse_methods(const std::string& option, const std::string& text);

/// The options of the peers, and the call of a method by name.
class MethodArguments {
 public:
  static constexpr const char* kGroup = "Options of the peers";

  /// Adds --peer-scale, and every option of peer_option_table() by its name.
  void declare(CLI::App& command);

  /// Checks every value, before anything is computed. \throws Error{Kind::Usage} a bad value.
  void check() const;

  /// Segments by `method`. \throws Error as segment() and peer_segmentation().
  Segmentation run(const std::string& method, const PointCloud& cloud, const Options& options,
                   const Progress& progress) const;

 private:
  struct Given {
    std::string name, text;
    bool seen = false;
  };

  std::string scale_ = "ours";
  std::deque<Given> given_;  ///< a deque: CLI11 keeps references to its elements
};

}  // namespace planescope::cli
