// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "fusion/voxel_field.hpp"
#include "io/state_stream.hpp"
#include "planescope/error.hpp"

/// \file A distance field as bytes: one section `volume` (io/state_stream.hpp) of
///   options: voxel_size, truncation (f64), min_observations (u32)
///   origin 3 f64; frames u32; colored u8
///   u64 count of blocks, in the order of their making, each:
///     key 3 i32; last frame that changed it i64; behind u8; 8 u64: the bits of its voxels that
///     hold anything; of these: lists of distances and weights (f32) and of frames seen (u8), and
///     where the field is coloured of colour weights (f32) and colours (3 u16 each)
namespace planescope {

using fusion::Block;
using fusion::kVoxels;

namespace {

constexpr std::uint32_t kVersion = 1;
constexpr const char* kName = "volume";
using Mask = std::array<std::uint64_t, kVoxels / 64>;

bool holds(const Mask& mask, std::size_t v) { return (mask[v / 64] >> (v % 64) & 1) != 0; }

Mask used_voxels(const Block& block) {
  Mask mask{};
  for (std::size_t v = 0; v < kVoxels; ++v) {
    const bool any = block.distance[v] != 0 || block.weight[v] != 0 || block.seen[v] != 0 ||
                     block.color_weight[v] != 0;
    if (any) mask[v / 64] |= std::uint64_t{1} << (v % 64);
  }
  return mask;
}

/// The values of the voxels in the mask, one after the other.
template <class T>
std::vector<T> packed(const std::array<T, kVoxels>& values, const Mask& mask) {
  std::vector<T> list;
  for (std::size_t v = 0; v < kVoxels; ++v) {
    if (holds(mask, v)) list.push_back(values[v]);
  }
  return list;
}

template <class T>
void unpack(io::StateReader& from, const Mask& mask, std::array<T, kVoxels>& values) {
  const std::vector<T> list = from.list<T>();
  std::size_t next = 0;
  for (std::size_t v = 0; v < kVoxels; ++v) {
    if (!holds(mask, v)) continue;
    from.require(next < list.size(), "a block with too few values");
    values[v] = list[next++];
  }
  from.require(next == list.size(), "a block with too many values");
}

void put_block(io::StateWriter& to, const Block& block, bool colored) {
  for (const std::int32_t part : {block.key.x, block.key.y, block.key.z}) to.put(part);
  to.put(block.changed);
  to.put<std::uint8_t>(block.behind ? 1 : 0);
  const Mask mask = used_voxels(block);
  for (const std::uint64_t word : mask) to.put(word);
  to.list(packed(block.distance, mask));
  to.list(packed(block.weight, mask));
  to.list(packed(block.seen, mask));
  if (!colored) return;
  to.list(packed(block.color_weight, mask));
  std::vector<std::uint16_t> colors;
  for (const auto& color : packed(block.color, mask)) {
    colors.insert(colors.end(), color.begin(), color.end());
  }
  to.list(colors);
}

void get_colors(io::StateReader& from, const Mask& mask, Block& block) {
  unpack(from, mask, block.color_weight);
  const std::vector<std::uint16_t> colors = from.list<std::uint16_t>();
  std::size_t next = 0;
  for (std::size_t v = 0; v < kVoxels; ++v) {
    if (!holds(mask, v)) continue;
    from.require(next + 3 <= colors.size(), "a block with too few colours");
    for (std::uint16_t& channel : block.color[v]) channel = colors[next++];
  }
  from.require(next == colors.size(), "a block with too many colours");
}

void get_block(io::StateReader& from, std::uint32_t frames, bool colored,
               fusion::BlockMap& blocks) {
  BlockKey key;
  for (std::int32_t* part : {&key.x, &key.y, &key.z}) {
    *part = from.get<std::int32_t>();
    from.require(*part > -fusion::kReach && *part < fusion::kReach, "a block out of reach");
  }
  from.require(blocks.find(key) == nullptr, "a block twice");
  Block& block = blocks.make(fusion::pack(key));
  block.changed = from.get<std::int64_t>();
  from.require(block.changed >= -1 && block.changed < std::int64_t{frames}, "a frame to come");
  block.behind = from.get<std::uint8_t>() != 0;
  Mask mask;
  for (std::uint64_t& word : mask) word = from.get<std::uint64_t>();
  unpack(from, mask, block.distance);
  unpack(from, mask, block.weight);
  unpack(from, mask, block.seen);
  const auto fits = [](float d) { return d >= -1 && d <= 1; };
  const auto counts = [](float w) { return w >= 0 && std::isfinite(w); };
  from.require(std::ranges::all_of(block.distance, fits), "a distance beyond the truncation");
  from.require(std::ranges::all_of(block.weight, counts), "a weight that is none");
  if (!colored) return;
  get_colors(from, mask, block);
  from.require(std::ranges::all_of(block.color_weight, counts), "a weight that is none");
}

}  // namespace

void TsdfVolume::write(std::ostream& stream) const {
  io::StateWriter to(stream, kName, kVersion);
  const Field& field = *field_;
  to.put(field.options.voxel_size);
  to.put(field.options.truncation);
  to.put(field.options.min_observations);
  for (int k = 0; k < 3; ++k) to.put(field.origin[k]);
  to.put(field.frames);
  to.put<std::uint8_t>(field.colored ? 1 : 0);
  to.put<std::uint64_t>(field.blocks.size());
  for (const auto& block : field.blocks.blocks()) put_block(to, *block, field.colored);
  to.finish();
}

TsdfVolume TsdfVolume::read(std::istream& stream, const std::string& name) try {
  io::StateReader from(stream, name, kName, kVersion);
  FusionOptions options;
  options.voxel_size = from.get<double>();
  options.truncation = from.get<double>();
  options.min_observations = from.get<std::uint32_t>();
  TsdfVolume volume(options);
  Field& field = *volume.field_;
  for (int k = 0; k < 3; ++k) field.origin[k] = from.get<double>();
  from.require(field.origin.allFinite(), "an origin that is no place");
  field.frames = from.get<std::uint32_t>();
  field.colored = from.get<std::uint8_t>() != 0;
  constexpr std::size_t kLeast = 12 + 8 + 1 + sizeof(Mask);  // [byte] of a block
  const std::size_t count = from.length(kLeast);
  for (std::size_t b = 0; b < count; ++b) {
    get_block(from, field.frames, field.colored, field.blocks);
  }
  from.finish();
  return volume;
} catch (const Error& error) {
  if (error.kind() == Error::Kind::Input) throw;
  throw Error(Error::Kind::Input, name + ": is damaged: " + error.what());
}

}  // namespace planescope
