// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "palette.hpp"

/// \file Who gets which colour, so that what touches looks different to every reader.
namespace planescope::draw {

/// A pair of things that touch and must not look alike.
using Neighbours = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Gives each of `groups.size()` things a colour from its group's candidates (palettes[groups[i]]),
/// in order: the candidate that contrasts most with its neighbours' colours so far, and with all
/// others in use, for every reader; candidates that are listed first, or are used less, are
/// preferred by a little. Then those that look too much like a neighbour are given another one, in
/// view of all their neighbours.
/// \param given empty, or for each thing the colour that it has already: it keeps it, if it is one
/// of the candidates of any group.
std::vector<Pixel> assign_colors(const std::vector<std::size_t>& groups,
                                 const std::vector<std::vector<Pixel>>& palettes,
                                 const Neighbours& neighbours,
                                 const std::vector<std::optional<Pixel>>& given = {});

/// What a reader of any kind has least to go by: the least Oklab distance between the colours of
/// neighbours, for each kind of vision in the order of Vision. 1 without neighbours.
std::array<double, 5> least_differences(const std::vector<Pixel>& colors,
                                        const Neighbours& neighbours);

}  // namespace planescope::draw
