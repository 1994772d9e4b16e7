// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "track/snapshot_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planescope::track {

void put_key(io::StateWriter& to, const BlockKey& key) {
  to.put(key.x);
  to.put(key.y);
  to.put(key.z);
}

BlockKey get_key(io::StateReader& from) {
  BlockKey key;
  key.x = from.get<std::int32_t>();
  key.y = from.get<std::int32_t>();
  key.z = from.get<std::int32_t>();
  constexpr std::int32_t kMost = 1 << 30;  // neighbours have keys too
  const auto inside = [](std::int32_t v) { return v > -kMost && v < kMost; };
  from.require(inside(key.x) && inside(key.y) && inside(key.z), "a key out of range");
  return key;
}

void put_cloud(io::StateWriter& to, const PointCloud& cloud) {
  to.list(cloud.positions);
  to.list(cloud.normals);
  to.list(cloud.colors);
}

PointCloud get_cloud(io::StateReader& from, const Eigen::Vector3d& origin) {
  PointCloud cloud;
  cloud.positions = from.list<Eigen::Vector3f>();
  cloud.normals = from.list<Eigen::Vector3f>();
  cloud.colors = from.list<Rgb>();
  const std::size_t count = cloud.positions.size();
  from.require(cloud.normals.size() == count, "not one normal a point");
  from.require(cloud.colors.empty() || cloud.colors.size() == count, "not one colour a point");
  from.require(count < 0x7fffffff, "too many points");
  constexpr float kFarthest = 1e9F;  // [m]
  const auto is_place = [](const Eigen::Vector3f& p) {
    return is_finite(p) && p.cwiseAbs().maxCoeff() <= kFarthest;
  };
  from.require(std::ranges::all_of(cloud.positions, is_place), "a point that is no place");
  cloud.origin = origin;
  cloud.width = static_cast<std::uint32_t>(count);
  return cloud;
}

void put_planes(io::StateWriter& to, const std::vector<HeldPlane>& planes) {
  to.put<std::uint64_t>(planes.size());
  for (const HeldPlane& held : planes) {
    to.put(held.plane.normal);
    to.put(held.plane.distance);
    to.put<std::uint8_t>(held.selected ? 1 : 0);
  }
}

std::vector<HeldPlane> get_planes(io::StateReader& from) {
  std::vector<HeldPlane> planes(from.length(4 * sizeof(float) + 1));
  for (HeldPlane& held : planes) {
    Plane& plane = held.plane;
    plane.normal = from.get<Eigen::Vector3f>();
    plane.distance = from.get<float>();
    held.selected = from.get<std::uint8_t>() != 0;
    from.require(std::abs(plane.normal.norm() - 1) < 1e-3f && std::isfinite(plane.distance),
                 "a plane without unit normal");
  }
  return planes;
}

void put_options(io::StateWriter& to, const TrackOptions& options) {
  std::string text;
  for (const OptionInfo& info : option_table()) {
    text += info.name + "=" + get_option(options.engine, info.name) + "\n";
  }
  to.text(text);
  for (const double value : {options.tile_size, options.change, options.share}) to.put(value);
  for (const std::uint32_t value : {options.interval, options.least_points, options.steady_after}) {
    to.put(value);
  }
}

TrackOptions get_options(io::StateReader& from) {
  TrackOptions options;
  const std::string text = from.text();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t sign = text.find('=', begin);
    from.require(sign < end, "an option without value");
    set_option(options.engine, text.substr(begin, sign - begin),
               text.substr(sign + 1, end - sign - 1));
    begin = end + 1;
  }
  for (double* value : {&options.tile_size, &options.change, &options.share}) {
    *value = from.get<double>();
  }
  for (std::uint32_t* value : {&options.interval, &options.least_points, &options.steady_after}) {
    *value = from.get<std::uint32_t>();
  }
  return options;
}

void put_memory(io::StateWriter& to, const PlaceMemory& memory) {
  std::vector<std::pair<VoxelKey, std::uint32_t>> places;
  for (const auto& [voxel, place] : memory) places.emplace_back(voxel, place.object);
  std::ranges::sort(places);
  to.put<std::uint64_t>(places.size());
  for (const auto& [voxel, object] : places) {
    for (const std::int32_t part : voxel) to.put(part);
    to.put(object);
  }
}

PlaceMemory get_memory(io::StateReader& from, std::uint32_t last_object) {
  PlaceMemory memory;
  const std::size_t count = from.length(16);
  for (std::size_t i = 0; i < count; ++i) {
    VoxelKey voxel;
    for (std::int32_t& part : voxel) part = from.get<std::int32_t>();
    const auto object = from.get<std::uint32_t>();
    from.require(object >= 1 && object <= last_object, "a place of no object");
    memory[voxel].object = object;
  }
  return memory;
}

void put_votes(io::StateWriter& to, const std::vector<std::vector<Vote>>& votes) {
  to.put<std::uint64_t>(votes.size());
  for (const std::vector<Vote>& own : votes) {
    to.put<std::uint64_t>(own.size());
    for (const Vote& vote : own) {
      for (const std::uint32_t part : {vote.object, vote.points, vote.steady}) to.put(part);
    }
  }
}

std::vector<std::vector<Vote>> get_votes(io::StateReader& from, std::uint32_t last_object) {
  std::vector<std::vector<Vote>> votes;
  for (std::size_t patches = from.length(8); patches > 0; --patches) {
    std::vector<Vote> own;
    for (std::size_t count = from.length(12); count > 0; --count) {
      Vote vote;
      for (std::uint32_t* part : {&vote.object, &vote.points, &vote.steady}) {
        *part = from.get<std::uint32_t>();
      }
      from.require(vote.object >= 1 && vote.object <= last_object, "a vote for no object");
      own.push_back(vote);
    }
    votes.push_back(std::move(own));
  }
  return votes;
}

}  // namespace planescope::track
