// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/render.hpp"

namespace CLI {
class App;
}

/// \file Values of command-line options from text. All throw Error{Kind::Usage} that names the
/// option, the value and what it takes.
namespace planescope::cli {

/// `X,Y,Z`
Eigen::Vector3d parse_vector(const std::string& option, const std::string& text);

/// `N,N,...`: labels.
std::vector<std::uint32_t> parse_labels(const std::string& option, const std::string& text);

/// `FX,FY,CX,CY` [pixel]: a pinhole camera's intrinsics.
std::array<double, 4> parse_intrinsics(const std::string& option, const std::string& text);

/// `TX,TY,TZ,QX,QY,QZ,QW`: camera to world, as in the trajectories of TUM RGB-D.
Eigen::Isometry3d parse_pose(const std::string& option, const std::string& text);

/// `WIDTHxHEIGHT`
std::array<int, 2> parse_size(const std::string& option, const std::string& text);

/// `white`, `black`, or `R,G,B` from 0 to 1
std::array<double, 3> parse_color(const std::string& option, const std::string& text);

/// `auto | iso | top | front | left | sensor`
View parse_view(const std::string& option, const std::string& text);

/// `scene`, `patches`, `segments`, `planes`, `graph`, joined by commas
Layer parse_layers(const std::string& option, const std::string& text);

/// --size, --view and --up: what every subcommand that draws takes.
struct CameraArguments {
  std::string size, view, up;

  void declare(CLI::App& command);
  /// Puts what was given into `options`. \throws Error{Kind::Usage} bad text.
  void apply(RenderOptions& options) const;
};

}  // namespace planescope::cli
