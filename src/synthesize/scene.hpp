// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planescope/cloud.hpp"
#include "synthesize/geometry.hpp"
#include "synthesize/random.hpp"

/// \file A scene: the solids that hide things, the surfaces that can be seen, and their names.
namespace planescope::synthesis {

/// What can be closer to a face than this cannot be seen past: the gap behind a cupboard.
inline constexpr double kHiddenGap = 0.035;  // [m]

enum class Texture {
  Plain,
  Checker,  ///< squares of two colours
  Planks,   ///< boards along x, each a little lighter or darker
  Stripes,  ///< bands across x, of two colours
  Tape,     ///< one band of the second colour along x = 0
};

/// What a part looks like.
struct Material {
  Rgb base;
  Rgb second = {};
  Texture texture = Texture::Plain;
  double period = 0.1;  ///< [m] of the pattern; width of the tape
};

/// The material's colour at a place of a surface, with a little noise.
Rgb shade(const Material& material, const Vector2d& texture, Random& random);

/// One solid of a piece, in the piece's frame.
struct Part {
  Solid solid;
  std::string name;  ///< `leg 2`; may be empty for the part that is the piece
  Material material;
};

/// A piece of furniture: z up, standing on z = 0, its front towards -y.
struct Piece {
  std::string kind;  ///< `table`
  std::vector<Part> parts;
};

/// Something that can be sampled and seen.
struct Surface {
  SurfaceGeometry geometry;
  Material material;
  std::uint32_t label = 0;
  std::uint32_t solid = 0;  ///< the solid that it bounds
  std::string name;         ///< `table 1 leg 2 front`
  bool structural = false;
};

/// How much of a surface is free to be seen, by a grid over it.
struct VisiblePart {
  double area = 0;  ///< [m^2]
  Vector3d centroid = Vector3d::Zero();
};

class Scene {
 public:
  /// Adds an object with all faces of its parts. \returns its label.
  std::uint32_t add(const Piece& piece, const Isometry3d& pose, const std::string& name);

  /// Adds a floor, wall or ceiling: a solid slab, of which only the face towards its own +z is a
  /// surface.
  std::uint32_t add_structure(const Solid& slab, const Material& material, const std::string& name);

  const std::vector<Solid>& solids() const { return solids_; }
  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const std::vector<std::string>& objects() const { return objects_; }  ///< index = label - 1

  /// Per surface: the other solids that come close enough to hide any of it.
  std::vector<std::vector<std::uint32_t>> find_occluders() const;

  /// True if one of the solids fills the place in front of the point: nobody can see it.
  bool hidden(const SurfacePoint& point, const std::vector<std::uint32_t>& occluders) const;

  VisiblePart visible_part(const Surface& surface,
                           const std::vector<std::uint32_t>& occluders) const;

  /// True if `p` is inside a solid or nearer than `margin` to one.
  bool occupied(const Vector3d& p, double margin) const;

 private:
  void add_part(const Part& part, const Isometry3d& pose, const std::string& owner);
  void add_box_faces(const Solid& solid, Surface surface, const std::string& name);
  void add_round_faces(const Solid& solid, Surface surface, const std::string& name);

  void add_solid(const Solid& solid);

  std::vector<Solid> solids_;
  std::vector<Box3d> reach_;  ///< per solid: where points are that it could hide
  std::vector<Surface> surfaces_;
  std::vector<std::string> objects_;
};

}  // namespace planescope::synthesis
