// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/truth_arguments.hpp"
#include "planescope/stored_scene.hpp"

namespace CLI {
class App;
}

/// \file What `planescope explain` is asked.
namespace planescope::cli {

/// One question, and the truth that it may be asked in view of.
class Question {
 public:
  enum class Kind { Edge, Segment, Between, Near, Weakest, Wrong, Plane, Missing };

  void declare(CLI::App& command);

  /// \throws Error{Kind::Usage} no question, more than one, or bad text.
  void check();

  Kind kind() const { return kind_; }
  std::size_t count() const { return count_; }
  bool seeks_flips() const { return !no_flips_; }

  /// --edge I,J, or two patches of --between, or --segment K, --plane K as the first.
  std::pair<std::uint32_t, std::uint32_t> numbers() const { return numbers_; }

  /// X,Y,Z of --near, --missing, or of the ends of --between, relative to the scene's origin.
  Eigen::Vector3f place(const StoredScene& stored, std::size_t end = 0) const;
  bool between_places() const { return !places_.empty(); }

  /// True labels of the scene's points: each the lowest label that the file may have for that
  /// object. Empty where none were given. \throws Error{Kind::Input} see read_cloud().
  std::vector<std::uint32_t> truth(const StoredScene& stored) const;

 private:
  void parse_between();

  Kind kind_ = Kind::Edge;
  std::string edge_, between_, near_, missing_;
  std::optional<std::uint32_t> segment_, plane_, weakest_, wrong_;
  std::filesystem::path truth_;
  TruthArguments policy_;
  std::size_t count_ = 10;
  bool no_flips_ = false;
  std::pair<std::uint32_t, std::uint32_t> numbers_{0, 0};
  std::vector<Eigen::Vector3d> places_;
};

}  // namespace planescope::cli
