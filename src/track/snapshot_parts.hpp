// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "io/state_stream.hpp"
#include "planes/held_planes.hpp"
#include "track/tile.hpp"

/// \file Parts of a tracker's snapshot (snapshot.cpp says in which order), each written and read
/// back. What is read is untrusted: the readers throw Error{Kind::Input}, get_options() Kind::Usage
/// too.
namespace planescope::track {

/// 3 i32.
void put_key(io::StateWriter& to, const BlockKey& key);
BlockKey get_key(io::StateReader& from);

/// Lists of positions and normals (3 f32 each), and of colours (3 u8 each).
void put_cloud(io::StateWriter& to, const PointCloud& cloud);
PointCloud get_cloud(io::StateReader& from, const Eigen::Vector3d& origin);

/// u64 count, each: 4 f32, and u8 whether selected.
void put_planes(io::StateWriter& to, const std::vector<HeldPlane>& planes);
std::vector<HeldPlane> get_planes(io::StateReader& from);

/// Text of `name=value` lines of the engine; tile_size, change, share (f64); interval,
/// least_points, steady_after (u32).
void put_options(io::StateWriter& to, const TrackOptions& options);
TrackOptions get_options(io::StateReader& from);

/// u64 count of places, each: voxel (z, y, x) 3 i32, object u32.
void put_memory(io::StateWriter& to, const PlaceMemory& memory);
PlaceMemory get_memory(io::StateReader& from, std::uint32_t last_object);

/// u64 count of patches, each: u64 count of votes, each: object, points, steady (u32).
void put_votes(io::StateWriter& to, const std::vector<std::vector<Vote>>& votes);
std::vector<std::vector<Vote>> get_votes(io::StateReader& from, std::uint32_t last_object);

}  // namespace planescope::track
