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
const std::vector<std::string> unwrapped_names = {"xu", "yu", "zu"};
const std::vector<std::string> unwrapped_scaled_names = {"xsu", "ysu", "zsu"};
const std::vector<std::string> image_names = {"ix", "iy", "iz"};
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

PositionColumns::PositionColumns(const NamedColumns& columns) : frame_(columns.frame()) {
  for (const std::string suffix : {"", "u", "s", "su"})
    if (!plain_ && !scaled_) {
      VectorColumns& found = suffix[0] == 's' ? scaled_ : plain_;
      found = columns.find("x" + suffix, "y" + suffix, "z" + suffix);
      are_unwrapped_ = found && suffix.back() == 'u';
    }
  if (!plain_ && !scaled_)
    require_all(frame_, {"x", "y", "z"}, "the position of the particles");
  find_ways(columns);
}

void PositionColumns::find_ways(const NamedColumns& columns) {
  if (are_unwrapped_)
    tells_ways_ = true;
  for (VectorColumns* found : {&unwrapped_plain_, &unwrapped_scaled_, &images_}) {
    const std::vector<std::string>& names = found == &unwrapped_plain_    ? unwrapped_names
                                            : found == &unwrapped_scaled_ ? unwrapped_scaled_names
                                                                          : image_names;
    const Availability availability = availability_of(columns, names);
    if (are_unwrapped_ || !(availability.is_known() || !availability.fault().empty()))
      continue;
    tells_ways_ = availability;
    *found = known_vector(columns, availability, names);
    break;
  }
  if (images_)
    tells_ways_ = Availability(true, fault_of_images());
}

/// The first image flag that is no whole number, or that has no box to count, as a message; or
/// nothing.
std::string PositionColumns::fault_of_images() const {
  const bool has_box = norm(unscaled(Vector3{1.0, 1.0, 1.0}) - unscaled(Vector3{})) > 0.0;
  for (std::size_t row = 0; row < frame_.rows; ++row)
    for (const Column column : {images_.x, images_.y, images_.z})
      if ((*column)[row] != std::floor((*column)[row]))
        return bad_value(frame_, row, "whole numbers ix iy iz, how often a particle went around",
                         fmt::format("{}", (*column)[row]))
            .what();
      else if (!has_box && (*column)[row] != 0.0)
        return bad_value(frame_, row,
                         "a box beside the image flags ix iy iz (VTK files have none: take text "
                         "dumps)",
                         fmt::format("a particle that went {} times around it", (*column)[row]))
            .what();
  return "";
}

Vector3 PositionColumns::unwrapped(std::size_t row) const {
  if (unwrapped_plain_)
    return unwrapped_plain_.at(row);
  if (unwrapped_scaled_)
    return unscaled(unwrapped_scaled_.at(row));
  if (!images_)
    return at(row);
  const Vector3 times = images_.at(row);
  return at(row) + unscaled(times) - unscaled(Vector3{});
}

Vector3 PositionColumns::at(std::size_t row) const {
  const Vector3 centre = plain_ ? plain_.at(row) : unscaled(scaled_.at(row));
  for (const double x : {centre.x, centre.y, centre.z})
    if (!(std::abs(x) < largest_length))
      throw bad_value(frame_, row, fmt::format("a position within +-{}", largest_length),
                      fmt::format("{}", x));
  return centre;
}

Vector3 PositionColumns::unscaled(const Vector3& s) const {
  const Box& box = frame_.box;
  const Vector3 lower{box.lower[0], box.lower[1], box.lower[2]};
  const auto& edges = box.tilted_edges;
  if (!edges.empty())
    return lower + s.x * edges[0] + s.y * edges[1] + s.z * edges[2];
  return lower + Vector3{s.x * (box.upper[0] - lower.x), s.y * (box.upper[1] - lower.y),
                         s.z * (box.upper[2] - lower.z)};
}

SizeColumns::SizeColumns(const NamedColumns& columns, const ParticleOptions& options)
    : frame_(columns.frame()), given_(options.semiaxes),
      shape_(columns.find("shapex", "shapey", "shapez")) {
  const bool is_named = columns.is_assigned("shapex"), is_plain = static_cast<bool>(shape_);
  const bool has_other_orientation =
      !columns.has("quat1") && (columns.has("quatw") || columns.has("c_orient[4]"));
  is_scale_given_ = options.size_scale.has_value();
  if (!is_plain)
    shape_ = columns.find("c_diameter[1]", "c_diameter[2]", "c_diameter[3]");
  are_whole_axes_ = !is_named && shape_ && (!is_plain || has_other_orientation);
  if (!shape_) {
    shape_ = columns.find("c_shape[1]", "c_shape[2]", "c_shape[3]");
    if (shape_ && !is_scale_given_)
      throw InputError(
          "the columns c_shape[*] hold semi-axes where LIGGGHTS or a LAMMPS older than "
          "July 2020 wrote them, whole axes where a later LAMMPS did: say which, "
          "--size-scale 1 or --size-scale 0.5");
  }
  scale_ = options.size_scale.value_or(are_whole_axes_ ? 0.5 : 1.0);
  if (!shape_) {
    radius_ = columns.find("radius");
    if (!columns.is_assigned("radius"))
      diameter_ = columns.find("diameter");
  }
  if (!given_.empty() && (shape_ || radius_ || diameter_))
    throw InputError("--semiaxes is for files without sizes: this one has columns with them; leave "
                     "it out");
  if (given_.empty() && !shape_ && !radius_ && !diameter_)
    require_all(frame_, {"shapex", "shapey", "shapez"},
                "the semi-axes of the particles; or a column \"radius\", or give --semiaxes a b c");
}

std::string SizeColumns::remark() const {
  return are_whole_axes_ && !is_scale_given_
             ? "sizes beside LAMMPS's names of the orientation are taken as whole axes and "
               "halved; --size-scale 1 takes them as semi-axes, --size-scale 0.5 as whole ones"
             : "";
}

Vector3 SizeColumns::at(std::size_t row) const {
  const Vector3 s = scale_ * raw(row);
  for (const double axis : {s.x, s.y, s.z})
    if (!(axis > smallest_size && axis < largest_length))
      throw bad_value(frame_, row,
                      fmt::format("semi-axes > 0 (and {} to {})", smallest_size, largest_length),
                      fmt::format("{} {} {}", s.x, s.y, s.z));
  if (std::max({s.x, s.y, s.z}) > largest_aspect_ratio * std::min({s.x, s.y, s.z}))
    throw bad_value(frame_, row,
                    fmt::format("semi-axes within a factor of {}", largest_aspect_ratio),
                    fmt::format("{} {} {}", s.x, s.y, s.z));
  return s;
}

Vector3 SizeColumns::raw(std::size_t row) const {
  if (!given_.empty())
    return {given_[0], given_[1], given_[2]};
  if (shape_)
    return shape_.at(row);
  const double radius = radius_ ? (*radius_)[row] : 0.5 * (*diameter_)[row];
  constexpr double six_digits = 1e-5; // of a column in the host's default format
  if (radius_ && diameter_ && std::abs((*diameter_)[row] - 2.0 * radius) > six_digits * radius)
    throw bad_value(
        frame_, row, fmt::format("a diameter of twice the radius {}", radius),
        fmt::format("{}; --column radius=NAME takes the column NAME alone", (*diameter_)[row]));
  return {radius, radius, radius};
}

OrientationColumns::OrientationColumns(const NamedColumns& columns) : frame_(columns.frame()) {
  const std::vector<std::vector<std::string>> names = {
      {"quat1", "quat2", "quat3", "quat4"},
      {"quatw", "quati", "quatj", "quatk"},
      {"quatw", "quatx", "quaty", "quatz"},
      {"c_orient[4]", "c_orient[1]", "c_orient[2]", "c_orient[3]"}};
  for (const std::vector<std::string>& q : names) {
    const Availability availability = availability_of(columns, q);
    if (availability.is_known()) {
      w_ = columns.find(q[0]);
      x_ = columns.find(q[1]);
      y_ = columns.find(q[2]);
      z_ = columns.find(q[3]);
      is_order_assumed_ = q[0] == "c_orient[4]";
    }
    fault_ = availability.fault();
    if (w_ || !fault_.empty())
      return;
  }
  if (columns.has("c_q[1]") && columns.has("c_q[4]"))
    throw InputError("the order of the quaternion in the columns c_q[*] is not known: say it, for "
                     "example --column quat1=c_q[1] --column quat2=c_q[2] --column quat3=c_q[3] "
                     "--column quat4=c_q[4] (quat1: scalar part)");
}

std::string OrientationColumns::remark() const {
  return is_order_assumed_
             ? "c_orient[1] to c_orient[4] are taken as quati quatj quatk quatw, as OVITO takes "
               "them; for another order say --column quat1=c_orient[1] (the scalar part) and so on "
               "to quat4"
             : "";
}

Quaternion OrientationColumns::at(std::size_t row, const Vector3& semiaxes) const {
  const bool is_sphere = semiaxes.x == semiaxes.y && semiaxes.y == semiaxes.z;
  if (!w_) {
    if (!is_sphere && !fault_.empty())
      throw InputError(fault_);
    if (!is_sphere)
      require_all(frame_, {"quat1", "quat2", "quat3", "quat4"},
                  "the orientation, quat1 (scalar part) to quat4");
    return {};
  }
  const Quaternion q{(*w_)[row], (*x_)[row], (*y_)[row], (*z_)[row]};
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  constexpr double off_unit = 1e-3; // six digits in the file leave 1e-6; 1e-3 is no quaternion
  if (std::abs(length - 1.0) > off_unit && !is_sphere)
    throw bad_value(frame_, row, "a quaternion quat1..quat4 of length 1",
                    fmt::format("length {}", length));
  return length > 0.0 ? normalized(q) : Quaternion{};
}

CommonColumns::CommonColumns(const NamedColumns& columns)
    : frame_(columns.frame()), position_(columns), id_(columns.find("id")),
      has_types_(availability_of(columns, {"type"})),
      has_masses_(availability_of(columns, {"mass"})),
      has_velocities_(availability_of(columns, velocity_names)),
      has_spins_(availability_of(columns, spin_names)),
      has_moments_(availability_of(columns, moment_names)) {
  type_ = has_types_.is_known() ? columns.find("type") : nullptr;
  mass_ = has_masses_.is_known() ? columns.find("mass") : nullptr;
  velocity_ = known_vector(columns, has_velocities_, velocity_names);
  spin_ = known_vector(columns, has_spins_, spin_names);
  moments_ = known_vector(columns, has_moments_, moment_names);
}

Particle CommonColumns::at(std::size_t row) const {
  Particle p;
  p.row = row;
  p.id = id_ ? whole_number(frame_, row, "id", (*id_)[row]) : static_cast<std::int64_t>(row) + 1;
  p.type = type_ ? whole_number(frame_, row, "type", (*type_)[row]) : 1;
  p.mass = mass_ ? (*mass_)[row] : 0.0;
  p.centre = position_.at(row);
  p.unwrapped_centre = position_.unwrapped(row);
  if (velocity_)
    p.velocity = velocity_.at(row);
  if (spin_)
    p.angular_velocity = spin_.at(row);
  if (moments_)
    p.principal_moments = moments_.at(row);
  return p;
}

void CommonColumns::describe(ParticleSet& set) const {
  set.has_types = has_types_;
  set.has_masses = has_masses_;
  set.has_velocities = has_velocities_;
  set.has_spins = has_spins_;
  set.has_moments = has_moments_;
  set.tells_ways = position_.tells_ways();
}

} // namespace ellipsoid::post
