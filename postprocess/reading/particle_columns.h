// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the columns of a frame say of a particle: position, size, orientation, motion. Values are
// asked for by row; a column that holds something else than numbers stops those only who need it.
#pragma once

#include "particles.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// The error of a bad value in a row of the frame.
InputError bad_value(const Frame& frame, std::size_t row, const std::string& expected,
                     const std::string& found);

/// A number of a particle, type or body: a whole number that a double holds exactly.
std::int64_t whole_number(const Frame& frame, std::size_t row, const char* what, double value);

/// Rows in the order of their ids. Throws InputError where one comes twice.
std::vector<std::size_t> rows_by_id(const NamedColumns& columns);

/// Positions in the box: plain, unwrapped or scaled coordinates.
class PositionColumns {
 public:
  explicit PositionColumns(const NamedColumns& columns);
  Vector3 at(std::size_t row) const;
  /// Whether they go on beyond the faces of a box that repeats.
  bool are_unwrapped() const { return m_are_unwrapped; }

 private:
  Vector3 unscaled(const Vector3& s) const;

  const Frame& m_frame;
  VectorColumns m_plain, m_scaled;
  bool m_are_unwrapped = false;
};

/// Semi-axes: from the options, from shape columns or from a radius.
class SizeColumns {
 public:
  SizeColumns(const NamedColumns& columns, const ParticleOptions& options);
  /// What was taken for granted, or nothing.
  std::string remark() const;
  Vector3 at(std::size_t row) const;

 private:
  Vector3 raw(std::size_t row) const;

  const Frame& m_frame;
  double m_scale = 1.0;
  bool m_are_whole_axes = false, m_is_scale_given = false;
  std::vector<double> m_given;
  VectorColumns m_shape;
  Column m_radius = nullptr, m_diameter = nullptr;
};

/// Orientations; spheres need none.
class OrientationColumns {
 public:
  explicit OrientationColumns(const NamedColumns& columns);
  Quaternion at(std::size_t row, const Vector3& semiaxes) const;

 private:
  const Frame& m_frame;
  std::string m_fault; ///< a value that is no number
  Column m_w = nullptr, m_x = nullptr, m_y = nullptr, m_z = nullptr;
};

/// Everything of a row but its shape.
class CommonColumns {
 public:
  explicit CommonColumns(const NamedColumns& columns);
  Particle at(std::size_t row) const;
  /// Tells a set what its particles have.
  void describe(ParticleSet& set) const;
  bool is_unwrapped() const { return m_position.are_unwrapped(); }

 private:
  const Frame& m_frame;
  PositionColumns m_position;
  Column m_id;
  Column m_type = nullptr, m_mass = nullptr;
  VectorColumns m_velocity, m_spin, m_moments;
  Availability m_has_types, m_has_masses, m_has_velocities, m_has_spins, m_has_moments;
};

} // namespace ellipsoid::post
