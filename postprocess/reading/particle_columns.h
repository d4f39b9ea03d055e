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

/// Positions in the box: plain, unwrapped or scaled coordinates; and how often particles went
/// around the box, by unwrapped coordinates or by image flags ix iy iz.
class PositionColumns {
 public:
  explicit PositionColumns(const NamedColumns& columns);
  Vector3 at(std::size_t row) const;
  /// Whether at() goes on beyond the faces of a box that repeats.
  bool are_unwrapped() const { return are_unwrapped_; }
  /// Whether unwrapped() does.
  const Availability& tells_ways() const { return tells_ways_; }
  /// The same as at() where the file does not tell.
  Vector3 unwrapped(std::size_t row) const;

 private:
  void find_ways(const NamedColumns& columns);
  std::string fault_of_images() const;
  Vector3 unscaled(const Vector3& s) const;

  const Frame& frame_;
  VectorColumns plain_, scaled_;                              ///< one of them: where particles are
  VectorColumns unwrapped_plain_, unwrapped_scaled_, images_; ///< one of them, or none
  bool are_unwrapped_ = false;
  Availability tells_ways_;
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

  const Frame& frame_;
  double scale_ = 1.0;
  bool are_whole_axes_ = false, is_scale_given_ = false;
  std::vector<double> given_;
  VectorColumns shape_;
  Column radius_ = nullptr, diameter_ = nullptr;
};

/// Orientations; spheres need none.
class OrientationColumns {
 public:
  explicit OrientationColumns(const NamedColumns& columns);
  Quaternion at(std::size_t row, const Vector3& semiaxes) const;
  bool are_there() const { return w_ != nullptr; }
  /// How the order of the columns was understood where it could be another; or nothing.
  std::string remark() const;

 private:
  const Frame& frame_;
  std::string fault_; ///< a value that is no number
  bool is_order_assumed_ = false;
  Column w_ = nullptr, x_ = nullptr, y_ = nullptr, z_ = nullptr;
};

/// Everything of a row but its shape.
class CommonColumns {
 public:
  explicit CommonColumns(const NamedColumns& columns);
  Particle at(std::size_t row) const;
  /// Tells a set what its particles have.
  void describe(ParticleSet& set) const;
  bool is_unwrapped() const { return position_.are_unwrapped(); }

 private:
  const Frame& frame_;
  PositionColumns position_;
  Column id_;
  Column type_ = nullptr, mass_ = nullptr;
  VectorColumns velocity_, spin_, moments_;
  Availability has_types_, has_masses_, has_velocities_, has_spins_, has_moments_;
};

} // namespace ellipsoid::post
