// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The simulation box as a cell that repeats: shortest distances, images, distances of its planes.
#pragma once

#include "frame.h"
#include "math/vector3.h"

#include <array>
#include <vector>

namespace ellipsoid::post {

/// A parallelepiped that repeats along some of its edges.
class PeriodicCell {
 public:
  PeriodicCell() = default; ///< repeats nowhere
  /// @param[in] corner, edges (length); edges that repeat must span a volume
  PeriodicCell(const Vector3& corner, const std::array<Vector3, 3>& edges,
               const std::array<bool, 3>& is_periodic);
  /// The box of a frame; it repeats where both sides of an axis are "p".
  explicit PeriodicCell(const Box& box);

  const Vector3& corner() const { return corner_; }
  const Vector3& edge(std::size_t k) const { return edges_[k]; }
  bool is_periodic(std::size_t k) const { return is_periodic_[k]; }
  bool is_periodic() const { return is_periodic_[0] || is_periodic_[1] || is_periodic_[2]; }
  /// Whether edges are not along x, y, z.
  bool is_tilted() const;
  double volume() const; ///< (length^3)
  /// Distance of the two planes that the edge k connects (length).
  double thickness(std::size_t k) const;

  /// Shares of the edges: 0 to 1 inside the cell.
  Vector3 fractions(const Vector3& point) const;
  /// The image of a point that lies in the cell, along the edges that repeat.
  Vector3 wrapped(const Vector3& point) const;
  /// The shortest of all images of a distance.
  Vector3 nearest(const Vector3& distance) const;

  /// How far a point lies beyond the farthest of the planes that repeat (length); 0 inside.
  double distance_beyond(const Vector3& point) const;

  /// Shifts from the cell to its images whose planes are not farther than `reach` from the cell's
  /// (length); the first one is zero. Throws InputError for more than 1e5 of them.
  std::vector<Vector3> shifts(double reach) const;

 private:
  void prepare();

  Vector3 corner_;
  std::array<Vector3, 3> edges_{Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0},
                                Vector3{0.0, 0.0, 1.0}};
  std::array<bool, 3> is_periodic_{false, false, false};
  std::array<Vector3, 3> reciprocal_{Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0},
                                     Vector3{0.0, 0.0, 1.0}}; ///< fractions = reciprocal . point
  std::vector<Vector3> neighbours_; ///< shifts to the images around a tilted cell
};

} // namespace ellipsoid::post
