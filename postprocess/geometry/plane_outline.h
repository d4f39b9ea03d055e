// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Outlines of particles in the plane of a pile: ellipses and discs, exact.
#pragma once

#include "particles.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace ellipsoid::post {

using Point = Eigen::Vector2d; ///< x, y (length)

inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// An ellipse by its centre c and two conjugate half-diameters u = (ux, uy), v = (0, vy):
/// point(t) = c + u cos t + v sin t. With v vertical and ux, vy > 0 the arc 0 < t < pi is the
/// upper one, and its abscissa is c.x + ux cos t.
struct PlaneEllipse {
  Point centre{0.0, 0.0};
  double ux = 0.0, uy = 0.0, vy = 0.0; ///< (length)
  std::size_t owner = 0;               ///< index of its particle

  Point at(double t) const;
  /// Ordinate of the upper arc at abscissa x; x within centre.x +- ux.
  double upper(double x) const;
  /// The same at `count` abscissas.
  void upper(const double* x, std::size_t count, double* y) const;
  /// Integral of the upper arc's ordinate from x0 to x1, closed form (length^2).
  double area_under_upper(double x0, double x1) const;
  double area() const; ///< pi ux vy (length^2)
  double left() const { return centre.x() - ux; }
  double right() const { return centre.x() + ux; }
  double top() const;             ///< largest ordinate (length)
  double bounding_radius() const; ///< of a circle about the centre that encloses it (length)
};

/// The section of a body by the plane z = z0; false when the plane misses it.
bool section_of_ellipsoid(const Particle& particle, double z0, PlaneEllipse& ellipse);
bool section_of_sphere(const Sphere& sphere, double z0, PlaneEllipse& disc);

/// Which outline stands for a multi-sphere particle (paper, section 4.2.2).
enum class OutlineKind {
  true_shape,     ///< smooth: the ellipse; multi-sphere: its discs ("MS")
  smooth_ellipse, ///< always the circumscribed ellipse ("MS ellipse")
};

/// Outlines of the particles `members` in the plane z = z0.
std::vector<PlaneEllipse> outlines(const ParticleSet& set, const std::vector<std::size_t>& members,
                                   double z0, OutlineKind kind);

} // namespace ellipsoid::post
