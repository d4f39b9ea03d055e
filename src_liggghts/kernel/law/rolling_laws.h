// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Laws of rolling friction, of the same form as normal_laws.h: the torque that acts against the
// relative rotation (Ai et al., Powder Technology 206 (2011) 269).
#pragma once

#include "math/plane.h"
#include "math/vector3.h"

#include <cmath>

namespace ellipsoid {

/// @tparam Axial Vector3 in space, double in the plane: along z
template <class Axial, class Vector> struct RollingContact {
  double elastic_force;        ///< k_n h
  double normal_force;         ///< F_n
  double reduced_radius;       ///< R (length)
  double tangential_stiffness; ///< k_t (force/length)
  double time_step;            ///< by which what is remembered grows (time)
  double torsion_share;        ///< 1: spin about the normal is resisted, too; 0: it is not
  Vector normal;               ///< unit
  Axial rate;                  ///< omega_i - omega_j (rad/time)

  Axial resisted(const Axial& v) const { return v - (1.0 - torsion_share) * part_along(v, normal); }
};

/// The host's constant directional torque.
struct ConstantTorque {
  static constexpr const char* style = "cdt";
  enum { rolling_friction };
  static constexpr const char* parameters[] = {"coeffRollFrict"};
  static constexpr const char* memory = "";

  template <class Contact, class Axial, class Parameters>
  static Axial torque(const Contact& c, const Parameters& p, Axial&) {
    const double speed = norm(c.rate);
    const double strength = p(rolling_friction) * c.elastic_force * c.reduced_radius;
    return c.resisted((speed > 0.0 ? strength / speed : 0.0) * c.rate);
  }
};

/// The host's elastic-plastic spring without dashpot.
struct ElasticPlastic {
  static constexpr const char* style = "epsd2";
  enum { rolling_friction };
  static constexpr const char* parameters[] = {"coeffRollFrict"};
  static constexpr const char* memory = "r_torquex_old";

  template <class Contact, class Axial, class Parameters>
  static Axial torque(const Contact& c, const Parameters& p, Axial& remembered) {
    const double stiffness = c.tangential_stiffness * c.reduced_radius * c.reduced_radius;
    const Axial trial = remembered + c.time_step * stiffness * c.resisted(c.rate);
    const double magnitude = norm(trial),
                 largest = std::fabs(c.normal_force) * c.reduced_radius * p(rolling_friction);
    remembered = (magnitude > largest ? largest / magnitude : 1.0) * trial;
    return remembered;
  }
};

} // namespace ellipsoid
