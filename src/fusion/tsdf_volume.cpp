// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "fusion/carving.hpp"
#include "fusion/touched_blocks.hpp"
#include "fusion/voxel_field.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace fusion {

std::vector<const Block*> BlockMap::sorted() const {
  std::vector<const Block*> list;
  list.reserve(blocks_.size());
  for (const auto& block : blocks_) list.push_back(block.get());
  std::ranges::sort(list, {}, [](const Block* block) { return pack(block->key); });
  return list;
}

namespace {

/// One frame, ready to be fused into any block.
class Integrator {
 public:
  Integrator(const RangeImage& image, const ColorImage& color, const Eigen::Isometry3d& pose,
             const FusionOptions& options, std::uint32_t frame)
      : image_(image),
        color_(color),
        to_camera_(pose.inverse()),
        voxel_(options.voxel_size),
        truncation_(static_cast<float>(options.truncation)),
        frame_(frame) {}

  void integrate(Block& block) const {
    const Eigen::Vector3d corner =
        Eigen::Vector3d(block.key.x, block.key.y, block.key.z) * (kSide * voxel_);
    const Eigen::Vector3f step = (to_camera_.linear().col(0) * voxel_).cast<float>();
    bool changed = false;
    for (int z = 0; z < kSide; ++z) {
      for (int y = 0; y < kSide; ++y) {
        Eigen::Vector3f p =
            (to_camera_ * (corner + Eigen::Vector3d(0, y * voxel_, z * voxel_))).cast<float>();
        const auto row = static_cast<std::size_t>((std::ptrdiff_t{z} * kSide + y) * kSide);
        for (std::size_t x = 0; x < kSide; ++x, p += step) changed |= update(p, block, row + x);
      }
    }
    if (!changed) return;
    block.changed = frame_;
    block.behind = true;  // some voxel behind what it hit, but for the first one of a ray
  }

 private:
  /// Fuses what the frame saw of the voxel at `p`, in the camera's frame.
  bool update(const Eigen::Vector3f& p, Block& block, std::size_t voxel) const {
    if (!(p.z() > 0.01f)) return false;
    const PinholeCamera& lens = image_.lens;
    const float per_z = 1 / p.z();
    const float u = p.x() * per_z, v = p.y() * per_z;
    const float column = u * static_cast<float>(lens.fx) + static_cast<float>(lens.cx) + 0.5f;
    const float line = v * static_cast<float>(lens.fy) + static_cast<float>(lens.cy) + 0.5f;
    if (!(column >= 0 && line >= 0 && column < static_cast<float>(lens.width) &&
          line < static_cast<float>(lens.height))) {
      return false;
    }
    const std::size_t pixel =
        static_cast<std::size_t>(line) * lens.width + static_cast<std::size_t>(column);
    const float depth = image_.depth[pixel];
    if (depth == 0) return false;
    const float distance = (depth - p.z()) * std::sqrt(u * u + v * v + 1);
    if (distance < -truncation_) return false;
    const float weight = frame_weight(depth);
    const float sum = block.weight[voxel] + weight;
    const float truncated = std::min(1.0f, distance / truncation_);
    block.distance[voxel] += (truncated - block.distance[voxel]) * (weight / sum);
    block.weight[voxel] = sum;
    if (block.seen[voxel] < 255) ++block.seen[voxel];
    if (!color_.empty() && distance < truncation_)
      add_color(color_.pixels[pixel], weight, block, voxel);
    return true;
  }

  static void add_color(const Rgb& rgb, float weight, Block& block, std::size_t voxel) {
    const float sum = block.color_weight[voxel] + weight;
    const float share = weight / sum;
    auto& color = block.color[voxel];
    const auto blend = [&](std::uint16_t& old, std::uint8_t now) {
      const float mean = static_cast<float>(old);
      const float next = mean + (static_cast<float>(now) * 256 - mean) * share;
      // Not lround(): it is slower, and differs where `next` lies just below a half.
      // NOLINTNEXTLINE(bugprone-incorrect-roundings)
      old = static_cast<std::uint16_t>(next + 0.5f);
    };
    blend(color[0], rgb.r);
    blend(color[1], rgb.g);
    blend(color[2], rgb.b);
    block.color_weight[voxel] = sum;
  }

  const RangeImage& image_;
  const ColorImage& color_;
  Eigen::Isometry3d to_camera_;
  double voxel_;
  float truncation_;
  std::uint32_t frame_;
};

RangeImage to_metres(const DepthImage& depth, const DepthCamera& camera) {
  RangeImage image{camera.lens, std::vector<float>(depth.size())};
  std::ranges::transform(depth.values, image.depth.begin(), [&](std::uint16_t value) {
    return static_cast<float>(camera.depth(value));
  });
  return image;
}

void check(const DepthImage& depth, const ColorImage& color, const DepthCamera& camera) {
  const std::size_t pixels = std::size_t{camera.lens.width} * camera.lens.height;
  const bool same = depth.width == camera.lens.width && depth.height == camera.lens.height &&
                    depth.size() == pixels && pixels > 0;
  if (same && (color.empty() || (color.width == depth.width && color.pixels.size() == pixels))) {
    return;
  }
  throw Error(Error::Kind::Usage, "fusion: depth of " + std::to_string(depth.width) + " x " +
                                      std::to_string(depth.height) +
                                      " pixels; expected camera and colour of the same size");
}

}  // namespace
}  // namespace fusion

TsdfVolume::TsdfVolume(const FusionOptions& options) : field_(std::make_unique<Field>()) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw Error(Error::Kind::Usage, "fusion: " + what);
  };
  require(options.voxel_size >= 0.001 && options.voxel_size <= 1,
          "the voxel size is " + std::to_string(options.voxel_size) + " m; expected 0.001 to 1");
  field_->options = options;
  double& truncation = field_->options.truncation;
  if (truncation == 0) truncation = 4 * options.voxel_size;
  require(truncation >= 2 * options.voxel_size && truncation <= 100 * options.voxel_size,
          "the truncation is " + std::to_string(truncation) + " m; expected 2 to 100 voxels");
  require(
      options.min_observations <= 255,
      "min_observations is " + std::to_string(options.min_observations) + "; expected 0 to 255");
}

TsdfVolume::~TsdfVolume() = default;
TsdfVolume::TsdfVolume(TsdfVolume&&) noexcept = default;
TsdfVolume& TsdfVolume::operator=(TsdfVolume&&) noexcept = default;

void TsdfVolume::integrate(const DepthImage& depth, const ColorImage& color,
                           const DepthCamera& camera, const Eigen::Isometry3d& pose) {
  fusion::check(depth, color, camera);
  constexpr double kFar = 1000;  // [m] as read_cloud() has it
  if (field_->frames == 0 && pose.translation().cwiseAbs().maxCoeff() > kFar) {
    field_->origin = pose.translation().array().round();
  }
  const Eigen::Isometry3d local = Eigen::Translation3d(-field_->origin) * pose;
  const fusion::RangeImage image = fusion::to_metres(depth, camera);
  const FusionOptions& options = field_->options;
  const std::vector<std::uint64_t> keys =
      fusion::find_touched_blocks(image, local, options.voxel_size, options.truncation);
  std::vector<fusion::Block*> touched;
  touched.reserve(keys.size());
  for (const std::uint64_t key : keys) touched.push_back(&field_->blocks.make(key));
  const fusion::Integrator integrator(image, color, local, options, field_->frames);
  tbb::parallel_for(std::size_t{0}, touched.size(),
                    [&](std::size_t i) { integrator.integrate(*touched[i]); });
  fusion::carve(image, local, options, field_->frames, field_->blocks);
  ++field_->frames;
  field_->colored = field_->colored || !color.empty();
}

std::uint32_t TsdfVolume::frames() const noexcept { return field_->frames; }
std::size_t TsdfVolume::block_count() const noexcept { return field_->blocks.size(); }
const FusionOptions& TsdfVolume::options() const noexcept { return field_->options; }
const Eigen::Vector3d& TsdfVolume::origin() const noexcept { return field_->origin; }

std::vector<BlockKey> TsdfVolume::changed_since(std::uint32_t frame) const {
  std::vector<std::uint64_t> keys;
  for (const auto& block : field_->blocks.blocks()) {
    if (block->changed >= std::int64_t{frame}) keys.push_back(fusion::pack(block->key));
  }
  std::ranges::sort(keys);
  std::vector<BlockKey> changed;
  changed.reserve(keys.size());
  for (const std::uint64_t key : keys) changed.push_back(fusion::unpack(key));
  return changed;
}

}  // namespace planescope
