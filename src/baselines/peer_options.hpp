// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "baselines/baselines.hpp"

/// \file The peers' options by name, as option_table() has ours.
namespace planescope {

/// The options of all peers. CPC's own LCCP stage takes those of `lccp`: CpcOptions::lccp is not
/// read.
struct PeerOptions {
  RansacOptions ransac;
  LccpOptions lccp;
  CpcOptions cpc;

  /// The peers' usual settings (those of PCL's example programs) but for lengths, which follow the
  /// scale of ours: voxels and supervoxels (or the grid of RANSAC) are patches.voxel_size and
  /// patches.patch_size; RANSAC's threshold is planes.sigma, its clusters' tolerance 8/3 voxels, as
  /// 2 cm is on a grid of 0.75 cm; its seed is planes.random_seed. At Options::tabletop() they are
  /// the usual settings.
  static PeerOptions at_scale(const Options& options);
};

/// A line of peer_option_table().
struct PeerOptionInfo {
  std::string name;     ///< `lccp.concavity_tolerance`
  std::string unit;     ///< as OptionInfo::unit
  std::string meaning;  ///< one line
};

/// Every option of every peer by name.
std::vector<PeerOptionInfo> peer_option_table();

/// Sets one by name. \throws Error{Kind::Usage} no such name, no such value, or out of range.
void set_peer_option(PeerOptions& options, std::string_view name, std::string_view value);

/// The settings that a method (`ransac`, `lccp`, `cpc`) reads, by name.
std::vector<std::pair<std::string, double>> peer_settings(const PeerOptions& options,
                                                          std::string_view method);

}  // namespace planescope
