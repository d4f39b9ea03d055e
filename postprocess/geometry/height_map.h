// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "particles.h"

#include <vector>

namespace ellipsoid::post {

/// Which axis of the simulation points up.
enum class UpAxis { y, z };

/// The same particles in a frame whose z axis points up (a turn, no mirror: x to y, y to z, z to x
/// for UpAxis::y).
ParticleSet turned_upright(const ParticleSet& set, UpAxis up);

/// Ordinate z of the highest point of a body above (x, y); false where the body is not.
bool top_of_ellipsoid(const Particle& particle, double x, double y, double& z);
bool top_of_sphere(const Sphere& sphere, double x, double y, double& z);

/// The free surface of a heap over the xy plane: z_max(x, y) of the true outlines at the middles
/// of square columns; the floor where there is no particle.
class HeightMap {
 public:
  /// @param[in] width of the columns (length)
  HeightMap(const ParticleSet& set, const std::vector<std::size_t>& members, double width,
            double floor);

  std::size_t columns_x() const { return columns_x_; }
  std::size_t columns_y() const { return columns_y_; }
  double x(std::size_t i) const { return left_ + (static_cast<double>(i) + 0.5) * width_; }
  double y(std::size_t j) const { return front_ + (static_cast<double>(j) + 0.5) * width_; }
  double height(std::size_t i, std::size_t j) const { return heights_[j * columns_x_ + i]; }
  double floor() const { return floor_; }
  double width() const { return width_; } ///< of a column (length)
  double summit() const;
  /// Volume between floor and surface, column by column (length^3).
  double volume() const;

 private:
  template <class Top> void raise(const Vector3& centre, double reach, const Top& top);

  double left_ = 0.0, front_ = 0.0, width_ = 1.0, floor_ = 0.0;
  std::size_t columns_x_ = 0, columns_y_ = 0;
  std::vector<double> heights_;
};

} // namespace ellipsoid::post
