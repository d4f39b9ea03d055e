// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Neighbours among long or flat bodies, by their true shapes (broad phase with oriented bounds).
//
// Bounding spheres of long bodies overlap by the hundred where few bodies touch. Here each body is
// covered by a row of balls along its longest axis, the balls lie in grids (size_grids.h), and
// of bodies with near balls those are neighbours that two bounds (body_bounds.h) do not prove to be
// apart: their capsules, and the reach of their ellipsoids towards each other along the line of
// centres.
#pragma once

#include "math/vector3.h"
#include "neighbours/body_bounds.h"
#include "neighbours/size_grids.h"

#include <cstddef>
#include <vector>

namespace ellipsoid {

/// Arrays with a row per body.
struct BodyRows {
  const double* centres;     ///< 3 each (length)
  const double* quaternions; ///< 4 each: unit, real part first
  const BodyBounds* bounds;
  std::size_t count;
};

class LongBodies {
 public:
  /// Whether the bounding sphere of a body says little of where the body is.
  static bool is_long_or_flat(const double* semiaxes);

  /// @param[in] margin by which a body's surface may move (length): bodies nearer than two margins
  ///            are neighbours
  void build(const BodyRows& bodies, double margin);

  /// Neighbours of body i with a larger number than i, each once, in an order that depends on
  /// the bodies' poses and shapes only. A pair that is left out is farther apart than two margins.
  const std::vector<int>& find(int i);

 private:
  struct Body {
    Vector3 centre;
    Vector3 axes[3];     ///< semi-axes of the ellipsoid as vectors (length)
    Vector3 half_length; ///< of the capsule's segment, from its middle to an end (length)
    double radius;       ///< of the capsule (length)
    std::size_t balls;   ///< number of the first one
  };
  std::vector<Body> bodies_;
  std::vector<int> body_of_ball_;
  std::vector<int> last_asker_; ///< by body: whose neighbours were looked for when it was met
  std::vector<int> near_;
  SizeGrids grids_;
  double both_margins_ = 0.0;

  static Body body_of(const BodyRows& bodies, std::size_t k);
  void collect(int i);
  bool may_be_near(const Body& a, const Body& b) const;
};

} // namespace ellipsoid
