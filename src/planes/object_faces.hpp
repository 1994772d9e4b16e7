// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planes/held_planes.hpp"
#include "planescope/pipeline.hpp"

namespace planescope {

/// Planar faces of objects (SupportingPlane::role), and which one each patch lies on.
struct ObjectFaces {
  std::vector<SupportingPlane> planes;   ///< by area, descending
  std::vector<std::int32_t> patch_face;  ///< per patch: index into `planes`, or kNone
};

/// Inlier distance of faces [m], from that of supporting planes.
double face_sigma(double sigma);

/// The paper's Section IV once more among the patches that no supporting plane took, for planes of
/// at least options.face_area: table tops in a room, the sides of a cupboard. Differs from the
/// paper's selection: the supporting planes stand, and a face pays four times the mean of eq. (6)'s
/// angle term over them; among one another faces pay for overlap alone, because the sum over dozens
/// of small faces, each a little noisy, would refuse them all.
/// \param held what an earlier run found, or null. \returns the hypotheses, the faces selected.
std::vector<HeldPlane> select_object_faces(const PatchGraph& graph,
                                           const std::vector<SupportingPlane>& supporting,
                                           const std::vector<PatchPlane>& patch_plane,
                                           const PlaneOptions& options,
                                           const HeldPlanes* held = nullptr);

/// Which patches are on those that are selected, and these fitted to their connected pieces.
/// \param faces of select_object_faces() of the same graph.
ObjectFaces place_object_faces(const PatchGraph& graph, const std::vector<PatchPlane>& patch_plane,
                               const std::vector<HeldPlane>& faces, const PlaneOptions& options);

/// What a plane has to say for itself as a face: the terms of the selection above but for overlap.
struct FaceTerms {
  double lambda = 0;                   ///< [patches] of eq. (4), from options.face_area
  std::vector<std::uint32_t> inliers;  ///< patches on no supporting plane, ascending
  double data_cost = 0;                ///< D of eq. (4)
  std::vector<double> angle_cost;      ///< per supporting plane: its share of what the face pays
};

/// By the patches' own normals, as the selection saw them.
FaceTerms face_terms(const Plane& face, const std::vector<Patch>& patches,
                     const std::vector<SupportingPlane>& supporting,
                     const std::vector<PatchPlane>& patch_plane, const PlaneOptions& options);

/// Gives the patches of a face its normal: edges are then judged by a normal that hundreds of
/// voxels agree on. \param patch_face per patch: index into `planes`, or kNone.
void steady_normals(std::vector<Patch>& patches, std::span<const SupportingPlane> planes,
                    std::span<const std::int32_t> patch_face);

}  // namespace planescope
