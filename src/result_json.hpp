// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "planescope/result.hpp"

namespace planescope {

/// The text of result.json (README, "The result folder"): everything that is the same in every run
/// of one version on one input with the same options; no time, no path, no thread count.
/// \param points_hash hash_file() of points.pcd, which ties the two files together.
std::string result_json(const Segmentation& scene, const PointCloud& cloud, const InputInfo& input,
                        const std::string& points_hash);

/// The same text with other files' hashes, by name.
std::string with_files(const std::string& result_json,
                       const std::map<std::string, std::string>& hashes);

/// Result::options_hash.
std::string options_hash(const Options& options, const MethodInfo& method);

}  // namespace planescope
