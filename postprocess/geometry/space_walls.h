// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "contacts.h"

#include <array>
#include <variant>
#include <vector>

namespace ellipsoid::post {

/// A plane without thickness; bodies are on the side of their centre.
struct SheetWall {
  Vector3 point, normal; ///< normal: unit
};

/// An infinite circular cylinder; bodies are on the side of their centre.
struct CylinderWall {
  Vector3 point, axis; ///< axis: unit
  double radius = 0.0; ///< (length)
};

/// The triangles of a surface mesh, all together one wall.
struct MeshWall {
  std::vector<std::array<Vector3, 3>> triangles; ///< corners (length)
};

using SpaceWall = std::variant<PlaneWall, SheetWall, CylinderWall, MeshWall>;

/// How many bodies of a particle (its ellipsoid, or its spheres) come as near to a wall as half of
/// the gap, by the engine's kernel.
std::size_t bodies_at_wall(const ParticleSet& set, std::size_t particle, const SpaceWall& wall,
                           double gap);

} // namespace ellipsoid::post
