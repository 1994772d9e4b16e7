// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/pipeline.hpp"

/// \file The result folder: result.json, points.pcd here; patches.vtp, graph.vtp, planes.vtp in
/// render.hpp, where VTK writes them. Every number that is drawn is in the JSON first.
namespace planescope {

inline constexpr int kResultSchema = 1;  ///< version of result.json

/// What is said of the input in result.json.
struct InputInfo {
  std::string name;  ///< file name, without folders
  std::string hash;  ///< of the file's bytes, hexadecimal (hash_file())
};

/// 64-bit FNV-1a over the file's bytes in 8-byte steps, as 16 hexadecimal digits: tells inputs
/// apart, not for security. \throws Error{Kind::Input} the file cannot be read.
std::string hash_file(const std::filesystem::path& file);

/// The same hash of a text.
std::string hash_text(std::string_view text);

/// Writes result.json and points.pcd (`x y z rgb label plane patch`, the input's points in its
/// order) into `folder`, which is made where it is missing. Each file appears whole or not at all.
/// \throws Error{Kind::Input} the folder cannot be made or written.
void save(const Segmentation& scene, const PointCloud& cloud, const std::filesystem::path& folder,
          const InputInfo& input = {});

/// Ties files that were put beside result.json to it: their hashes go into it as `files`, and who
/// reads them back can tell that they are whole and of this result (check_file()).
/// \throws Error{Kind::Input} result.json or one of the files cannot be read or written.
void add_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// A stored result as drawing and scoring need it.
struct Result {
  MethodInfo method;
  PointCloud cloud;                        ///< positions, colours; organised as the input was
  bool has_colors = false;                 ///< the input had colours of its own
  std::vector<std::uint32_t> point_label;  ///< per point: segment label, or kNoSegment
  std::vector<std::int32_t> point_plane;   ///< per point: plane, or kNone
  std::vector<std::int32_t> point_patch;   ///< per point: patch, or kNone
  std::vector<SupportingPlane> planes;
  std::vector<Segment> segments;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::vector<std::size_t> rule_counts;  ///< edges by rule, indexed by EdgeRule
  std::size_t patch_count = 0;
  std::string input_name;
  std::string input_hash;    ///< InputInfo::hash
  std::string options_hash;  ///< hash_text() of the options as result.json has them, keys sorted
  double voxel_size = 0, patch_size = 0;           ///< [m]
  Options options;                                 ///< that made it; of a peer the scale only
  PlaneSelection selection;                        ///< hypotheses; empty where the method has none
  std::map<std::string, std::string> file_hashes;  ///< by name, of add_files(); not in memory
};

/// The same view of a result that is still in memory.
Result make_result(const Segmentation& scene, const PointCloud& cloud, const InputInfo& input = {});

/// \throws Error{Kind::Input} result.json tells of `name`, and it is not the file in `folder`.
void check_file(const Result& result, const std::filesystem::path& folder, const std::string& name);

/// Reads result.json and points.pcd back. The folder is untrusted: every index is checked.
/// \throws Error{Kind::Input} missing, malformed, of another schema version, or files that do not
/// belong together.
Result load_result(const std::filesystem::path& folder);

}  // namespace planescope
