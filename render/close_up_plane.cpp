// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "close_up.hpp"
#include "explain_words.hpp"
#include "palette.hpp"

/// \file The close-ups of a plane, and of a place without one.
namespace planescope {
namespace {

using draw::CloseUp;
using draw::PanelLine;
using draw::Pixel;
using Style = PanelLine::Style;

constexpr std::size_t kMostOutlines = 3, kMostFlips = 4, kMostPairs = 2;
constexpr std::array<Pixel, kMostOutlines> kOutlines = {
    {{21, 128, 161}, {126, 58, 180}, {67, 120, 45}}};
constexpr Pixel kFaint = {118, 121, 127};

/// The ball about some patches.
void frame(const StoredScene& stored, const std::vector<std::uint32_t>& patches, CloseUp& what) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t p : patches)
    box.extend(stored.scene.graph.patches[p].centroid.cast<double>());
  what.middle = box.center();
  what.radius = box.diagonal().norm() / 2 + 3 * static_cast<double>(stored.scene.graph.patch_size);
}

std::vector<std::uint32_t> inside(const StoredScene& stored,
                                  const std::vector<std::uint32_t>& patches, const CloseUp& what) {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t p : patches) {
    const Eigen::Vector3d c = stored.scene.graph.patches[p].centroid.cast<double>();
    if ((c - what.middle).norm() <= what.radius) found.push_back(p);
  }
  return found;
}

/// Those within the ball; the tag of the i-th outline is at another corner than those before.
void add_outline(const StoredScene& stored, const HypothesisReport& r, std::size_t i,
                 CloseUp& what) {
  draw::Sheet sheet =
      draw::outline(stored, r.hypothesis.plane, inside(stored, r.inliers, what), kOutlines[i]);
  if (sheet.corners.size() < 3) return;
  const std::size_t corner = sheet.corners.size() * i / kMostOutlines;
  what.tags.push_back({sheet.corners[corner], "hypothesis " + std::to_string(r.index)});
  what.sheets.push_back(std::move(sheet));
}

void add_pairs(std::vector<PanelLine>& panel, const HypothesisReport& r, std::size_t most) {
  for (std::size_t i = 0; i < std::min(most, r.pairs.size()); ++i)
    panel.push_back({pair_words(r.pairs[i]), Style::Small, draw::kInk});
}

void add_hypothesis(std::vector<PanelLine>& panel, const HypothesisReport& r, double lambda,
                    const Pixel& color, const std::string& note) {
  panel.push_back({"hypothesis " + std::to_string(r.index) + ": " +
                       (r.hypothesis.selected ? "selected" : "refused") +
                       (r.plane == kNone ? "" : " as plane " + std::to_string(r.plane)) + note,
                   Style::Swatch, color});
  panel.push_back(
      {hypothesis_words(r.hypothesis, lambda) + ", " + cost_words(r.hypothesis, PlaneRole::Support),
       Style::Small, draw::kInk});
  add_pairs(panel, r, kMostPairs);
}

void add_flips(std::vector<PanelLine>& panel, const std::vector<Flip>& flips,
               const std::string& what) {
  if (flips.empty()) return;
  panel.push_back({"", Style::Space, {}});
  panel.push_back({what, Style::Small, kFaint});
  for (std::size_t i = 0; i < std::min(kMostFlips, flips.size()); ++i) {
    panel.push_back({settings_words(flips[i].settings), Style::Plain, draw::kInk});
    panel.push_back({effect_words(flips[i]), Style::Small, draw::kInk});
  }
}

/// A ball about the patch that holds most of what grows from it: planes slice through other things
/// far away.
double reach(const StoredScene& stored, const MissingExplanation& x, double patch_size) {
  std::vector<double> distances;
  for (const std::uint32_t p : x.local_inliers)
    distances.push_back(static_cast<double>(
        (stored.scene.graph.patches[p].centroid - x.patch.patch.centroid).norm()));
  std::ranges::sort(distances);
  const double most = distances.empty() ? 0 : distances[distances.size() * 6 / 10];
  return std::clamp(1.4 * most, 8 * patch_size, 16 * patch_size);
}

std::vector<PanelLine> panel_of(const PlaneExplanation& x) {
  std::vector<PanelLine> panel;
  panel.push_back({"plane " + std::to_string(x.index), Style::Title, draw::kFirstPatch});
  panel.push_back({std::to_string(x.plane.patch_count) + " patches, " +
                       number(static_cast<double>(x.plane.area)) + " m^2, rms " +
                       length_words(static_cast<double>(x.plane.rms)),
                   Style::Strong, draw::kInk});
  panel.push_back({chosen_words(x), Style::Small, draw::kInk});
  add_pairs(panel, x.chosen, 3);
  std::string shares;
  for (std::size_t i = 0; i < std::min<std::size_t>(4, x.truth.size()); ++i) {
    const double percent = 100.0 * static_cast<double>(x.truth[i].points) /
                           std::max(1.0, static_cast<double>(x.plane.point_count));
    shares.append(shares.empty() ? "true objects on it: " : ", ");
    shares.append(x.truth[i].truth == 0 ? "none" : std::to_string(x.truth[i].truth));
    shares.append(" ").append(number(percent)).append(" %");
  }
  if (!shares.empty()) panel.push_back({shares, Style::Small, draw::kInk});
  panel.push_back({"", Style::Space, {}});
  if (x.plane.role == PlaneRole::Support)
    panel.push_back({x.beaten.empty() ? "it beat no hypothesis" : "it cost these their place",
                     Style::Small, kFaint});
  for (std::size_t i = 0; i < std::min(kMostOutlines, x.beaten.size()); ++i)
    add_hypothesis(panel, x.beaten[i], x.lambda, kOutlines[i], "");
  add_flips(panel, x.flips, "would not be there with");
  return panel;
}

std::vector<PanelLine> panel_of(const MissingExplanation& x) {
  std::vector<PanelLine> panel;
  panel.push_back({x.patch.plane == kNone ? "no plane here"
                                          : "plane " + std::to_string(x.patch.plane) + " is here",
                   Style::Title, draw::kInk});
  panel.push_back(
      {"patch " + std::to_string(x.patch.id) + ", " + length_words(x.distance) + " from the place",
       Style::Swatch, draw::kWrong});
  panel.push_back({patch_words(x.patch), Style::Small, draw::kInk});
  if (x.face != kNone)
    panel.push_back(
        {"no supporting plane, but face " + std::to_string(x.face), Style::Small, draw::kInk});
  panel.push_back({"", Style::Space, {}});
  if (x.local) {
    panel.push_back({"what grows from it: " + hypothesis_words(*x.local, x.lambda), Style::Swatch,
                     draw::kFirstPatch});
    if (x.local->inlier_count <= x.lambda)
      panel.push_back({"no more than lambda: D alone refuses it (planes.min_area)", Style::Strong,
                       draw::kWrong});
  } else {
    panel.push_back({"no plane grows from it", Style::Strong, draw::kWrong});
  }
  panel.push_back({x.near.empty() ? "no hypothesis has inliers near here" : "hypotheses near here",
                   Style::Small, kFaint});
  for (std::size_t i = 0; i < std::min(kMostOutlines, x.near.size()); ++i)
    add_hypothesis(panel, x.near[i], x.lambda, kOutlines[i],
                   x.holds[i] ? ", holds the patch" : ", does not hold it");
  add_flips(panel, x.flips, "would lie on a plane with");
  return panel;
}

}  // namespace

void draw_close_up(const StoredScene& stored, const PlaneExplanation& x,
                   const CloseUpOptions& options, const std::filesystem::path& png) {
  CloseUp what;
  std::vector<std::uint32_t> patches;
  for (std::uint32_t p = 0; p < stored.scene.patch_plane.size(); ++p) {
    if (stored.scene.plane_of(p) != static_cast<std::int32_t>(x.index)) continue;
    patches.push_back(p);
    what.patches[p] = draw::lighten(draw::kFirstPatch, 0.4);
  }
  frame(stored, patches, what);
  what.towards = x.plane.plane.normal.cast<double>();
  what.sheets.push_back(draw::outline(stored, x.plane.plane, patches, draw::kFirstPatch));
  for (std::size_t i = 0; i < std::min(kMostOutlines, x.beaten.size()); ++i)
    add_outline(stored, x.beaten[i], i, what);
  what.panel = panel_of(x);
  draw::draw(stored, what, options, png);
}

void draw_close_up(const StoredScene& stored, const MissingExplanation& x,
                   const CloseUpOptions& options, const std::filesystem::path& png) {
  CloseUp what;
  for (const std::uint32_t p : x.local_inliers)
    what.patches[p] = draw::lighten(draw::kFirstPatch, 0.35);
  what.patches[x.patch.id] = draw::kWrong;
  const Eigen::Vector3d normal = x.patch.patch.normal.cast<double>();
  const Eigen::Vector3d center = x.patch.patch.centroid.cast<double>();
  const double size = static_cast<double>(stored.scene.graph.patch_size);
  what.towards = normal;
  what.watched = {x.patch.id};
  what.middle = center;
  what.radius = reach(stored, x, size);
  what.solids.add_arrow(center + 2.4 * size * normal, center, 0.06 * size, draw::kWrong);
  what.tags.push_back({center + 3.3 * size * normal, "here"});
  if (x.local)
    what.sheets.push_back(draw::outline(stored, x.local->plane,
                                        inside(stored, x.local_inliers, what), draw::kFirstPatch));
  for (std::size_t i = 0; i < std::min(kMostOutlines, x.near.size()); ++i)
    add_outline(stored, x.near[i], i, what);
  what.panel = panel_of(x);
  draw::draw(stored, what, options, png);
}

}  // namespace planescope
