// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/peer_options.hpp"

#include <charconv>
#include <cmath>
#include <functional>

#include "planescope/error.hpp"

namespace planescope {
namespace {

/// One option: its text, its range, and how to reach it.
struct Entry {
  PeerOptionInfo info;
  double low, high;
  std::function<double(const PeerOptions&)> get;
  std::function<void(PeerOptions&, double)> set;
};

/// `member` gives a reference to the option, of whatever type it is.
template <class Member>
Entry entry(const char* name, const char* unit, double low, double high, const char* meaning,
            Member member) {
  return {{name, unit, meaning},
          low,
          high,
          [member](const PeerOptions& all) { return static_cast<double>(member(all)); },
          [member](PeerOptions& all, double value) {
            auto& option = member(all);
            option = static_cast<std::remove_reference_t<decltype(option)>>(value);
          }};
}

std::vector<Entry> ransac_entries() {
  return {
      entry(
          "ransac.voxel_size", "m", 0, 10, "the cloud is thinned to voxel means; 0: not at all",
          [](auto& o) -> auto& { return o.ransac.voxel_size; }),
      entry(
          "ransac.threshold", "m", 1e-5, 10, "distance of a plane's inliers",
          [](auto& o) -> auto& { return o.ransac.threshold; }),
      entry(
          "ransac.min_plane_share", "1", 1e-6, 1, "a plane has this share of all voxels",
          [](auto& o) -> auto& { return o.ransac.min_plane_share; }),
      entry(
          "ransac.max_iterations", "count", 1, 1e7, "samples drawn for a plane, at most",
          [](auto& o) -> auto& { return o.ransac.max_iterations; }),
      entry(
          "ransac.cluster_tolerance", "m", 1e-5, 10, "points of a cluster chain within this",
          [](auto& o) -> auto& { return o.ransac.cluster_tolerance; }),
      entry(
          "ransac.min_cluster_size", "count", 1, 1e9, "smaller clusters stay unlabelled",
          [](auto& o) -> auto& { return o.ransac.min_cluster_size; }),
      entry(
          "ransac.random_seed", "count", 0, 1e15, "order in which voxels are offered to sampling",
          [](auto& o) -> auto& { return o.ransac.random_seed; }),
  };
}

std::vector<Entry> lccp_entries() {
  return {
      entry(
          "lccp.voxel_size", "m", 1e-4, 10, "edge of a voxel",
          [](auto& o) -> auto& { return o.lccp.patches.voxel_size; }),
      entry(
          "lccp.patch_size", "m", 1e-4, 100, "distance of the supervoxels' seeds",
          [](auto& o) -> auto& { return o.lccp.patches.patch_size; }),
      entry(
          "lccp.weight_color", "1", 0, 1000, "weight of colour",
          [](auto& o) -> auto& { return o.lccp.patches.weight_color; }),
      entry(
          "lccp.weight_spatial", "1", 0, 1000, "weight of distance",
          [](auto& o) -> auto& { return o.lccp.patches.weight_spatial; }),
      entry(
          "lccp.weight_normal", "1", 0, 1000, "weight of normals",
          [](auto& o) -> auto& { return o.lccp.patches.weight_normal; }),
      entry(
          "lccp.concavity_tolerance", "deg", 0, 180, "concave edges below it are ON",
          [](auto& o) -> auto& { return o.lccp.concavity_tolerance; }),
      entry(
          "lccp.smoothness_tolerance", "1", 0, 1000, "allowed step, in voxels",
          [](auto& o) -> auto& { return o.lccp.smoothness_tolerance; }),
      entry(
          "lccp.sanity_criterion", "flag", 0, 1, "patches that touch in one place are apart",
          [](auto& o) -> auto& { return o.lccp.sanity_criterion; }),
      entry(
          "lccp.convex_neighbours", "count", 0, 100, "k of extended convexity; 0: off",
          [](auto& o) -> auto& { return o.lccp.convex_neighbours; }),
      entry(
          "lccp.min_patches", "count", 0, 1e6, "segments of at most this many are merged",
          [](auto& o) -> auto& { return o.lccp.min_patches; }),
  };
}

std::vector<Entry> cpc_entries() {
  return {
      entry(
          "cpc.max_cuts", "count", 0, 1000, "levels of cutting",
          [](auto& o) -> auto& { return o.cpc.max_cuts; }),
      entry(
          "cpc.min_edges", "count", 0, 1e7, "segments with fewer edges are not cut",
          [](auto& o) -> auto& { return o.cpc.min_edges; }),
      entry(
          "cpc.min_score", "1", 0, 1, "a cut scores at least this",
          [](auto& o) -> auto& { return o.cpc.min_score; }),
      entry(
          "cpc.local", "flag", 0, 1, "a cut stays within its connected support",
          [](auto& o) -> auto& { return o.cpc.local; }),
      entry(
          "cpc.directed", "flag", 0, 1, "prefer cuts across the edges' direction",
          [](auto& o) -> auto& { return o.cpc.directed; }),
      entry(
          "cpc.clean", "flag", 0, 1, "cut only edges that the plane separates",
          [](auto& o) -> auto& { return o.cpc.clean; }),
      entry(
          "cpc.ransac_iterations", "count", 1, 1e8, "samples drawn for a cut",
          [](auto& o) -> auto& { return o.cpc.ransac_iterations; }),
  };
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> joined = ransac_entries();
    for (auto part : {lccp_entries(), cpc_entries()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

/// `0.01`, `1000000`: the shortest text.
std::string text_of(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

[[noreturn]] void refuse(const Entry& entry, std::string_view value) {
  const bool whole = entry.info.unit == "count" || entry.info.unit == "flag";
  throw Error(
      Error::Kind::Usage,
      entry.info.name + " is `" + std::string(value) + "`; it takes " +
          (whole ? "a whole number from " : "") + text_of(entry.low) + " to " +
          text_of(entry.high) +
          (entry.info.unit == "m" || entry.info.unit == "deg" ? " " + entry.info.unit : ""));
}

}  // namespace

PeerOptions PeerOptions::at_scale(const Options& options) {
  PeerOptions peers;
  const double voxel = options.patches.voxel_size;
  peers.ransac.cluster_tolerance *= voxel / peers.ransac.voxel_size;
  peers.ransac.voxel_size = voxel;
  peers.ransac.threshold = options.planes.sigma;
  peers.ransac.random_seed = options.planes.random_seed;
  peers.lccp.patches.voxel_size = voxel;
  peers.lccp.patches.patch_size = options.patches.patch_size;
  return peers;
}

std::vector<PeerOptionInfo> peer_option_table() {
  std::vector<PeerOptionInfo> table;
  for (const Entry& entry : entries()) table.push_back(entry.info);
  return table;
}

void set_peer_option(PeerOptions& options, std::string_view name, std::string_view value) {
  for (const Entry& entry : entries()) {
    if (entry.info.name != name) continue;
    double number = 0;
    const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool whole = entry.info.unit == "count" || entry.info.unit == "flag";
    if (failure != std::errc() || end != value.data() + value.size() ||
        !(number >= entry.low && number <= entry.high) || (whole && number != std::floor(number)))
      refuse(entry, value);
    entry.set(options, number);
    return;
  }
  throw Error(Error::Kind::Usage,
              "there is no peer option `" + std::string(name) + "`; see planescope segment --help");
}

std::vector<std::pair<std::string, double>> peer_settings(const PeerOptions& options,
                                                          std::string_view method) {
  std::vector<std::pair<std::string, double>> settings;
  for (const Entry& entry : entries()) {
    const std::string group = entry.info.name.substr(0, entry.info.name.find('.'));
    if (group == method || (group == "lccp" && method == "cpc"))
      settings.emplace_back(entry.info.name, entry.get(options));
  }
  return settings;
}

}  // namespace planescope
