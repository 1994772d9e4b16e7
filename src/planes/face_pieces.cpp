// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/face_pieces.hpp"

#include <cmath>

#include "planes/support.hpp"
#include "union_find.hpp"

namespace planescope {
namespace {

// Patches of one plane that hang together.
struct Piece {
  std::int32_t plane = kNone;
  std::int32_t number = kNone;  // in FacePieces::planes
  std::uint32_t patches = 0;
  double area = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();

  void add(const Patch& patch, std::int32_t on) {
    plane = on;
    ++patches;
    area += double(patch.area);
    sum += double(patch.area) * patch.centroid.cast<double>();
  }
};

struct Pieces {
  std::vector<std::uint32_t> of;  // per patch: its piece
  std::vector<Piece> list;        // those without patches are none
};

Pieces find_pieces(const PatchGraph& graph, const std::vector<std::int32_t>& assignment) {
  UnionFind sets(graph.patches.size());
  for (const Adjacency& pair : graph.adjacency) {
    if (assignment[pair.first] != kNone && assignment[pair.first] == assignment[pair.second])
      sets.unite(pair.first, pair.second);
  }
  Pieces pieces{std::vector<std::uint32_t>(assignment.size()),
                std::vector<Piece>(assignment.size())};
  for (std::uint32_t i = 0; i < assignment.size(); ++i) {
    pieces.of[i] = sets.find(i);
    if (assignment[i] != kNone) pieces.list[pieces.of[i]].add(graph.patches[i], assignment[i]);
  }
  return pieces;
}

// Numbers the pieces that are large enough, and planes that have none of these as a whole.
// \returns per number: the plane.
std::vector<std::int32_t> number_pieces(std::vector<Piece>& pieces, std::size_t plane_count,
                                        double fewest) {
  const auto at = [](std::int32_t plane) { return static_cast<std::size_t>(plane); };
  std::vector<char> has_large(plane_count, 0);
  for (const Piece& piece : pieces) {
    if (piece.patches >= fewest) has_large[at(piece.plane)] = 1;
  }
  std::vector<std::int32_t> source, whole(plane_count, kNone);
  for (Piece& piece : pieces) {
    if (piece.patches == 0) continue;
    const bool large = piece.patches >= fewest;
    if (!large && has_large[at(piece.plane)] != 0) continue;
    if (large || whole[at(piece.plane)] == kNone) {
      whole[at(piece.plane)] = static_cast<std::int32_t>(source.size());
      source.push_back(piece.plane);
    }
    piece.number = whole[at(piece.plane)];
  }
  return source;
}

std::vector<std::int32_t> numbers_by_patch(const Pieces& pieces) {
  std::vector<std::int32_t> numbers;
  numbers.reserve(pieces.of.size());
  for (const std::uint32_t piece : pieces.of) numbers.push_back(pieces.list[piece].number);
  return numbers;
}

// Small pieces go to the numbered one of their plane that they lie nearest to.
void adopt_scraps(std::vector<Piece>& pieces, const std::vector<SupportingPlane>& fits,
                  const std::vector<std::int32_t>& source, double reach) {
  for (Piece& piece : pieces) {
    if (piece.patches == 0 || piece.number != kNone) continue;
    const Eigen::Vector3f center = (piece.sum / piece.area).cast<float>();
    double least = reach;
    for (const SupportingPlane& fit : fits) {
      if (source[fit.hypothesis] != piece.plane) continue;
      const double distance = std::abs(double(fit.plane.signed_distance(center)));
      if (distance >= least) continue;
      least = distance;
      piece.number = static_cast<std::int32_t>(fit.hypothesis);
    }
  }
}

}  // namespace

Support refit_pieces(const PatchGraph& graph, const std::vector<Plane>& planes,
                     const std::vector<std::int32_t>& assignment, const PlaneOptions& options,
                     double fewest) {
  Pieces pieces = find_pieces(graph, assignment);
  const std::vector<std::int32_t> source = number_pieces(pieces.list, planes.size(), fewest);
  PlaneSelection selection;
  for (const std::int32_t plane : source) {
    selection.selected.push_back(static_cast<std::uint32_t>(selection.hypotheses.size()));
    selection.hypotheses.push_back({.plane = planes[static_cast<std::size_t>(plane)]});
  }
  const Support large = refit_planes(graph, selection, numbers_by_patch(pieces));
  adopt_scraps(pieces.list, large.planes, source, 2 * options.sigma);
  return refit_planes(graph, selection, numbers_by_patch(pieces));
}

}  // namespace planescope
