// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "explain_words.hpp"

/// \file Planes, chosen and missing, in words.
namespace planescope {
namespace {

constexpr std::size_t kMost = 6;  // lines of one kind; the JSON has all

std::string more(std::size_t count, const std::string& what) {
  return count > kMost ? "    and " + std::to_string(count - kMost) + " more " + what + "\n" : "";
}

std::string pairs_words(const std::vector<PairCost>& pairs) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, pairs.size()); ++i)
    text += "    " + pair_words(pairs[i]) + "\n";
  return text + more(pairs.size(), "pairs");
}

std::string flips_words(const std::vector<Flip>& flips) {
  std::string text;
  for (const Flip& flip : flips)
    text += "    " + settings_words(flip.settings) + ": " + effect_words(flip) + "\n";
  return text;
}

std::string beaten_words(const PlaneExplanation& x) {
  if (x.beaten.empty()) return "";
  std::string text = "  it cost these hypotheses most:\n";
  for (std::size_t i = 0; i < std::min(kMost, x.beaten.size()); ++i) {
    const PlaneHypothesis& h = x.beaten[i].hypothesis;
    text += "    hypothesis " + std::to_string(x.beaten[i].index) + ", " + plane_words(h.plane) +
            ": " + hypothesis_words(h, x.lambda) + ", V with this plane " +
            number(h.blocked_angle_cost) + " angle + " + number(h.blocked_overlap_cost) +
            " overlap\n";
  }
  return text + more(x.beaten.size(), "hypotheses");
}

std::string truth_words(const PlaneExplanation& x) {
  if (x.truth.empty()) return "";
  std::string text = "  on it lie, by true object:";
  for (std::size_t i = 0; i < std::min(kMost, x.truth.size()); ++i) {
    const ObjectShare& share = x.truth[i];
    const double percent = 100.0 * static_cast<double>(share.points) /
                           std::max(1.0, static_cast<double>(x.plane.point_count));
    text.append(" ").append(share.truth == 0 ? "none" : std::to_string(share.truth));
    text.append(" ").append(number(percent)).append(" %,");
  }
  text.back() = '\n';
  return text + more(x.truth.size(), "objects");
}

std::string local_words(const MissingExplanation& x) {
  if (!x.local)
    return "  no plane grows from this patch: what lies in its plane is mostly no surface\n";
  std::string text = "  the plane that grows from this patch: " + plane_words(x.local->plane) +
                     "; " + hypothesis_words(*x.local, x.lambda) + "\n";
  if (x.local->inlier_count <= x.lambda)
    text += "    that is no more than lambda: D alone refuses it (planes.min_area)\n";
  return text;
}

std::string near_words(const MissingExplanation& x) {
  if (x.near.empty()) return "  no hypothesis has inliers near here\n";
  std::string text = "  hypotheses near here:\n";
  for (std::size_t i = 0; i < std::min(kMost, x.near.size()); ++i) {
    const HypothesisReport& r = x.near[i];
    text += "  hypothesis " + std::to_string(r.index) + ", " + plane_words(r.hypothesis.plane) +
            (x.holds[i] ? ", holds the patch: " : ", does not hold the patch: ") +
            (r.hypothesis.selected ? "selected" : "refused") +
            (r.plane == kNone ? "" : " as plane " + std::to_string(r.plane)) + "; " +
            hypothesis_words(r.hypothesis, x.lambda) + ", " +
            cost_words(r.hypothesis, PlaneRole::Support) + "\n" + pairs_words(r.pairs);
  }
  return text + more(x.near.size(), "hypotheses");
}

}  // namespace

std::string describe(const PlaneExplanation& x) {
  std::string text = "plane " + std::to_string(x.index) + ": " + plane_words(x.plane.plane) + "; " +
                     std::to_string(x.plane.patch_count) + " patches, " +
                     std::to_string(x.plane.point_count) + " points, " +
                     number(static_cast<double>(x.plane.area)) + " m^2, rms " +
                     length_words(static_cast<double>(x.plane.rms)) + "\n";
  text += "  " + chosen_words(x) + "\n";
  text += x.chosen.pairs.empty() ? "  it pays for no other plane\n"
                                 : "  it pays for others:\n" + pairs_words(x.chosen.pairs);
  text += beaten_words(x) + truth_words(x);
  if (!x.flips.empty()) text += "  would not be there with:\n" + flips_words(x.flips);
  return text;
}

std::string describe(const MissingExplanation& x) {
  std::string text = "at " + place_words(x.place) + ", " + length_words(x.distance) +
                     " from the nearest patch\n  " + patch_words(x.patch) + "\n";
  if (x.patch.plane != kNone)
    text += "  so there is a plane: ask --plane " + std::to_string(x.patch.plane) + "\n";
  if (x.face != kNone)
    text += "  no supporting plane, but a face: ask --plane " + std::to_string(x.face) + "\n";
  text += local_words(x) + near_words(x);
  if (!x.flips.empty()) text += "  would lie on a plane with:\n" + flips_words(x.flips);
  return text;
}

}  // namespace planescope
