// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"

namespace planescope {
namespace {

using Mask = std::vector<char>;

// Both pixels of each pair of 4-neighbours whose labels differ, where both have truth.
Mask find_borders(std::span<const std::uint32_t> labels, std::span<const std::uint32_t> truth,
                  std::size_t width) {
  Mask border(labels.size(), 0);
  const auto compare = [&](std::size_t i, std::size_t j) {
    if (truth[i] != 0 && truth[j] != 0 && labels[i] != labels[j]) border[i] = border[j] = 1;
  };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if ((i + 1) % width != 0) compare(i, i + 1);
    if (i + width < labels.size()) compare(i, i + width);
  }
  return border;
}

// True where the mask has a pixel within `reach` columns and rows.
bool near_one(const Mask& mask, std::size_t width, std::size_t i, std::size_t reach) {
  const std::size_t rows = mask.size() / width, row = i / width, column = i % width;
  const std::size_t top = row - std::min(row, reach), bottom = std::min(rows - 1, row + reach);
  const std::size_t left = column - std::min(column, reach);
  const std::size_t right = std::min(width - 1, column + reach);
  for (std::size_t y = top; y <= bottom; ++y) {
    for (std::size_t x = left; x <= right; ++x) {
      if (mask[y * width + x] != 0) return true;
    }
  }
  return false;
}

// Share of the pixels of `of` that have one of `in` near.
double covered(const Mask& of, const Mask& in, std::size_t width, std::size_t reach) {
  std::uint64_t all = 0, near = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i] == 0) continue;
    ++all;
    near += near_one(in, width, i, reach) ? 1 : 0;
  }
  return all == 0 ? 1 : static_cast<double>(near) / static_cast<double>(all);
}

}  // namespace

BoundaryScores score_boundaries(std::span<const std::uint32_t> predicted,
                                std::span<const std::uint32_t> truth, std::uint32_t width,
                                std::uint32_t tolerance) {
  if (predicted.size() != truth.size() || width == 0 || truth.size() % width != 0) {
    throw Error(Error::Kind::Input, "boundary scores: " + std::to_string(predicted.size()) +
                                        " predicted and " + std::to_string(truth.size()) +
                                        " true labels in rows of " + std::to_string(width) +
                                        "; expected two images of the same size");
  }
  const Mask found = find_borders(predicted, truth, width);
  const Mask real = find_borders(truth, truth, width);
  return {covered(real, found, width, tolerance), covered(found, real, width, tolerance)};
}

}  // namespace planescope
