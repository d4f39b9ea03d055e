// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The values of particles that a view can be coloured by, and their ranges over a whole run.
#pragma once

#include "frame.h"
#include "particles.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// One value of every particle of a frame; NaN where a particle has none.
struct ViewColumn {
  std::string name, unit;
  bool is_cyclic = false; ///< an axis' angle from 0 to 180 deg
  std::vector<double> values;
};

/// Speed, spin, two angles of the longest axis ("angle": of its picture in the xy plane to the x
/// axis, from 0 to 180 deg; "tilt": to the upward axis, from 0 to 90 deg; spheres have none), type,
/// and all other columns of the file that are no coordinates, orientations or sizes.
/// @param[in] up axis 0, 1 or 2
std::vector<ViewColumn> view_columns(const Frame& frame, const ParticleSet& set, unsigned up);

/// What values a column takes over all frames.
class ColumnRange {
 public:
  explicit ColumnRange(const ViewColumn& column);
  void add(const std::vector<double>& values);

  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }
  bool is_cyclic() const { return is_cyclic_; }
  /// Few different whole numbers: kinds, not amounts.
  bool is_of_kinds() const { return are_kinds_ && !kinds_.empty(); }
  std::vector<double> kinds() const { return {kinds_.begin(), kinds_.end()}; }
  double low() const { return low_; }
  double high() const { return high_; }
  /// Without the hundredth at each end, where strays would spread the colours too thin.
  std::pair<double, double> shown() const;

  static constexpr std::uint16_t missing = 65535; ///< code of a particle without a value
  static constexpr std::uint16_t largest_code = 65534;
  /// Of a value between low and high: number of its kind, or share of the range.
  std::uint16_t code_of(double value) const;

 private:
  static constexpr std::size_t most_kinds = 12, most_samples = 100000;

  std::string name_, unit_;
  bool is_cyclic_, are_kinds_ = true;
  std::set<double> kinds_;
  double low_, high_;
  std::vector<double> samples_;
  std::size_t seen_ = 0, stride_ = 1;
};

} // namespace ellipsoid::post
