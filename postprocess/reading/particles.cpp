// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particles.h"

#include "template_cache.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>

namespace ellipsoid::post {
namespace {

/// Beyond these the squares and products of lengths overflow or vanish; no unit system needs them.
constexpr double smallest_size = 1.0e-30, largest_length = 1.0e30;

/// Longest semi-axis over shortest: sections of a body lose two digits for every factor of ten.
constexpr double largest_aspect_ratio = 1.0e4;

using Column = const std::vector<double>*;

/// The columns of one vector or tensor; null pointers where they are missing.
struct VectorColumns {
  Column x = nullptr, y = nullptr, z = nullptr;
  explicit operator bool() const { return x && y && z; }
  Vector3 at(std::size_t row) const { return {(*x)[row], (*y)[row], (*z)[row]}; }
};

Column column(const Frame& frame, const std::vector<std::string>& names) {
  const int k = frame.find_any(names);
  return k < 0 ? nullptr : &frame.columns[static_cast<std::size_t>(k)];
}

VectorColumns vector_columns(const Frame& frame, const std::string& x, const std::string& y,
                             const std::string& z) {
  return {column(frame, {x}), column(frame, {y}), column(frame, {z})};
}

struct QuaternionColumns {
  Column w = nullptr, x = nullptr, y = nullptr, z = nullptr;
  explicit operator bool() const { return w && x && y && z; }
};

/// Throws for the first of several columns that is missing.
void require_all(const Frame& frame, const std::vector<std::string>& names,
                 const std::string& purpose) {
  for (const std::string& name : names)
    frame.required(name, purpose);
}

/// A place for the message about a bad value in a row of the frame.
InputError bad_value(const Frame& frame, std::size_t row, const std::string& expected,
                     const std::string& found) {
  FilePlace place = frame.place;
  place.line += row;
  return unexpected(place, expected, found);
}

/// A number of a particle, type or body: a whole number that a double holds exactly.
std::int64_t whole_number(const Frame& frame, std::size_t row, const char* what, double value) {
  constexpr double largest = 9.0e15;
  if (value != std::floor(value) || std::abs(value) > largest)
    throw bad_value(frame, row, fmt::format("a whole number ({})", what), fmt::format("{}", value));
  return static_cast<std::int64_t>(value);
}

/// Positions in the box: plain, unwrapped or scaled coordinates.
class Positions {
 public:
  explicit Positions(const Frame& frame) : m_box(frame.box) {
    for (const char* suffix : {"", "u"})
      if (!m_plain)
        m_plain = vector_columns(frame, std::string("x") + suffix, std::string("y") + suffix,
                                 std::string("z") + suffix);
    for (const char* suffix : {"s", "su"})
      if (!m_scaled)
        m_scaled = vector_columns(frame, std::string("x") + suffix, std::string("y") + suffix,
                                  std::string("z") + suffix);
    if (!m_plain && !m_scaled)
      require_all(frame, {"x", "y", "z"}, "the position of the particles");
  }
  Vector3 at(std::size_t row) const {
    if (m_plain)
      return m_plain.at(row);
    const Vector3 s = m_scaled.at(row);
    return {unscaled(0, s.x), unscaled(1, s.y), unscaled(2, s.z)};
  }

 private:
  double unscaled(int k, double s) const {
    return m_box.lower[k] + s * (m_box.upper[k] - m_box.lower[k]);
  }
  VectorColumns m_plain, m_scaled;
  Box m_box;
};

/// Semi-axes: from the options, from shape columns or from a radius.
class Sizes {
 public:
  Sizes(const Frame& frame, const ParticleOptions& options)
      : m_frame(frame), m_scale(options.sphere_size_scale), m_given(options.semiaxes),
        m_shape(vector_columns(frame, "shapex", "shapey", "shapez")),
        m_radius(column(frame, {"radius"})), m_diameter(column(frame, {"diameter"})) {
    if (m_given.empty() && !m_shape && !m_radius && !m_diameter)
      require_all(
          frame, {"shapex", "shapey", "shapez"},
          "the semi-axes of the particles; or a column \"radius\", or give --semiaxes a b c");
  }
  Vector3 at(std::size_t row) const {
    const Vector3 s = m_scale * raw(row);
    for (const double axis : {s.x, s.y, s.z})
      if (!(axis > smallest_size && axis < largest_length))
        throw bad_value(m_frame, row,
                        fmt::format("semi-axes > 0 (and {} to {})", smallest_size, largest_length),
                        fmt::format("{} {} {}", s.x, s.y, s.z));
    if (std::max({s.x, s.y, s.z}) > largest_aspect_ratio * std::min({s.x, s.y, s.z}))
      throw bad_value(m_frame, row,
                      fmt::format("semi-axes within a factor of {}", largest_aspect_ratio),
                      fmt::format("{} {} {}", s.x, s.y, s.z));
    return s;
  }

 private:
  Vector3 raw(std::size_t row) const {
    if (!m_given.empty())
      return {m_given[0], m_given[1], m_given[2]};
    if (m_shape)
      return m_shape.at(row);
    const double radius = m_radius ? (*m_radius)[row] : 0.5 * (*m_diameter)[row];
    return {radius, radius, radius};
  }
  const Frame& m_frame;
  double m_scale;
  std::vector<double> m_given;
  VectorColumns m_shape;
  Column m_radius, m_diameter;
};

class Orientations {
 public:
  explicit Orientations(const Frame& frame) : m_frame(frame) {
    m_q = {column(frame, {"quat1", "quatw", "c_q[1]"}), column(frame, {"quat2", "quati", "c_q[2]"}),
           column(frame, {"quat3", "quatj", "c_q[3]"}),
           column(frame, {"quat4", "quatk", "c_q[4]"})};
  }
  Quaternion at(std::size_t row, const Vector3& semiaxes) const {
    const bool is_sphere = semiaxes.x == semiaxes.y && semiaxes.y == semiaxes.z;
    if (!m_q) {
      if (!is_sphere)
        require_all(m_frame, {"quat1", "quat2", "quat3", "quat4"},
                    "the orientation, quat1 (scalar part) to quat4");
      return {};
    }
    const Quaternion q{(*m_q.w)[row], (*m_q.x)[row], (*m_q.y)[row], (*m_q.z)[row]};
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    constexpr double off_unit = 1e-3; // six digits in the file leave 1e-6; 1e-3 is no quaternion
    if (std::abs(length - 1.0) > off_unit && !is_sphere)
      throw bad_value(m_frame, row, "a quaternion quat1..quat4 of length 1",
                      fmt::format("length {}", length));
    return length > 0.0 ? normalized(q) : Quaternion{};
  }

 private:
  const Frame& m_frame;
  QuaternionColumns m_q;
};

/// Number of sub-spheres of a row: 0 for a smooth particle.
int subspheres_at(const Frame& frame, Column subspheres, std::size_t row,
                  const ParticleOptions& options) {
  if (!subspheres)
    return options.subspheres;
  const double n = (*subspheres)[row];
  if (n < 0.0 || n != std::floor(n) || n > largest_sphere_count)
    throw bad_value(frame, row,
                    fmt::format("a whole number of sub-spheres from 0 to {}", largest_sphere_count),
                    fmt::format("{}", n));
  return static_cast<int>(n);
}

SphereSpacing spacing_at(const Frame& frame, Column spacing, std::size_t row,
                         const ParticleOptions& options) {
  if (!spacing)
    return options.spacing;
  const double code = (*spacing)[row];
  for (const auto known :
       {SphereSpacing::paper, SphereSpacing::minimax_outline, SphereSpacing::minimax_area})
    if (code == static_cast<double>(known))
      return known;
  throw bad_value(frame, row, "f_spacing 0 (paper), 1 (minimax_outline) or 2 (minimax_area)",
                  fmt::format("{}", code));
}

void add_chain(ParticleSet& set, Particle& particle, const MultisphereTemplate& chain) {
  const Rotation3 r = rotation(particle.orientation);
  particle.first_sphere = set.spheres.size();
  particle.sphere_count = chain.centres.size();
  for (std::size_t k = 0; k < chain.centres.size(); ++k)
    set.spheres.push_back(
        {particle.centre + r.to_space({chain.centres[k], 0.0, 0.0}), chain.radii[k]});
}

/// Everything of a row but its shape.
class CommonColumns {
 public:
  explicit CommonColumns(const Frame& frame)
      : m_frame(frame), m_position(frame), m_id(column(frame, {"id"})),
        m_type(column(frame, {"type"})), m_mass(column(frame, {"mass"})),
        m_velocity(vector_columns(frame, "vx", "vy", "vz")),
        m_spin(vector_columns(frame, "omegax", "omegay", "omegaz")) {}

  bool has_velocities() const { return static_cast<bool>(m_velocity); }

  Particle at(std::size_t row) const {
    Particle p;
    p.row = row;
    p.id =
        m_id ? whole_number(m_frame, row, "id", (*m_id)[row]) : static_cast<std::int64_t>(row) + 1;
    p.type = m_type ? whole_number(m_frame, row, "type", (*m_type)[row]) : 1;
    p.mass = m_mass ? (*m_mass)[row] : 0.0;
    p.centre = m_position.at(row);
    for (const double x : {p.centre.x, p.centre.y, p.centre.z})
      if (!(std::abs(x) < largest_length))
        throw bad_value(m_frame, row, fmt::format("a position within +-{}", largest_length),
                        fmt::format("{}", x));
    if (m_velocity)
      p.velocity = m_velocity.at(row);
    if (m_spin)
      p.angular_velocity = m_spin.at(row);
    return p;
  }

 private:
  const Frame& m_frame;
  Positions m_position;
  Column m_id, m_type, m_mass;
  VectorColumns m_velocity, m_spin;
};

std::vector<std::size_t> rows_by_id(const Frame& frame) {
  std::vector<std::size_t> order(frame.rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const Column id = column(frame, {"id"});
  if (id && !std::is_sorted(id->begin(), id->end()))
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return (*id)[i] < (*id)[j]; });
  return order;
}

/// Unit quaternion that turns the body's x axis to `axis`.
Quaternion turning_x_to(const Vector3& axis) {
  if (axis.x < -1.0 + 1e-12)
    return {0.0, 0.0, 0.0, 1.0};
  return normalized(Quaternion{1.0 + axis.x, 0.0, -axis.z, axis.y});
}

/// Longest direction of a cloud of sphere centres (unit vector; x where all coincide).
Vector3 long_axis(const Sphere* begin, const Sphere* end, const Vector3& centre) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Sphere* s = begin; s != end; ++s) {
    const Eigen::Vector3d d(s->centre.x - centre.x, s->centre.y - centre.y, s->centre.z - centre.z);
    spread += d * d.transpose();
  }
  if (!(spread.trace() > 0.0))
    return {1.0, 0.0, 0.0};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  return {axis.x(), axis.y(), axis.z()};
}

/// Size and orientation of a rigid body of the host from its spheres.
void enclose(Particle& body, const std::vector<Sphere>& spheres) {
  const Sphere* begin = spheres.data() + body.first_sphere;
  const Sphere* end = begin + body.sphere_count;
  Vector3 centre;
  for (const Sphere* s = begin; s != end; ++s)
    centre += (1.0 / static_cast<double>(body.sphere_count)) * s->centre;
  body.centre = centre;
  const Vector3 axis = long_axis(begin, end, centre);
  double length = 0.0, width = 0.0;
  for (const Sphere* s = begin; s != end; ++s) {
    const Vector3 d = s->centre - centre;
    const double along = dot(d, axis);
    length = std::max(length, std::abs(along) + s->radius);
    width = std::max(width, norm(d - along * axis) + s->radius);
  }
  body.orientation = turning_x_to(axis);
  body.semiaxes = {length, width, width};
}

ParticleSet host_multispheres(const Frame& frame, const std::vector<double>& body_of_row,
                              const ParticleOptions& options) {
  const Sizes sizes(frame, options);
  const CommonColumns common(frame);
  std::map<std::int64_t, std::vector<std::size_t>> rows_of_body;
  std::int64_t single = -1; // rows of no body are spheres of their own
  for (const std::size_t row : rows_by_id(frame)) {
    const std::int64_t body = whole_number(frame, row, "body", body_of_row[row]);
    rows_of_body[body > 0 ? body : single--].push_back(row);
  }
  ParticleSet set;
  set.has_velocities = common.has_velocities();
  for (const auto& [body, rows] : rows_of_body) {
    Particle p = common.at(rows.front());
    if (body > 0)
      p.id = body;
    p.first_sphere = set.spheres.size();
    p.sphere_count = rows.size();
    for (const std::size_t row : rows)
      set.spheres.push_back({common.at(row).centre, sizes.at(row).x});
    enclose(p, set.spheres);
    set.particles.push_back(p);
  }
  return set;
}

} // namespace

double Particle::largest_axis() const { return std::max({semiaxes.x, semiaxes.y, semiaxes.z}); }
double Particle::smallest_axis() const { return std::min({semiaxes.x, semiaxes.y, semiaxes.z}); }

double mean_smallest_axis(const ParticleSet& set, const std::vector<std::size_t>& members) {
  double sum = 0.0;
  for (const std::size_t i : members)
    sum += set.particles[i].smallest_axis();
  return members.empty() ? 0.0 : sum / static_cast<double>(members.size());
}

double mean_largest_axis(const ParticleSet& set, const std::vector<std::size_t>& members) {
  double sum = 0.0;
  for (const std::size_t i : members)
    sum += set.particles[i].largest_axis();
  return members.empty() ? 0.0 : sum / static_cast<double>(members.size());
}

std::vector<std::size_t> all_members(const ParticleSet& set) {
  std::vector<std::size_t> members(set.particles.size());
  std::iota(members.begin(), members.end(), std::size_t{0});
  return members;
}

ParticleSet particles_of(const Frame& frame, const ParticleOptions& options) {
  const Column body = column(frame, {"id_multisphere", "mol"});
  if (body && std::any_of(body->begin(), body->end(), [](double b) { return b > 0.0; }))
    return host_multispheres(frame, *body, options);
  const Sizes sizes(frame, options);
  const Orientations orientations(frame);
  const CommonColumns common(frame);
  const Column subspheres = column(frame, {"f_subspheres"});
  const Column spacing = column(frame, {"f_spacing"});
  TemplateCache templates;
  ParticleSet set;
  set.has_velocities = common.has_velocities();
  set.particles.reserve(frame.rows);
  for (const std::size_t row : rows_by_id(frame)) {
    Particle p = common.at(row);
    p.semiaxes = sizes.at(row);
    p.orientation = orientations.at(row, p.semiaxes);
    const int count = subspheres_at(frame, subspheres, row, options);
    if (count > 0) {
      const SphereSpacing placed = spacing_at(frame, spacing, row, options);
      try {
        add_chain(set, p, templates.find(p.semiaxes, count, placed));
      } catch (const std::invalid_argument& error) {
        throw bad_value(frame, row, "a multi-sphere particle that can be built", error.what());
      }
    }
    set.particles.push_back(p);
  }
  return set;
}

} // namespace ellipsoid::post
