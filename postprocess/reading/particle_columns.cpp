// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particle_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace ellipsoid::post {
namespace {

/// Beyond these the squares and products of lengths overflow or vanish; no unit system needs them.
constexpr double smallest_size = 1.0e-30, largest_length = 1.0e30;

/// Longest semi-axis over shortest: sections of a body lose two digits for every factor of ten.
constexpr double largest_aspect_ratio = 1.0e4;

/// Throws for the first of several columns that is missing.
void require_all(const Frame& frame, const std::vector<std::string>& names,
                 const std::string& purpose) {
  for (const std::string& name : names)
    frame.required(name, purpose);
}

/// Columns that may be there; what is no number in them is told to those who ask for them.
Availability availability_of(const NamedColumns& columns, const std::vector<std::string>& names) {
  const bool are_there = std::all_of(names.begin(), names.end(),
                                     [&](const std::string& name) { return columns.has(name); });
  return {are_there, are_there ? columns.fault(names) : ""};
}

VectorColumns known_vector(const NamedColumns& columns, const Availability& availability,
                           const std::vector<std::string>& names) {
  return availability.is_known() ? columns.find(names[0], names[1], names[2]) : VectorColumns();
}

const std::vector<std::string> velocity_names = {"vx", "vy", "vz"};
const std::vector<std::string> spin_names = {"omegax", "omegay", "omegaz"};
const std::vector<std::string> moment_names = {"inertiax", "inertiay", "inertiaz"};

} // namespace

InputError bad_value(const Frame& frame, std::size_t row, const std::string& expected,
                     const std::string& found) {
  FileLocation location = frame.location;
  location.line += row;
  return unexpected(location, expected, found);
}

std::int64_t whole_number(const Frame& frame, std::size_t row, const char* what, double value) {
  constexpr double largest = 9.0e15;
  if (value != std::floor(value) || std::abs(value) > largest)
    throw bad_value(frame, row, fmt::format("a whole number ({})", what), fmt::format("{}", value));
  return static_cast<std::int64_t>(value);
}

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

PositionColumns::PositionColumns(const NamedColumns& columns) : m_frame(columns.frame()) {
  for (const std::string suffix : {"", "u", "s", "su"})
    if (!m_plain && !m_scaled) {
      VectorColumns& found = suffix[0] == 's' ? m_scaled : m_plain;
      found = columns.find("x" + suffix, "y" + suffix, "z" + suffix);
      m_are_unwrapped = found && suffix.back() == 'u';
    }
  if (!m_plain && !m_scaled)
    require_all(m_frame, {"x", "y", "z"}, "the position of the particles");
}

Vector3 PositionColumns::at(std::size_t row) const {
  const Vector3 centre = m_plain ? m_plain.at(row) : unscaled(m_scaled.at(row));
  for (const double x : {centre.x, centre.y, centre.z})
    if (!(std::abs(x) < largest_length))
      throw bad_value(m_frame, row, fmt::format("a position within +-{}", largest_length),
                      fmt::format("{}", x));
  return centre;
}

Vector3 PositionColumns::unscaled(const Vector3& s) const {
  const Box& box = m_frame.box;
  const Vector3 lower{box.lower[0], box.lower[1], box.lower[2]};
  const auto& edges = box.tilted_edges;
  if (!edges.empty())
    return lower + s.x * edges[0] + s.y * edges[1] + s.z * edges[2];
  return lower + Vector3{s.x * (box.upper[0] - lower.x), s.y * (box.upper[1] - lower.y),
                         s.z * (box.upper[2] - lower.z)};
}

SizeColumns::SizeColumns(const NamedColumns& columns, const ParticleOptions& options)
    : m_frame(columns.frame()), m_given(options.semiaxes),
      m_shape(columns.find("shapex", "shapey", "shapez")) {
  const VectorColumns computed =
      m_shape ? VectorColumns() : columns.find("c_shape[1]", "c_shape[2]", "c_shape[3]");
  const bool is_named = columns.is_assigned("shapex");
  m_are_whole_axes = !is_named && (m_shape ? columns.has("quatw") && !columns.has("quat1")
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
    throw InputError("--semiaxes is for files without sizes: this one has columns with them; leave "
                     "it out");
  if (m_given.empty() && !m_shape && !m_radius && !m_diameter)
    require_all(m_frame, {"shapex", "shapey", "shapez"},
                "the semi-axes of the particles; or a column \"radius\", or give --semiaxes a b c");
}

std::string SizeColumns::remark() const {
  return m_are_whole_axes && !m_is_scale_given
             ? "sizes beside LAMMPS's names of the orientation are taken as whole axes and "
               "halved; --size-scale 1 takes them as semi-axes, --size-scale 0.5 as whole ones"
             : "";
}

Vector3 SizeColumns::at(std::size_t row) const {
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

Vector3 SizeColumns::raw(std::size_t row) const {
  if (!m_given.empty())
    return {m_given[0], m_given[1], m_given[2]};
  if (m_shape)
    return m_shape.at(row);
  const double radius = m_radius ? (*m_radius)[row] : 0.5 * (*m_diameter)[row];
  return {radius, radius, radius};
}

OrientationColumns::OrientationColumns(const NamedColumns& columns) : m_frame(columns.frame()) {
  const std::vector<std::vector<std::string>> names = {
      {"quat1", "quat2", "quat3", "quat4"},
      {"quatw", "quati", "quatj", "quatk"},
      {"c_orient[4]", "c_orient[1]", "c_orient[2]", "c_orient[3]"}};
  for (const std::vector<std::string>& q : names) {
    const Availability availability = availability_of(columns, q);
    if (availability.is_known()) {
      m_w = columns.find(q[0]);
      m_x = columns.find(q[1]);
      m_y = columns.find(q[2]);
      m_z = columns.find(q[3]);
    }
    m_fault = availability.fault();
    if (m_w || !m_fault.empty())
      return;
  }
  if (columns.has("c_q[1]") && columns.has("c_q[4]"))
    throw InputError("the order of the quaternion in the columns c_q[*] is not known: say it, for "
                     "example --column quat1=c_q[1] --column quat2=c_q[2] --column quat3=c_q[3] "
                     "--column quat4=c_q[4] (quat1: scalar part)");
}

Quaternion OrientationColumns::at(std::size_t row, const Vector3& semiaxes) const {
  const bool is_sphere = semiaxes.x == semiaxes.y && semiaxes.y == semiaxes.z;
  if (!m_w) {
    if (!is_sphere && !m_fault.empty())
      throw InputError(m_fault);
    if (!is_sphere)
      require_all(m_frame, {"quat1", "quat2", "quat3", "quat4"},
                  "the orientation, quat1 (scalar part) to quat4");
    return {};
  }
  const Quaternion q{(*m_w)[row], (*m_x)[row], (*m_y)[row], (*m_z)[row]};
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  constexpr double off_unit = 1e-3; // six digits in the file leave 1e-6; 1e-3 is no quaternion
  if (std::abs(length - 1.0) > off_unit && !is_sphere)
    throw bad_value(m_frame, row, "a quaternion quat1..quat4 of length 1",
                    fmt::format("length {}", length));
  return length > 0.0 ? normalized(q) : Quaternion{};
}

CommonColumns::CommonColumns(const NamedColumns& columns)
    : m_frame(columns.frame()), m_position(columns), m_id(columns.find("id")),
      m_has_types(availability_of(columns, {"type"})),
      m_has_masses(availability_of(columns, {"mass"})),
      m_has_velocities(availability_of(columns, velocity_names)),
      m_has_spins(availability_of(columns, spin_names)),
      m_has_moments(availability_of(columns, moment_names)) {
  m_type = m_has_types.is_known() ? columns.find("type") : nullptr;
  m_mass = m_has_masses.is_known() ? columns.find("mass") : nullptr;
  m_velocity = known_vector(columns, m_has_velocities, velocity_names);
  m_spin = known_vector(columns, m_has_spins, spin_names);
  m_moments = known_vector(columns, m_has_moments, moment_names);
}

Particle CommonColumns::at(std::size_t row) const {
  Particle p;
  p.row = row;
  p.id = m_id ? whole_number(m_frame, row, "id", (*m_id)[row]) : static_cast<std::int64_t>(row) + 1;
  p.type = m_type ? whole_number(m_frame, row, "type", (*m_type)[row]) : 1;
  p.mass = m_mass ? (*m_mass)[row] : 0.0;
  p.centre = m_position.at(row);
  if (m_velocity)
    p.velocity = m_velocity.at(row);
  if (m_spin)
    p.angular_velocity = m_spin.at(row);
  if (m_moments)
    p.principal_moments = m_moments.at(row);
  return p;
}

void CommonColumns::describe(ParticleSet& set) const {
  set.has_types = m_has_types;
  set.has_masses = m_has_masses;
  set.has_velocities = m_has_velocities;
  set.has_spins = m_has_spins;
  set.has_moments = m_has_moments;
}

} // namespace ellipsoid::post
