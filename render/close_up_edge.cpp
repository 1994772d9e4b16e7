// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "close_up.hpp"
#include "explain_words.hpp"
#include "palette.hpp"

/// \file The close-ups of an edge and of a chain.
namespace planescope {
namespace {

using draw::CloseUp;
using draw::PanelLine;
using draw::Pixel;
using Style = PanelLine::Style;

constexpr std::size_t kMostFlips = 4, kMostLinks = 8;
constexpr Pixel kFaint = {118, 121, 127};

double patch_size(const StoredScene& stored, const Patch& patch) {
  return static_cast<double>(stored.scene.graph.patch_size) * static_cast<double>(patch.scale);
}

Pixel state_color(bool on) { return on ? draw::kEdgeOn : draw::kEdgeOff; }

std::string state(const Edge& edge) { return edge.on ? "ON" : "OFF"; }

void add_patch_lines(std::vector<PanelLine>& panel, const PatchReport& r, const Pixel& color) {
  std::string text = "patch " + std::to_string(r.id) + ", segment " + std::to_string(r.segment);
  if (r.truth != 0) text += ", true object " + std::to_string(r.truth);
  panel.push_back({text, Style::Swatch, color});
  text = r.plane == kNone ? "on no plane" : "on plane " + std::to_string(r.plane);
  if (r.plane == kNone && r.nearest != kNone) text += ", nearest is " + std::to_string(r.nearest);
  if (r.nearest != kNone)
    text += ": " + length_words(r.distance) + " off of at most " + length_words(r.distance_limit);
  text += "; curvature " + number(static_cast<double>(r.patch.curvature));
  panel.push_back({text, Style::Small, draw::kInk});
}

/// What failed stands out only where the rule went by it.
void add_measures(std::vector<PanelLine>& panel, const std::vector<Measure>& measures) {
  panel.push_back({"", Style::Space, {}});
  panel.push_back({"measured (* decided)\tvalue\tON if", Style::Row, kFaint});
  for (const Measure& m : measures) {
    const std::string text = (m.decided ? "* " : "") + m.name + "\t" + with_unit(m.value, m.unit) +
                             (m.above ? "\tfrom " : "\tbelow ") + with_unit(m.threshold, m.unit);
    panel.push_back({text, Style::Row, !m.decided ? kFaint : m.holds ? draw::kInk : draw::kWrong});
  }
}

void add_flips(std::vector<PanelLine>& panel, const EdgeExplanation& x) {
  if (x.flips.empty()) return;
  panel.push_back({"", Style::Space, {}});
  panel.push_back(
      {std::string("would go ") + (x.edge.on ? "OFF" : "ON") + " with", Style::Small, kFaint});
  for (std::size_t i = 0; i < std::min(kMostFlips, x.flips.size()); ++i) {
    const Flip& flip = x.flips[i];
    panel.push_back({settings_words(flip.settings), Style::Plain, draw::kInk});
    panel.push_back({"then " + std::string(name(flip.rule)) + "; " + effect_words(flip),
                     Style::Small, draw::kInk});
  }
}

std::vector<PanelLine> panel_of(const EdgeExplanation& x) {
  std::vector<PanelLine> panel;
  panel.push_back({"edge " + std::to_string(x.edge.first) + " - " + std::to_string(x.edge.second) +
                       " is " + state(x.edge),
                   Style::Title, state_color(x.edge.on)});
  panel.push_back({"by " + std::string(name(x.edge.rule)) + ", margin " +
                       number(static_cast<double>(x.edge.margin), 2),
                   Style::Strong, draw::kInk});
  if (x.error == EdgeError::Merged)
    panel.push_back({"wrong: it joins two true objects", Style::Strong, draw::kWrong});
  if (x.error == EdgeError::Cut)
    panel.push_back({"wrong: it cuts inside one true object", Style::Strong, draw::kWrong});
  panel.push_back({"", Style::Space, {}});
  add_patch_lines(panel, x.first, draw::kFirstPatch);
  add_patch_lines(panel, x.second, draw::kSecondPatch);
  add_measures(panel, x.measures);
  add_flips(panel, x);
  return panel;
}

/// A square of a plane about the middle, where the plane passes near it.
void add_plane_sheet(const StoredScene& stored, std::int32_t index, CloseUp& what) {
  if (index == kNone) return;
  const Plane& plane = stored.scene.planes[static_cast<std::size_t>(index)].plane;
  const Eigen::Vector3d normal = plane.normal.cast<double>();
  const double off = plane.signed_distance(what.middle.cast<float>());
  if (std::abs(off) > 0.7 * what.radius) return;
  const Eigen::Vector3d foot = what.middle - off * normal;
  const Eigen::Vector3d u = normal.unitOrthogonal() * (0.6 * what.radius);
  const Eigen::Vector3d v = normal.cross(u);
  what.sheets.push_back(
      {{foot - u - v, foot + u - v, foot + u + v, foot - u + v}, normal, {110, 120, 150}});
  what.tags.push_back({foot - 0.9 * u - 0.9 * v, "plane " + std::to_string(index)});
}

void add_patch(const StoredScene& stored, const PatchReport& r, const Pixel& color,
               const Eigen::Vector3d& towards, CloseUp& what) {
  const double size = patch_size(stored, r.patch);
  const Eigen::Vector3d c = r.patch.centroid.cast<double>();
  const Eigen::Vector3d tip = c + 1.1 * size * r.patch.normal.cast<double>();
  what.patches[r.id] = color;
  what.solids.add_arrow(c, tip, 0.035 * size, draw::darken(color, 0.25));
  what.solids.add_ball(c + 0.05 * size * towards, 0.08 * size, draw::darken(color, 0.45));
  what.tags.push_back({tip + 0.18 * size * r.patch.normal.cast<double>(), std::to_string(r.id)});
}

/// What a chain's middle link says.
PanelLine link_line(const StoredScene& stored, std::size_t e) {
  const Edge& edge = stored.scene.edges[e];
  return {std::to_string(edge.first) + " - " + std::to_string(edge.second) + "  " + state(edge) +
              " by " + std::string(name(edge.rule)) + ", margin " +
              number(static_cast<double>(edge.margin), 2),
          Style::Swatch, state_color(edge.on)};
}

std::vector<PanelLine> panel_of(const StoredScene& stored, const Chain& chain) {
  const std::vector<std::size_t> deciding = deciding_edges(stored.scene, chain);
  std::vector<PanelLine> panel;
  panel.push_back({"patches " + std::to_string(chain.patches.front()) + " and " +
                       std::to_string(chain.patches.back()),
                   Style::Title, draw::kInk});
  panel.push_back({chain.joined ? "are joined: every chain has a link as weak as this one's weakest"
                   : chain.one_segment ? "are in one segment by segments.min_patches alone"
                                       : "are in two segments",
                   Style::Strong, draw::kInk});
  panel.push_back({std::to_string(chain.edges.size()) + " edges; " +
                       (chain.joined ? "weakest first:" : "those that are OFF:"),
                   Style::Small, kFaint});
  for (std::size_t i = 0; i < std::min(kMostLinks, deciding.size()); ++i)
    panel.push_back(link_line(stored, deciding[i]));
  return panel;
}

}  // namespace

void draw_close_up(const StoredScene& stored, const EdgeExplanation& x,
                   const CloseUpOptions& options, const std::filesystem::path& png) {
  CloseUp what;
  const Eigen::Vector3d a = x.first.patch.centroid.cast<double>();
  const Eigen::Vector3d b = x.second.patch.centroid.cast<double>();
  const double size =
      std::max(patch_size(stored, x.first.patch), patch_size(stored, x.second.patch));
  what.middle = (a + b) / 2;
  what.radius = std::max(2.7 * size, 1.5 * (a - b).norm());
  const Eigen::Vector3d sum = (x.first.patch.normal + x.second.patch.normal).cast<double>();
  what.towards = sum.norm() > 0.1 ? Eigen::Vector3d(sum.normalized())
                                  : Eigen::Vector3d(x.first.patch.normal.cast<double>());
  add_patch(stored, x.first, draw::kFirstPatch, what.towards, what);
  add_patch(stored, x.second, draw::kSecondPatch, what.towards, what);
  const Eigen::Vector3d lift = 0.12 * size * what.towards;
  what.solids.add_tube(a + lift, b + lift, 0.045 * size, state_color(x.edge.on));
  add_plane_sheet(stored, x.first.nearest, what);
  if (x.second.nearest != x.first.nearest) add_plane_sheet(stored, x.second.nearest, what);
  what.panel = panel_of(x);
  draw::draw(stored, what, options, png);
}

void draw_close_up(const StoredScene& stored, const Chain& chain, const CloseUpOptions& options,
                   const std::filesystem::path& png) {
  CloseUp what;
  const std::vector<Patch>& patches = stored.scene.graph.patches;
  Eigen::AlignedBox3d box;
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();
  for (const std::uint32_t p : chain.patches) {
    box.extend(patches[p].centroid.cast<double>());
    normals += patches[p].normal.cast<double>();
  }
  const double size = patch_size(stored, patches[chain.patches.front()]);
  what.middle = box.center();
  what.radius = box.diagonal().norm() / 2 + 2.5 * size;
  if (normals.norm() > 0.1) what.towards = normals.normalized();
  for (const std::uint32_t p : {chain.patches.front(), chain.patches.back()}) {
    what.patches[p] = p == chain.patches.front() ? draw::kFirstPatch : draw::kSecondPatch;
    what.tags.push_back(
        {patches[p].centroid.cast<double>() + 0.7 * size * what.towards, std::to_string(p)});
  }
  what.watched = chain.patches;
  const std::size_t weakest = deciding_edges(stored.scene, chain).front();
  const Eigen::Vector3d lift = 0.25 * size * what.towards;
  for (const std::size_t e : chain.edges) {
    const Edge& edge = stored.scene.edges[e];
    const Eigen::Vector3d a = patches[edge.first].centroid.cast<double>() + lift;
    const Eigen::Vector3d b = patches[edge.second].centroid.cast<double>() + lift;
    const Pixel color = edge.on && e == weakest ? draw::kWrong : state_color(edge.on);
    what.solids.add_tube(a, b, (e == weakest ? 0.14 : 0.07) * size, color);
    what.solids.add_ball(a, 0.1 * size, draw::kInk);
    what.solids.add_ball(b, 0.1 * size, draw::kInk);
    if (e == weakest)
      what.tags.push_back({(a + b) / 2 + 0.5 * size * what.towards,
                           "weakest: " + number(static_cast<double>(edge.margin), 2)});
  }
  what.panel = panel_of(stored, chain);
  draw::draw(stored, what, options, png);
}

}  // namespace planescope
