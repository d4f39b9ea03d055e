// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Stress and strain at the centres of particles, by coarse graining: stress after Goldhirsch 2010,
// at walls after Weinhart et al. 2012, strain after Zhang et al. 2010.
#pragma once

#include "averages/coarse_graining_function.h"
#include "averages/images_in_reach.h"
#include "math/vector3.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ellipsoid {

/// A particle or an image of one.
struct MovingMass {
  Vector3 position, velocity; ///< (length, length/time)
  double mass = 0.0;
};

/// A force between the centres of two particles, or between a centre and a wall.
struct ForceLine {
  Vector3 begin, end; ///< from the particle on which the force acts to the other (length)
  Vector3 force;      ///< on the particle at `begin`
};

/// Rows are those of the force or the velocity, columns those of the branch or the derivative.
using Tensor = std::array<double, 9>;

class FieldsAtParticles {
 public:
  /// @param[in] places   centres and velocities; the masses are not used
  /// @param[in] longest  no line is longer than this (length)
  FieldsAtParticles(const CoarseGrainingFunction& function, std::vector<MovingMass> places,
                    double longest);

  /// What lies outside contributes nothing.
  SpaceBlock reached() const { return reached_; }

  /// Every mass and every line, and each of their images, once; the places are masses as well.
  void add(const MovingMass& mass);
  void add(const ForceLine& line);

  /// Negative in compression (force/length^2).
  Tensor stress(std::size_t place) const;
  /// Symmetric part of the gradient of the mean velocity, positive in extension (1/time).
  Tensor strain_rate(std::size_t place) const;

 private:
  /// Velocities are relative to that of the place.
  struct Sums {
    double density = 0.0;
    Vector3 momentum, density_gradient;
    Tensor momentum_flux{}, momentum_gradient{}, contact_stress{};
  };
  using Cell = std::array<std::int64_t, 3>;

  CoarseGrainingFunction function_;
  std::vector<MovingMass> places_;
  std::vector<Sums> sums_;
  SpaceBlock reached_;
  double edge_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> places_of_cell_;

  Cell cell_of(const Vector3& point) const;
  static std::uint64_t key_of(const Cell& cell);
  template <class Action>
  void for_each_place_near(const Vector3& low, const Vector3& high, const Action& action) const;
};

} // namespace ellipsoid
