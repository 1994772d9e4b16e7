// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "planescope/explain.hpp"

namespace planescope {

std::string number(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string length_words(double metres) {
  const double size = std::abs(metres);
  if (size < 0.0995) return number(metres * 1000) + " mm";
  return number(metres) + " m";
}

std::string with_unit(double value, const std::string& unit) {
  if (unit == "m") return length_words(value);
  return unit.empty() ? number(value) : number(value) + " " + unit;
}

std::string place_words(const Eigen::Vector3f& p) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "(%.3f, %.3f, %.3f)", static_cast<double>(p.x()),
                static_cast<double>(p.y()), static_cast<double>(p.z()));
  return text.data();
}

std::string settings_words(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& s : settings)
    text += (text.empty() ? "" : " and ") + s.option + " " + s.to + " (now " + s.from + ")";
  return text;
}

std::string effect_words(const Flip& flip) {
  return "in all " + counted(flip.switched_on, "edge") + " to ON, " +
         std::to_string(flip.switched_off) + " to OFF; " + counted(flip.planes, "plane") + ", " +
         counted(flip.segments, "segment");
}

std::string flip_words(const Flip& flip) {
  return settings_words(flip.settings) + ": then " + std::string(name(flip.rule)) + "; " +
         effect_words(flip);
}

std::string patch_words(const PatchReport& r) {
  std::string text = "patch " + std::to_string(r.id) + ": at " + place_words(r.patch.centroid) +
                     ", normal " + place_words(r.patch.normal) + ", curvature " +
                     number(static_cast<double>(r.patch.curvature)) + ", " +
                     std::to_string(r.patch.point_count) + " points, segment " +
                     std::to_string(r.segment);
  if (r.truth != 0) text += ", true object " + std::to_string(r.truth);
  if (r.plane != kNone) {
    text += ", on plane " + std::to_string(r.plane);
  } else {
    text += ", on no plane";
    if (r.nearest == kNone) return text + " (none has its direction)";
    text += "; nearest is plane " + std::to_string(r.nearest);
  }
  text += ", " + length_words(r.distance) + " off (limit " + length_words(r.distance_limit) +
          "), |n . n_p| " + number(r.normal_cosine);
  // It passes the normal gate, or would have no nearest plane.
  const bool fits = r.plane == kNone && r.distance < r.distance_limit;
  if (fits) text += "; it would fit, but its neighbours outvote it (planes.smoothness)";
  return text;
}

std::string measure_words(const Measure& m) {
  std::string text = (m.decided ? "* " : "  ") + m.name + " " + with_unit(m.value, m.unit) +
                     (m.above ? ", ON from " : ", ON up to ") + with_unit(m.threshold, m.unit);
  if (!m.option.empty()) text += " (" + m.option + ")";
  return text + (m.holds ? "" : ": fails");
}

std::string hypothesis_words(const PlaneHypothesis& h, double lambda) {
  const double gain = -h.data_cost;
  return std::to_string(h.inlier_count) + " inlier patches (" +
         number(static_cast<double>(h.inlier_area)) + " m^2; lambda " + number(lambda) + "), D " +
         number(-gain);
}

std::string cost_words(const PlaneHypothesis& h, PlaneRole role) {
  const char* what =
      role == PlaneRole::Face ? "with what it pays for the room " : "E with it minus E without it ";
  return what + number(h.flip_cost);
}

std::string chosen_words(const PlaneExplanation& x) {
  const bool is_face = x.plane.role == PlaneRole::Face;
  return (is_face ? "a face of an object (planes.face_area): no supporting plane has its patches, "
                    "and it cuts nothing: "
                  : "chosen as hypothesis " + std::to_string(x.chosen.index) + ": ") +
         hypothesis_words(x.chosen.hypothesis, x.lambda) + "; " +
         cost_words(x.chosen.hypothesis, x.plane.role);
}

std::string pair_words(const PairCost& pair) {
  std::string text = "V " + number(pair.cost()) + " with ";
  text += pair.plane == kNone ? "hypothesis " + std::to_string(pair.hypothesis)
                              : "plane " + std::to_string(pair.plane);
  return text + " (angle " + number(pair.angle_cost) + " for " + number(pair.angle) +
         " deg off parallel or orthogonal, overlap " + number(pair.overlap_cost) + ")";
}

std::string plane_words(const Plane& plane) {
  return "normal " + place_words(plane.normal) + ", distance " +
         length_words(static_cast<double>(plane.distance));
}

std::string patches_words(const Chain& chain) {
  std::string text;
  for (const std::uint32_t patch : chain.patches) text.append(" ").append(std::to_string(patch));
  return text;
}

std::string describe(const EdgeExplanation& x) {
  std::string text = x.words + "\n";
  if (x.error == EdgeError::Merged) text += "  WRONG: it joins two true objects\n";
  if (x.error == EdgeError::Cut) text += "  WRONG: it cuts inside one true object\n";
  text += "  " + patch_words(x.first) + "\n  " + patch_words(x.second) + "\n";
  text += "  measured (* decided):\n";
  for (const Measure& m : x.measures) text += "  " + measure_words(m) + "\n";
  const std::string other = x.edge.on ? "OFF" : "ON";
  if (x.flips.empty()) return text;
  text += "  would go " + other + " with:\n";
  for (const Flip& flip : x.flips) text += "    " + flip_words(flip) + "\n";
  return text;
}

std::string describe(const Segmentation& scene, const Chain& chain) {
  const auto ends =
      std::to_string(chain.patches.front()) + " and " + std::to_string(chain.patches.back());
  std::string text = "patches " + ends;
  if (chain.joined) {
    text += " are joined by a chain of " + std::to_string(chain.edges.size()) +
            " ON edges; every other chain has a link as weak. Weakest first:\n";
    return text + "  chain:" + patches_words(chain) + "\n";
  }
  const auto off = deciding_edges(scene, chain).size();
  text += chain.one_segment ? " are in one segment, but no chain of ON edges joins them: a speck "
                              "was put to its neighbour (segments.min_patches)"
                            : " are in two segments";
  return text + "; the easiest way from one to the other crosses " + std::to_string(off) +
         " OFF edges:\n  chain:" + patches_words(chain) + "\n";
}

std::string describe(const ErrorSummary& s) {
  const auto by_rule = [](const std::array<std::size_t, kEdgeRuleCount>& counts) {
    std::string text;
    for (std::size_t i = 0; i < kEdgeRuleCount; ++i) {
      if (counts[i] == 0) continue;
      text += (text.empty() ? " (" : ", ") + std::string(name(static_cast<EdgeRule>(i))) + " " +
              std::to_string(counts[i]);
    }
    return text.empty() ? text : text + ")";
  };
  const auto edges = [&](EdgeError error) {
    return std::to_string(s.edges[static_cast<std::size_t>(error)]);
  };
  const auto points = [&](PointError error) {
    return std::to_string(s.points[static_cast<std::size_t>(error)]);
  };
  return "edges ON across two true objects: " + edges(EdgeError::Merged) +
         by_rule(s.merged_by_rule) + "\nedges OFF inside one: " + edges(EdgeError::Cut) +
         by_rule(s.cut_by_rule) + ", of which " + std::to_string(s.harmless_cuts) +
         " did no harm\nedges right: " + edges(EdgeError::None) +
         ", not judged: " + edges(EdgeError::Unjudged) + "\npoints right " +
         points(PointError::None) + ", merged " + points(PointError::Merged) + ", split off " +
         points(PointError::Split) + ", missed " + points(PointError::Missed) +
         "; the worst edges:\n";
}

}  // namespace planescope
