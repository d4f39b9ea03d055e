// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particles.h"

#include "clump_files.h"
#include "template_cache.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
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
  explicit Positions(const NamedColumns& columns) : m_box(columns.frame().box) {
    for (const char* suffix : {"", "u"})
      if (!m_plain)
        m_plain = columns.find(std::string("x") + suffix, std::string("y") + suffix,
                               std::string("z") + suffix);
    for (const char* suffix : {"s", "su"})
      if (!m_scaled)
        m_scaled = columns.find(std::string("x") + suffix, std::string("y") + suffix,
                                std::string("z") + suffix);
    if (!m_plain && !m_scaled)
      require_all(columns.frame(), {"x", "y", "z"}, "the position of the particles");
  }
  Vector3 at(std::size_t row) const {
    if (m_plain)
      return m_plain.at(row);
    const Vector3 s = m_scaled.at(row);
    const auto& edges = m_box.tilted_edges;
    if (edges.empty())
      return {unscaled(0, s.x), unscaled(1, s.y), unscaled(2, s.z)};
    return Vector3{m_box.lower[0], m_box.lower[1], m_box.lower[2]} + s.x * edges[0] +
           s.y * edges[1] + s.z * edges[2];
  }

 private:
  double unscaled(int k, double s) const {
    return m_box.lower[k] + s * (m_box.upper[k] - m_box.lower[k]);
  }
  VectorColumns m_plain, m_scaled;
  const Box& m_box;
};

/// Semi-axes: from the options, from shape columns or from a radius.
class Sizes {
 public:
  Sizes(const NamedColumns& columns, const ParticleOptions& options)
      : m_frame(columns.frame()), m_given(options.semiaxes),
        m_shape(columns.find("shapex", "shapey", "shapez")) {
    const VectorColumns computed = columns.find("c_shape[1]", "c_shape[2]", "c_shape[3]");
    const bool is_named = columns.is_assigned("shapex");
    m_are_whole_axes = !is_named && (m_shape ? columns.find("quatw") && !columns.find("quat1")
                                             : static_cast<bool>(computed));
    m_is_scale_given = options.size_scale.has_value();
    m_scale = options.size_scale.value_or(m_are_whole_axes ? 0.5 : 1.0);
    if (!m_shape)
      m_shape = computed;
    if (!m_shape) {
      m_radius = columns.find("radius");
      m_diameter = columns.find("diameter");
    }
    if (!m_given.empty() && (m_shape || m_radius || m_diameter))
      throw InputError(
          "--semiaxes is for files without sizes: this one has columns with them; leave "
          "it out");
    if (m_given.empty() && !m_shape && !m_radius && !m_diameter)
      require_all(
          m_frame, {"shapex", "shapey", "shapez"},
          "the semi-axes of the particles; or a column \"radius\", or give --semiaxes a b c");
  }
  bool has_shapes() const { return static_cast<bool>(m_shape); }
  /// What was taken for granted, or nothing.
  std::string remark() const {
    return m_are_whole_axes && !m_is_scale_given
               ? "sizes beside LAMMPS's names of the orientation are taken as whole axes and "
                 "halved; "
                 "--size-scale 1 takes them as semi-axes, --size-scale 0.5 as whole ones"
               : "";
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
  double m_scale = 1.0;
  bool m_are_whole_axes = false, m_is_scale_given = false;
  std::vector<double> m_given;
  VectorColumns m_shape;
  Column m_radius = nullptr, m_diameter = nullptr;
};

class Orientations {
 public:
  explicit Orientations(const NamedColumns& columns) : m_frame(columns.frame()) {
    const std::array<std::array<const char*, 4>, 3> names = {
        {{"quat1", "quat2", "quat3", "quat4"},
         {"quatw", "quati", "quatj", "quatk"},
         {"c_orient[4]", "c_orient[1]", "c_orient[2]", "c_orient[3]"}}};
    for (const auto& [w, x, y, z] : names)
      if (!m_q)
        m_q = {columns.find(w), columns.find(x), columns.find(y), columns.find(z)};
    if (!m_q && columns.find("c_q[1]") && columns.find("c_q[4]"))
      throw InputError(
          "the order of the quaternion in the columns c_q[*] is not known: say it, for "
          "example --column quat1=c_q[1] --column quat2=c_q[2] --column quat3=c_q[3] "
          "--column quat4=c_q[4] (quat1: scalar part)");
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
    return options.subspheres.value_or(0);
  const double n = (*subspheres)[row];
  if (n < 0.0 || n != std::floor(n) || n > largest_set_count)
    throw bad_value(frame, row,
                    fmt::format("a whole number of sub-spheres from 0 to {}", largest_set_count),
                    fmt::format("{}", n));
  return static_cast<int>(n);
}

SphereSpacing spacing_at(const Frame& frame, Column spacing, std::size_t row,
                         const ParticleOptions& options) {
  if (!spacing)
    return options.spacing.value_or(SphereSpacing::paper);
  const double code = (*spacing)[row];
  for (const auto known :
       {SphereSpacing::paper, SphereSpacing::minimax_outline, SphereSpacing::minimax_area,
        SphereSpacing::paper_touching, SphereSpacing::medial, SphereSpacing::minimax_volume})
    if (code == static_cast<double>(known))
      return known;
  throw bad_value(
      frame, row,
      "f_spacing 0 (paper), 1 (minimax_outline), 2 (minimax_area), 3 (paper_touching), 4 (medial), "
      "5 (minimax_volume), or 1000 and the number of a clump",
      fmt::format("{}", code));
}

/// @param[in] scale of the set's lengths
void add_spheres(ParticleSet& set, Particle& particle, const SphereSet& spheres, double scale) {
  const Rotation3 r = rotation(particle.orientation);
  particle.first_sphere = set.spheres.size();
  particle.sphere_count = spheres.centres.size();
  for (std::size_t k = 0; k < spheres.centres.size(); ++k)
    set.spheres.push_back(
        {particle.centre + r.to_space(scale * spheres.centres[k]), scale * spheres.radii[k]});
}

void add_clump(ParticleSet& set, Particle& particle, const ClumpTemplate& clump) {
  const double size = particle.semiaxes.y / clump.semiaxes.y;
  particle.moments_per_mass = (size * size / clump.volume) * clump.moments;
  add_spheres(set, particle, clump.spheres, particle.semiaxes.y);
}

/// Everything of a row but its shape.
class CommonColumns {
 public:
  explicit CommonColumns(const NamedColumns& columns)
      : m_frame(columns.frame()), m_position(columns), m_id(columns.find("id")),
        m_type(columns.find("type")), m_mass(columns.find("mass")),
        m_velocity(columns.find("vx", "vy", "vz")),
        m_spin(columns.find("omegax", "omegay", "omegaz")) {}

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

/// Rows in the order of their ids. Throws InputError where one comes twice.
std::vector<std::size_t> rows_by_id(const NamedColumns& columns) {
  const Frame& frame = columns.frame();
  std::vector<std::size_t> order(frame.rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const Column id = columns.find("id");
  if (!id)
    return order;
  if (!std::is_sorted(id->begin(), id->end()))
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return (*id)[i] < (*id)[j]; });
  for (std::size_t k = 1; k < order.size(); ++k)
    if ((*id)[order[k]] == (*id)[order[k - 1]])
      throw bad_value(frame, order[k], "ids that come once",
                      fmt::format("id {} a second time", (*id)[order[k]]));
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

/// Whether a body's spheres come in pairs about its centre: that is then the mass centre.
bool is_symmetric(const Sphere* begin, const Sphere* end, const Vector3& centre) {
  constexpr double same = 1e-5; // of a radius: six digits in the file
  return std::all_of(begin, end, [&](const Sphere& s) {
    const Vector3 twin = 2.0 * centre - s.centre;
    return std::any_of(begin, end, [&](const Sphere& t) {
      return norm(t.centre - twin) <= same * s.radius &&
             std::abs(t.radius - s.radius) <= same * s.radius;
    });
  });
}

/// Velocity of a body's centre, from one of its spheres and the spin; the host writes the body's
/// spin and mass to each of its spheres.
void take_motion(Particle& body, const Particle& sphere, const NamedColumns& columns) {
  body.velocity = sphere.velocity + cross(sphere.angular_velocity, body.centre - sphere.centre);
  if (sphere.mass != body.mass || norm(sphere.angular_velocity - body.angular_velocity) != 0.0)
    throw bad_value(columns.frame(), sphere.row,
                    "the mass and the angular velocity of the whole body in each of its rows",
                    "others than in the body's first row");
}

/// A body of the host from the rows of its spheres.
Particle host_body(ParticleSet& set, const std::vector<std::size_t>& rows,
                   const CommonColumns& common, const Sizes& sizes, const NamedColumns& columns) {
  Particle body = common.at(rows.front());
  body.first_sphere = set.spheres.size();
  body.sphere_count = rows.size();
  for (const std::size_t row : rows)
    set.spheres.push_back({common.at(row).centre, sizes.at(row).x});
  enclose(body, set.spheres);
  if (rows.size() > 1)
    for (const std::size_t row : rows)
      take_motion(body, common.at(row), columns);
  const Sphere* first = set.spheres.data() + body.first_sphere;
  set.asymmetric_bodies += is_symmetric(first, first + body.sphere_count, body.centre) ? 0 : 1;
  return body;
}

void add_host_bodies(ParticleSet& set, const std::vector<double>& body_of_row,
                     const NamedColumns& columns, const ParticleOptions& options) {
  const Sizes sizes(columns, options);
  const CommonColumns common(columns);
  std::map<std::int64_t, std::vector<std::size_t>> rows_of_body;
  std::int64_t single = -1; // rows of no body are spheres of their own
  for (const std::size_t row : rows_by_id(columns)) {
    const std::int64_t body = whole_number(columns.frame(), row, "body", body_of_row[row]);
    rows_of_body[body > 0 ? body : single--].push_back(row);
  }
  for (const auto& [body, rows] : rows_of_body) {
    Particle p = host_body(set, rows, common, sizes, columns);
    if (body > 0)
      p.id = body;
    set.particles.push_back(p);
  }
}

/// The column that joins rows to bodies, or null. Throws InputError where that is not sure.
Column bodies_of(const NamedColumns& columns, const ParticleOptions& options) {
  const auto joins = [](Column body) {
    return body && std::any_of(body->begin(), body->end(), [](double b) { return b > 0.0; });
  };
  if (options.bodies == "none")
    return nullptr;
  if (!options.bodies.empty())
    return &columns.frame().required(options.bodies, "--bodies");
  const bool has_shapes = columns.find("shapex") || columns.find("c_shape[1]");
  if (const Column host = columns.find("id_multisphere"); joins(host)) {
    if (has_shapes)
      throw InputError("the file has shapes and a column \"id_multisphere\" with bodies: --bodies "
                       "id_multisphere takes its rows as spheres of bodies, --bodies none as "
                       "particles of their own");
    return host;
  }
  if (!has_shapes && joins(columns.find("mol")))
    throw InputError("the column \"mol\" may join spheres to rigid bodies or be a mere label: say "
                     "--bodies mol or --bodies none");
  return nullptr;
}

/// Superquadrics other than ellipsoids cannot be measured.
void refuse_blocks(const NamedColumns& columns) {
  for (const char* name : {"blockiness1", "blockiness2", "blockiness[1]", "blockiness[2]"})
    if (const Column blockiness = columns.find(name))
      for (std::size_t row = 0; row < blockiness->size(); ++row)
        if ((*blockiness)[row] != 2.0)
          throw bad_value(columns.frame(), row, fmt::format("{} 2, an ellipsoid", name),
                          fmt::format("{}", (*blockiness)[row]));
}

/// The frame's box, with what the user says of its sides.
Box box_of(const Frame& frame, const std::string& periodic) {
  Box box = frame.box;
  if (periodic.empty())
    return box;
  box.boundary.clear();
  for (const char axis : {'x', 'y', 'z'})
    box.boundary += std::string(box.boundary.empty() ? "" : " ") +
                    (periodic != "none" && periodic.find(axis) != std::string::npos ? "pp" : "ff");
  return box;
}

/// An option for files without a column beside that column.
void refuse_both(Column column, bool is_given, const char* option, const char* name) {
  if (column && is_given)
    throw InputError(fmt::format("{} is for files without the column \"{}\", which this one has: "
                                 "leave it out",
                                 option, name));
}

void add_ellipsoids(ParticleSet& set, const NamedColumns& columns, const ParticleOptions& options) {
  const Frame& frame = columns.frame();
  const Sizes sizes(columns, options);
  const Orientations orientations(columns);
  const CommonColumns common(columns);
  const Column subspheres = columns.find("f_subspheres"), spacing = columns.find("f_spacing");
  refuse_both(subspheres, options.subspheres.has_value(), "--subspheres", "f_subspheres");
  refuse_both(spacing, options.spacing.has_value(), "--spacing", "f_spacing");
  if (const std::string remark = sizes.remark(); !remark.empty())
    set.remarks.push_back(remark);
  TemplateCache templates;
  const ClumpFiles clumps(options.clumps);
  set.particles.reserve(frame.rows);
  for (const std::size_t row : rows_by_id(columns)) {
    Particle p = common.at(row);
    p.semiaxes = sizes.at(row);
    p.orientation = orientations.at(row, p.semiaxes);
    if (const int count = subspheres_at(frame, subspheres, row, options); count > 0) {
      const double code = spacing ? (*spacing)[row] : 0.0;
      try {
        if (code > clump_spacing)
          add_clump(set, p, clumps.find(code, count, p.semiaxes));
        else
          add_spheres(set, p,
                      templates.find(p.semiaxes, count, spacing_at(frame, spacing, row, options)),
                      1.0);
      } catch (const std::invalid_argument& error) {
        throw bad_value(frame, row, "a multi-sphere particle that can be built", error.what());
      }
    }
    set.particles.push_back(p);
  }
}

} // namespace

double Particle::largest_axis() const { return std::max({semiaxes.x, semiaxes.y, semiaxes.z}); }
Vector3 Particle::long_axis() const {
  const Rotation3 r = rotation(orientation);
  const double largest = largest_axis();
  return semiaxes.x == largest ? r.column_x : semiaxes.y == largest ? r.column_y : r.column_z;
}
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
  const NamedColumns columns(frame, options.columns);
  ParticleSet set;
  set.box = box_of(frame, options.periodic);
  set.has_velocities = static_cast<bool>(columns.find("vx", "vy", "vz"));
  set.has_spins = static_cast<bool>(columns.find("omegax", "omegay", "omegaz"));
  refuse_blocks(columns);
  if (const Column body = bodies_of(columns, options))
    add_host_bodies(set, *body, columns, options);
  else
    add_ellipsoids(set, columns, options);
  return set;
}

} // namespace ellipsoid::post
