// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/values.hpp"
#include "planescope/render.hpp"

namespace CLI {
class App;
}

/// \file How a picture is drawn, on the command line.
namespace planescope::cli {

/// All of RenderOptions as options of a subcommand.
class PictureArguments {
 public:
  void declare(CLI::App& command);

  /// What was given. Files that it names (--camera, --truth) are read.
  /// \throws Error{Kind::Usage} bad text; Error{Kind::Input} a file is missing or malformed.
  RenderOptions options() const;

 private:
  void declare_camera(CLI::App& command);
  void declare_colors(CLI::App& command);
  void declare_annotation(CLI::App& command);
  void apply_camera(CameraOptions& camera) const;

  CameraArguments view_;
  std::string layers_, background_, color_by_, palette_, fit_, focal_, cutaway_;
  std::filesystem::path camera_, truth_, colors_of_;
  std::optional<double> azimuth_, elevation_;
  RenderOptions drawn_;  // what CLI11 writes into as it is
  bool no_edl_ = false, no_cull_ = false;
};

}  // namespace planescope::cli
