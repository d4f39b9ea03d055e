// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "height_map.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// More columns than this would fill the memory.
constexpr double most_columns = 1.0e8;

// x to y, y to z, z to x: a turn by 120 degrees about (1, 1, 1)
Vector3 turned(const Vector3& v) { return {v.z, v.x, v.y}; }

Box turned_box(const Box& box) {
  Box result = box;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = (k + 2) % 3;
    result.lower[k] = box.lower[from];
    result.upper[k] = box.upper[from];
    if (box.tilted_edges.size() == 3)
      result.tilted_edges[k] = turned(box.tilted_edges[from]);
  }
  if (box.boundary.size() >= 8) // "pp pp ff"
    result.boundary = box.boundary.substr(6, 2) + " " + box.boundary.substr(0, 5);
  return result;
}

} // namespace

ParticleSet turned_upright(const ParticleSet& set, UpAxis up) {
  ParticleSet result = set;
  if (up == UpAxis::z)
    return result;
  const Quaternion turn{0.5, 0.5, 0.5, 0.5};
  for (Particle& p : result.particles) {
    p.centre = turned(p.centre);
    p.velocity = turned(p.velocity);
    p.angular_velocity = turned(p.angular_velocity);
    p.orientation = turn * p.orientation;
  }
  for (Sphere& s : result.spheres)
    s.centre = turned(s.centre);
  result.box = turned_box(set.box);
  return result;
}

bool top_of_ellipsoid(const Particle& particle, double x, double y, double& z) {
  const Vector3& s = particle.semiaxes;
  const SymmetricMatrix3 m = rotated_diagonal(rotation(particle.orientation), 1.0 / (s.x * s.x),
                                              1.0 / (s.y * s.y), 1.0 / (s.z * s.z));
  const double dx = x - particle.centre.x, dy = y - particle.centre.y;
  // m.zz dz^2 + 2 half dz + rest = 0
  const double half = m.xz * dx + m.yz * dy;
  const double rest = m.xx * dx * dx + 2.0 * m.xy * dx * dy + m.yy * dy * dy - 1.0;
  const double discriminant = half * half - m.zz * rest;
  if (discriminant < 0.0)
    return false;
  z = particle.centre.z + (std::sqrt(discriminant) - half) / m.zz;
  return true;
}

bool top_of_sphere(const Sphere& sphere, double x, double y, double& z) {
  const double dx = x - sphere.centre.x, dy = y - sphere.centre.y;
  const double squared = sphere.radius * sphere.radius - dx * dx - dy * dy;
  if (squared < 0.0)
    return false;
  z = sphere.centre.z + std::sqrt(squared);
  return true;
}

HeightMap::HeightMap(const ParticleSet& set, const std::vector<std::size_t>& members, double width,
                     double floor)
    : width_(width), floor_(floor) {
  if (members.empty())
    return;
  double right = -1e300, back = -1e300;
  left_ = front_ = 1e300;
  for (const std::size_t i : members) {
    const Particle& p = set.particles[i];
    const double reach = p.largest_axis();
    left_ = std::min(left_, p.centre.x - reach);
    right = std::max(right, p.centre.x + reach);
    front_ = std::min(front_, p.centre.y - reach);
    back = std::max(back, p.centre.y + reach);
  }
  constexpr double rounding = 1.0e-15;
  for (const double edge : {left_, right, front_, back})
    if (!(std::abs(edge) * rounding < width))
      throw InputError(
          fmt::format("a particle lies at {:.3g}, so far away that its own size ({:.3g}) "
                      "is lost in rounding: leave it out",
                      edge, mean_smallest_axis(set, members)));
  const double nx = std::ceil((right - left_) / width), ny = std::ceil((back - front_) / width);
  if (!(nx * ny <= most_columns))
    throw InputError(fmt::format("the free surface would need {:.0f} columns (at most {:.0f}): "
                                 "choose a larger --columns",
                                 nx * ny, most_columns));
  columns_x_ = static_cast<std::size_t>(nx);
  columns_y_ = static_cast<std::size_t>(ny);
  heights_.assign(columns_x_ * columns_y_, floor);
  for (const std::size_t i : members) {
    const Particle& p = set.particles[i];
    if (p.is_smooth())
      raise(p.centre, p.largest_axis(),
            [&](double x, double y, double& z) { return top_of_ellipsoid(p, x, y, z); });
    for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k)
      raise(set.spheres[k].centre, set.spheres[k].radius,
            [&](double x, double y, double& z) { return top_of_sphere(set.spheres[k], x, y, z); });
  }
}

/// Lifts the columns within `reach` of a body to its top.
template <class Top> void HeightMap::raise(const Vector3& centre, double reach, const Top& top) {
  const auto column = [this](double distance, std::size_t count) {
    const double k = std::clamp(std::floor(distance / width_), 0.0, static_cast<double>(count - 1));
    return static_cast<std::size_t>(k);
  };
  const std::size_t i0 = column(centre.x - reach - left_, columns_x_);
  const std::size_t i1 = column(centre.x + reach - left_, columns_x_);
  const std::size_t j0 = column(centre.y - reach - front_, columns_y_);
  const std::size_t j1 = column(centre.y + reach - front_, columns_y_);
  double z = 0.0;
  for (std::size_t j = j0; j <= j1; ++j)
    for (std::size_t i = i0; i <= i1; ++i)
      if (top(x(i), y(j), z))
        heights_[j * columns_x_ + i] = std::max(heights_[j * columns_x_ + i], z);
}

double HeightMap::summit() const {
  return heights_.empty() ? floor_ : *std::max_element(heights_.begin(), heights_.end());
}

double HeightMap::volume() const {
  double sum = 0.0;
  for (const double height : heights_)
    sum += height - floor_;
  return sum * width_ * width_;
}

} // namespace ellipsoid::post
