// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "space_walls.h"

#include "wall/cylinder_contact.h"
#include "wall/triangle_contact.h"

#include <algorithm>

namespace ellipsoid::post {
namespace {

bool touches(const Vector3& semiaxes, const Quaternion& orientation, const Vector3& centre,
             const CylinderWall& wall, double gap) {
  const double half = 0.5 * gap;
  std::vector<WallContact> found;
  find_cylinder_contacts(EllipsoidBody(semiaxes + Vector3{half, half, half}, orientation),
                         {wall.point - centre, wall.axis, wall.radius}, found);
  return !found.empty() && found.front().overlap >= 0.0;
}

/// Whether a triangle is so far from the origin that no body of this reach touches it.
bool is_far(const Triangle& triangle, double reach) {
  const auto lies_beyond = [&](double Vector3::*axis) {
    const double p = triangle[0].*axis, q = triangle[1].*axis, r = triangle[2].*axis;
    return std::min({p, q, r}) > reach || std::max({p, q, r}) < -reach;
  };
  return lies_beyond(&Vector3::x) || lies_beyond(&Vector3::y) || lies_beyond(&Vector3::z);
}

bool touches(const Vector3& semiaxes, const Quaternion& orientation, const Vector3& centre,
             const MeshWall& wall, double gap) {
  const double half = 0.5 * gap;
  const EllipsoidBody body(semiaxes + Vector3{half, half, half}, orientation);
  const double reach = extent(body);
  return std::any_of(wall.triangles.begin(), wall.triangles.end(), [&](const Triangle& triangle) {
    const Triangle from_body{triangle[0] - centre, triangle[1] - centre, triangle[2] - centre};
    return !is_far(from_body, reach) && reaches(body, from_body);
  });
}

/// How many of the particle's bodies touch a wall of this kind.
template <class Wall>
std::size_t bodies_at(const ParticleSet& set, const Particle& p, const Wall& wall, double gap) {
  if (p.is_smooth())
    return touches(p.semiaxes, p.orientation, p.centre, wall, gap) ? 1 : 0;
  std::size_t count = 0;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
    const double r = set.spheres[k].radius;
    count += touches({r, r, r}, {}, set.spheres[k].centre, wall, gap) ? 1 : 0;
  }
  return count;
}

} // namespace

std::size_t bodies_at_wall(const ParticleSet& set, std::size_t particle, const SpaceWall& wall,
                           double gap) {
  if (const auto* plane = std::get_if<PlaneWall>(&wall))
    return wall_overlaps(set, particle, *plane, gap).size();
  if (const auto* sheet = std::get_if<SheetWall>(&wall)) {
    const bool is_above = dot(set.particles[particle].centre - sheet->point, sheet->normal) >= 0.0;
    const PlaneWall plane{sheet->point, is_above ? sheet->normal : -sheet->normal};
    return wall_overlaps(set, particle, plane, gap).size();
  }
  if (const auto* cylinder = std::get_if<CylinderWall>(&wall))
    return bodies_at(set, set.particles[particle], *cylinder, gap);
  return bodies_at(set, set.particles[particle], std::get<MeshWall>(wall), gap);
}

} // namespace ellipsoid::post
