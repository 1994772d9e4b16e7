// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/voxel_blocks.hpp"

#include <algorithm>

namespace planescope {

BlockMap::BlockMap(std::size_t expected)
    : table_(std::bit_ceil(std::max<std::size_t>(64, expected * 2)), 0), mask_(table_.size() - 1) {
  keys_.reserve(expected);
}

std::size_t BlockMap::slot(std::uint64_t key) const {
  std::size_t at = (key * 0x9E3779B97F4A7C15ull >> 32) & mask_;
  while (table_[at] != 0 && keys_[table_[at] - 1] != key) at = (at + 1) & mask_;
  return at;
}

std::uint32_t BlockMap::insert(std::uint64_t key) {
  const std::size_t at = slot(key);
  if (table_[at] != 0) return table_[at] - 1;
  keys_.push_back(key);
  table_[at] = static_cast<std::uint32_t>(keys_.size());
  if (keys_.size() * 2 > table_.size()) grow();
  return static_cast<std::uint32_t>(keys_.size() - 1);
}

std::uint32_t BlockMap::find(std::uint64_t key) const {
  const std::uint32_t entry = table_[slot(key)];
  return entry == 0 ? kAbsent : entry - 1;
}

void BlockMap::grow() {
  table_.assign(table_.size() * 2, 0);
  mask_ = table_.size() - 1;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    table_[slot(keys_[i])] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace planescope
