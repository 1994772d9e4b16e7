// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <unordered_map>

#include "fusion/surface_nets.hpp"
#include "fusion/voxel_field.hpp"
#include "io/ply_writer.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using fusion::Block;
using fusion::BlockSurface;
using fusion::kSide;

/// All blocks' surfaces, by key, and where each one's points start among all.
struct Surface {
  std::vector<const Block*> blocks;
  std::vector<BlockSurface> parts;
  std::vector<std::uint32_t> first;
};

Surface find_all(const fusion::BlockMap& map, double voxel_size, std::uint32_t least) {
  Surface surface;
  surface.blocks = map.sorted();
  surface.parts.resize(surface.blocks.size());
  tbb::parallel_for(std::size_t{0}, surface.blocks.size(), [&](std::size_t b) {
    surface.parts[b] = fusion::find_surface(map, *surface.blocks[b], voxel_size, least);
  });
  std::uint32_t points = 0;
  for (const BlockSurface& part : surface.parts) {
    surface.first.push_back(points);
    points += static_cast<std::uint32_t>(part.positions.size());
  }
  if (points > 0) return surface;
  throw Error(Error::Kind::Computation,
              "fusion: the frames make no surface; are the depth scale, the intrinsics and the "
              "poses (camera to world) right, and is --max-depth large enough?");
}

void append(const BlockSurface& part, bool colored, PointCloud& cloud) {
  cloud.positions.insert(cloud.positions.end(), part.positions.begin(), part.positions.end());
  cloud.normals.insert(cloud.normals.end(), part.normals.begin(), part.normals.end());
  if (colored) cloud.colors.insert(cloud.colors.end(), part.colors.begin(), part.colors.end());
}

PointCloud collect(const Surface& surface, bool colored, const Eigen::Vector3d& origin) {
  PointCloud cloud;
  cloud.origin = origin;
  for (const BlockSurface& part : surface.parts) append(part, colored, cloud);
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  return cloud;
}

/// Finds the vertex of a cell, given relative to a block, in whichever block it is.
class VertexFinder {
 public:
  explicit VertexFinder(const Surface& surface) : surface_(surface) {
    for (std::size_t b = 0; b < surface.blocks.size(); ++b) {
      place_.emplace(fusion::pack(surface.blocks[b]->key), b);
    }
  }

  /// \returns the vertex, or -1. \param cell may be -1 along each axis.
  std::int64_t find(std::size_t block, Eigen::Vector3i cell) const {
    BlockKey key = surface_.blocks[block]->key;
    if (cell.minCoeff() < 0) {
      if (cell.x() < 0) cell.x() += kSide, --key.x;
      if (cell.y() < 0) cell.y() += kSide, --key.y;
      if (cell.z() < 0) cell.z() += kSide, --key.z;
      const auto found = place_.find(fusion::pack(key));
      if (found == place_.end()) return -1;
      block = found->second;
    }
    const auto index = static_cast<std::uint16_t>((cell.z() * kSide + cell.y()) * kSide + cell.x());
    const auto& cells = surface_.parts[block].cells;
    const auto found = std::ranges::lower_bound(cells, index);
    if (found == cells.end() || *found != index) return -1;
    return surface_.first[block] + (found - cells.begin());
  }

 private:
  const Surface& surface_;
  std::unordered_map<std::uint64_t, std::size_t> place_;
};

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Two triangles across each edge of the grid that the surface crosses, between the four cells
/// around it.
Triangles join_block(const fusion::BlockMap& map, std::uint32_t least, const Surface& surface,
                     const VertexFinder& vertices, std::size_t block) {
  Triangles triangles;
  for (int index = 0; index < fusion::kVoxels; ++index) {
    const Eigen::Vector3i cell(index % kSide, index / kSide % kSide, index / (kSide * kSide));
    for (int axis = 0; axis < 3; ++axis) {
      const int sign = fusion::crossing(map, *surface.blocks[block], index, axis, least);
      if (sign == 0) continue;
      const Eigen::Vector3i b = Eigen::Vector3i::Unit((axis + 1) % 3);
      const Eigen::Vector3i c = Eigen::Vector3i::Unit((axis + 2) % 3);
      // Counter-clockwise about the axis.
      std::array<std::int64_t, 4> v = {vertices.find(block, cell - b - c),
                                       vertices.find(block, cell - c), vertices.find(block, cell),
                                       vertices.find(block, cell - b)};
      if (std::ranges::min(v) < 0) continue;
      if (sign < 0) std::swap(v[1], v[3]);
      const auto id = [&](std::size_t k) { return static_cast<std::uint32_t>(v[k]); };
      triangles.push_back({id(0), id(1), id(2)});
      triangles.push_back({id(0), id(2), id(3)});
    }
  }
  return triangles;
}

}  // namespace

PointCloud TsdfVolume::points() const {
  return collect(find_all(field_->blocks, field_->options.voxel_size, field_->least()),
                 field_->colored, field_->origin);
}

Mesh TsdfVolume::mesh() const {
  const Surface surface = find_all(field_->blocks, field_->options.voxel_size, field_->least());
  const VertexFinder vertices(surface);
  std::vector<Triangles> parts(surface.blocks.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t b) {
    parts[b] = join_block(field_->blocks, field_->least(), surface, vertices, b);
  });
  Mesh mesh{collect(surface, field_->colored, field_->origin), {}};
  for (const Triangles& part : parts) {
    mesh.triangles.insert(mesh.triangles.end(), part.begin(), part.end());
  }
  return mesh;
}

void write_mesh(const Mesh& mesh, const std::filesystem::path& ply) {
  io::write_ply(ply, mesh.vertices, mesh.triangles);
}

PointCloud TsdfVolume::block_points(const BlockKey& key) const {
  PointCloud cloud;
  cloud.origin = field_->origin;
  if (const Block* block = field_->blocks.find(key)) {
    append(
        fusion::find_surface(field_->blocks, *block, field_->options.voxel_size, field_->least()),
        field_->colored, cloud);
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  return cloud;
}

}  // namespace planescope
