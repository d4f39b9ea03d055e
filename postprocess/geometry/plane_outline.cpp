// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "plane_outline.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

constexpr double pi = 3.141592653589793238462643;

} // namespace

Point PlaneEllipse::at(double t) const {
  const double cosine = std::cos(t), sine = std::sin(t);
  return {centre.x() + ux * cosine, centre.y() + uy * cosine + vy * sine};
}

double PlaneEllipse::upper(double x) const {
  const double cosine = (x - centre.x()) / ux;
  return centre.y() + uy * cosine + vy * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

void PlaneEllipse::upper(const double* x, std::size_t count, double* y) const {
  const PlaneEllipse own = *this; // y might be a part of this for all the compiler knows
  for (std::size_t k = 0; k < count; ++k)
    y[k] = own.upper(x[k]);
}

double PlaneEllipse::area_under_upper(double x0, double x1) const {
  const double c0 = std::clamp((x0 - centre.x()) / ux, -1.0, 1.0);
  const double c1 = std::clamp((x1 - centre.x()) / ux, -1.0, 1.0);
  // integral of sqrt(1 - c^2) = (c sqrt(1 - c^2) + asin c) / 2
  const auto half_disc = [](double c) {
    return 0.5 * (c * std::sqrt(std::max(0.0, 1.0 - c * c)) + std::asin(c));
  };
  return ux * (centre.y() * (c1 - c0) + 0.5 * uy * (c1 * c1 - c0 * c0) +
               vy * (half_disc(c1) - half_disc(c0)));
}

double PlaneEllipse::area() const { return pi * ux * vy; }

double PlaneEllipse::top() const { return centre.y() + std::sqrt(uy * uy + vy * vy); }

double PlaneEllipse::bounding_radius() const {
  // largest singular value of [u v]
  const double p = ux * ux + uy * uy, r = vy * vy, q = uy * vy;
  return std::sqrt(0.5 * (p + r) + std::sqrt(0.25 * (p - r) * (p - r) + q * q));
}

bool section_of_ellipsoid(const Particle& particle, double z0, PlaneEllipse& ellipse) {
  const Vector3& s = particle.semiaxes;
  // (p - centre)^T M (p - centre) = 1 on the surface
  const SymmetricMatrix3 m = rotated_diagonal(rotation(particle.orientation), 1.0 / (s.x * s.x),
                                              1.0 / (s.y * s.y), 1.0 / (s.z * s.z));
  const double det = m.xx * m.yy - m.xy * m.xy;
  const double dz = z0 - particle.centre.z;
  // the section's centre and scale, by completing the square in the plane
  const double shift_x = -dz * (m.yy * m.xz - m.xy * m.yz) / det;
  const double shift_y = -dz * (m.xx * m.yz - m.xy * m.xz) / det;
  const double schur =
      m.zz - (m.yy * m.xz * m.xz - 2.0 * m.xy * m.xz * m.yz + m.xx * m.yz * m.yz) / det;
  const double scale = 1.0 - dz * dz * schur;
  if (!(scale > 0.0))
    return false;
  // Cholesky factor of the inverse of M's upper left block times scale: its columns are u and v
  ellipse.ux = std::sqrt(scale * m.yy / det);
  ellipse.uy = -scale * m.xy / det / ellipse.ux;
  ellipse.vy = std::sqrt(scale / m.yy);
  ellipse.centre = {particle.centre.x + shift_x, particle.centre.y + shift_y};
  return true;
}

bool section_of_sphere(const Sphere& sphere, double z0, PlaneEllipse& disc) {
  const double dz = z0 - sphere.centre.z;
  const double squared = sphere.radius * sphere.radius - dz * dz;
  if (!(squared > 0.0))
    return false;
  disc.ux = disc.vy = std::sqrt(squared);
  disc.uy = 0.0;
  disc.centre = {sphere.centre.x, sphere.centre.y};
  return true;
}

std::vector<PlaneEllipse> outlines(const ParticleSet& set, const std::vector<std::size_t>& members,
                                   double z0, OutlineKind kind) {
  std::vector<PlaneEllipse> result;
  for (const std::size_t i : members) {
    const Particle& p = set.particles[i];
    PlaneEllipse shape;
    shape.owner = i;
    if (p.is_smooth() || kind == OutlineKind::smooth_ellipse) {
      if (section_of_ellipsoid(p, z0, shape))
        result.push_back(shape);
      continue;
    }
    for (std::size_t k = 0; k < p.sphere_count; ++k)
      if (section_of_sphere(set.spheres[p.first_sphere + k], z0, shape))
        result.push_back(shape);
  }
  return result;
}

} // namespace ellipsoid::post
