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

  std::size_t columns_x() const { return m_columns_x; }
  std::size_t columns_y() const { return m_columns_y; }
  double x(std::size_t i) const { return m_left + (static_cast<double>(i) + 0.5) * m_width; }
  double y(std::size_t j) const { return m_front + (static_cast<double>(j) + 0.5) * m_width; }
  double height(std::size_t i, std::size_t j) const { return m_heights[j * m_columns_x + i]; }
  double floor() const { return m_floor; }
  double width() const { return m_width; } ///< of a column (length)
  double summit() const;
  /// Volume between floor and surface, column by column (length^3).
  double volume() const;

 private:
  template <class Top> void raise(const Vector3& centre, double reach, const Top& top);

  double m_left = 0.0, m_front = 0.0, m_width = 1.0, m_floor = 0.0;
  std::size_t m_columns_x = 0, m_columns_y = 0;
  std::vector<double> m_heights;
};

} // namespace ellipsoid::post
