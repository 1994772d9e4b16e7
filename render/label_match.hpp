// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image.hpp"

/// \file Labels of the same points by two methods, or by a method and the truth: which ones mean
/// the same thing, so that it keeps its colour and its changes are told.
namespace planescope::draw {

/// Two labels that share points.
struct LabelPair {
  std::uint32_t first = 0, second = 0;
  double overlap = 0;  ///< |A n B| / |A u B|
};

/// Labels of `first` and of `second` matched one to one, those that overlap most before others (of
/// equals: the lower labels). 0 is no label. Sorted by `first`. Both spans are of one length.
std::vector<LabelPair> match_labels(std::span<const std::uint32_t> first,
                                    std::span<const std::uint32_t> second);

/// Colours for `labels` (index: label - 1): each that is matched with a label of `reference` has
/// that one's colour; the others have vivid ones in turn, those first that `reference` uses least.
std::vector<Pixel> matched_colors(std::span<const std::uint32_t> reference,
                                  const std::vector<Pixel>& reference_colors,
                                  std::span<const std::uint32_t> labels);

}  // namespace planescope::draw
