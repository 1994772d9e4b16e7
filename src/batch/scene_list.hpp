// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file Which scenes a batch runs over, and which of them are a shard's.
namespace planescope {

/// A scene of a batch.
struct BatchScene {
  std::string name;  ///< unique within the batch; the name of its folder
  std::filesystem::path file;
  std::filesystem::path truth;         ///< cloud with true labels: `file` itself unless the list
                                       ///< names another
  std::filesystem::path truth_planes;  ///< `<file without ending>.truth.json`; empty: no such file
};

/// Scenes of arguments, in their order, each once. An argument is a cloud (*.pcd, *.ply), a glob
/// such as `views/*.pcd` (sorted by name), or a list: a line a scene, `SCENE` or `SCENE<tab>TRUTH`,
/// relative to the list's folder; `#` starts a comment. Scenes that are missing are kept: each
/// fails on its own.
/// \throws Error{Kind::Input} a list cannot be read; a glob or all arguments together name nothing.
std::vector<BatchScene> read_scenes(const std::vector<std::string>& arguments);

/// The part of a batch that one process does: scene k belongs to shard k mod count.
struct Shard {
  std::uint32_t index = 0, count = 1;

  bool has(std::size_t scene) const { return scene % count == index; }
  bool whole() const { return count == 1; }
};

/// `i/n`, 0 <= i < n. \throws Error{Kind::Usage} anything else.
Shard parse_shard(const std::string& text);

/// The shard that the environment assigns: SLURM_ARRAY_TASK_ID (with _MIN, _STEP and _COUNT), else
/// OMPI_COMM_WORLD_RANK (with _SIZE); else the whole.
/// \throws Error{Kind::Usage} they are set and make no shard.
Shard shard_from_environment();

}  // namespace planescope
