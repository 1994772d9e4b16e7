// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "color_assignment.hpp"

#include <algorithm>
#include <limits>

namespace planescope::draw {
namespace {

constexpr double kAlike = 0.06;  // Oklab: below it two areas that touch are taken for one

/// Contrast of every two candidates, all palettes in one list.
struct Contrasts {
  explicit Contrasts(const std::vector<std::vector<Pixel>>& palettes) {
    for (const auto& palette : palettes) {
      first.push_back(colors.size());
      colors.insert(colors.end(), palette.begin(), palette.end());
    }
    first.push_back(colors.size());
    for (std::size_t a = 0; a < colors.size(); ++a)
      for (std::size_t b = 0; b < colors.size(); ++b)
        pairs.push_back(
            {contrast(colors[a], colors[b]), difference(colors[a], colors[b], Vision::Normal)});
  }
  struct Pair {
    double worst, normal;
  };
  const Pair& operator()(std::size_t a, std::size_t b) const {
    return pairs[a * colors.size() + b];
  }

  std::vector<Pixel> colors;
  std::vector<std::size_t> first;  // of each palette, and the end
  std::vector<Pair> pairs;
};

/// How well a candidate suits a thing whose neighbours have these colours.
double suitability(std::size_t candidate, const Contrasts& contrasts,
                   const std::vector<std::size_t>& neighbours, const std::vector<int>& uses) {
  constexpr double kEnough = 0.30;  // beyond it two colours are different, and that is all
  double nearest = 2 * kEnough, worst = kEnough, normal = kEnough;
  for (const std::size_t color : neighbours) {
    const Contrasts::Pair& pair = contrasts(candidate, color);
    // Too alike for one kind of reader counts more than any liking.
    nearest = std::min(nearest, pair.worst + pair.normal - 8 * std::max(0.0, kAlike - pair.worst));
  }
  for (std::size_t color = 0; color < uses.size(); ++color) {
    if (uses[color] == 0) continue;
    worst = std::min(worst, contrasts(candidate, color).worst);
    normal = std::min(normal, contrasts(candidate, color).normal);
  }
  return nearest + 0.2 * worst + 0.6 * normal - 0.02 * uses[candidate];
}

/// The least contrast of a candidate with its neighbours' colours.
double least_contrast(const Contrasts& contrasts, std::size_t candidate,
                      const std::vector<std::size_t>& neighbours) {
  double least = 1;
  for (const std::size_t color : neighbours)
    least = std::min(least, contrasts(candidate, color).worst);
  return least;
}

/// The candidate of a group that suits best.
std::size_t best_candidate(const Contrasts& contrasts, std::size_t group,
                           const std::vector<std::size_t>& neighbours,
                           const std::vector<int>& uses) {
  constexpr double kLater = 0.004;  // candidates are listed best first
  double best = -std::numeric_limits<double>::infinity();
  std::size_t chosen = contrasts.first[group];
  for (std::size_t c = contrasts.first[group]; c < contrasts.first[group + 1]; ++c) {
    const double value = suitability(c, contrasts, neighbours, uses) -
                         kLater * static_cast<double>(c - contrasts.first[group]);
    if (value > best) {
      best = value;
      chosen = c;
    }
  }
  return chosen;
}

/// The assignment, as it grows.
class Coloring {
 public:
  Coloring(const std::vector<std::size_t>& groups, const std::vector<std::vector<Pixel>>& palettes,
           const Neighbours& neighbours)
      : groups_(groups),
        contrasts_(palettes),
        chosen_(groups.size(), kNoColor),
        kept_(groups.size(), false),
        uses_(contrasts_.colors.size(), 0),
        adjacent_(groups.size()) {
    for (const auto& [a, b] : neighbours) {
      adjacent_[a].push_back(b);
      adjacent_[b].push_back(a);
    }
  }

  /// Colours that things have already and keep.
  void keep(const std::vector<std::optional<Pixel>>& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto& all = contrasts_.colors;
      const auto found = given[i] ? std::find(all.begin(), all.end(), *given[i]) : all.end();
      if (found == all.end()) continue;
      chosen_[i] = static_cast<std::size_t>(found - all.begin());
      ++uses_[chosen_[i]];
      kept_[i] = true;
    }
  }

  /// The others, in order.
  void fill() {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (kept_[i]) continue;
      chosen_[i] = best_candidate(contrasts_, groups_[i], around(i), uses_);
      ++uses_[chosen_[i]];
    }
  }

  /// Another colour for those that look too much like a neighbour.
  void mend() {
    for (std::size_t i = groups_.size(); i-- > 0;) {  // the smallest first: they have more freedom
      const std::vector<std::size_t> colors = around(i);
      if (kept_[i] || least_contrast(contrasts_, chosen_[i], colors) > kAlike) continue;
      --uses_[chosen_[i]];
      const std::size_t other = best_candidate(contrasts_, groups_[i], colors, uses_);
      if (least_contrast(contrasts_, other, colors) >
          least_contrast(contrasts_, chosen_[i], colors))
        chosen_[i] = other;
      ++uses_[chosen_[i]];
    }
  }

  /// For those that still look too much like a neighbour: a colour that one neighbour alone is in
  /// the way of, if that one finds another.
  void mend_pairs() {
    for (std::size_t i = groups_.size(); i-- > 0;) {
      if (kept_[i] || least_contrast(contrasts_, chosen_[i], around(i)) > kAlike) continue;
      const std::size_t group = groups_[i];
      for (std::size_t c = contrasts_.first[group]; c < contrasts_.first[group + 1]; ++c)
        if (make_room(i, c)) break;
    }
  }

  std::vector<Pixel> colors() const {
    std::vector<Pixel> colors;
    for (const std::size_t c : chosen_) colors.push_back(contrasts_.colors[c]);
    return colors;
  }

 private:
  void recolor(std::size_t i, std::size_t color) {
    --uses_[chosen_[i]];
    ++uses_[color];
    chosen_[i] = color;
  }

  /// Gives the colour to `i` and another one to the neighbour that is in its way. \returns false,
  /// and changes nothing, if there are several or it finds none.
  bool make_room(std::size_t i, std::size_t color) {
    std::optional<std::size_t> other;
    for (const std::uint32_t neighbour : adjacent_[i]) {
      if (neighbour == i || contrasts_(color, chosen_[neighbour]).worst > kAlike) continue;
      if (kept_[neighbour] || (other && *other != neighbour)) return false;
      other = neighbour;
    }
    if (!other) return false;  // mend() has seen it
    const std::size_t before = chosen_[i];
    recolor(i, color);
    const std::vector<std::size_t> colors = around(*other);
    const std::size_t found = best_candidate(contrasts_, groups_[*other], colors, uses_);
    if (least_contrast(contrasts_, found, colors) > kAlike) {
      recolor(*other, found);
      return true;
    }
    recolor(i, before);
    return false;
  }

  static constexpr std::size_t kNoColor = std::numeric_limits<std::size_t>::max();

  /// Colours of the neighbours that have one, each once.
  std::vector<std::size_t> around(std::size_t i) const {
    std::vector<std::size_t> colors;
    for (const std::uint32_t other : adjacent_[i])
      if (other != i && chosen_[other] != kNoColor) colors.push_back(chosen_[other]);
    std::sort(colors.begin(), colors.end());
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
    return colors;
  }

  const std::vector<std::size_t>& groups_;
  Contrasts contrasts_;
  std::vector<std::size_t> chosen_;
  std::vector<bool> kept_;
  std::vector<int> uses_;
  std::vector<std::vector<std::uint32_t>> adjacent_;
};

}  // namespace

std::vector<Pixel> assign_colors(const std::vector<std::size_t>& groups,
                                 const std::vector<std::vector<Pixel>>& palettes,
                                 const Neighbours& neighbours,
                                 const std::vector<std::optional<Pixel>>& given) {
  Coloring coloring(groups, palettes, neighbours);
  coloring.keep(given);
  coloring.fill();
  for (int sweep = 0; sweep < 3; ++sweep) coloring.mend();
  for (int sweep = 0; sweep < 3; ++sweep) coloring.mend_pairs();
  return coloring.colors();
}

std::array<double, 5> least_differences(const std::vector<Pixel>& colors,
                                        const Neighbours& neighbours) {
  std::array<double, 5> least{1, 1, 1, 1, 1};
  for (const auto& [a, b] : neighbours)
    for (std::size_t v = 0; v < kVisions.size(); ++v)
      least[v] = std::min(least[v], difference(colors[a], colors[b], kVisions[v]));
  return least;
}

}  // namespace planescope::draw
