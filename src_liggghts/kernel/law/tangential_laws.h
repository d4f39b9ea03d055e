// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Tangential contact laws, of the same form as normal_laws.h. A law with memory has a spring, which
// advance() carries on from step to step, and names the first of the three values of the contact's
// history that keep it.
#pragma once

#include "law/contact_law.h"

#include <cmath>

namespace ellipsoid {

/// What tangential laws know of a contact.
template <class Vector> struct SlidingContact {
  NormalResponse normal;
  double reduced_mass;      ///< m_ij
  Vector relative_velocity; ///< tangential (length/time)
};

/// Spring, dashpot in proportion to the mass, Coulomb's limit: Markauskas et al. 2010, eq. 24.
template <SlipDirection direction> struct HistoryViscous {
  static constexpr const char* style =
      direction == SlipDirection::velocity ? "history/viscous velocity" : "history/viscous";
  enum { friction_coefficient, damping };
  static constexpr const char* parameters[] = {"coeffFrict", "viscousDampingTangential"};
  static constexpr const char* memory = "springx";

  template <class Vector>
  static void advance(Vector& spring, const Vector& velocity, double time_step,
                      const Vector& normal) {
    advance_spring(spring, velocity, time_step, normal);
  }

  template <class Vector, class Parameters>
  static Vector force(const SlidingContact<Vector>& c, const Parameters& p, Vector& spring) {
    return friction<direction, Vector>({c.normal.tangential_stiffness, p(damping) * c.reduced_mass,
                                        p(friction_coefficient) * std::fabs(c.normal.force),
                                        c.relative_velocity},
                                       spring);
  }
};

/// The host's spring: projected to the tangent plane, no dashpot while it slips.
struct History {
  static constexpr const char* style = "history";
  enum { friction_coefficient };
  static constexpr const char* parameters[] = {"coeffFrict"};
  static constexpr const char* memory = "shearx";

  template <class Vector>
  static void advance(Vector& spring, const Vector& velocity, double time_step,
                      const Vector& normal) {
    const Vector grown = spring + time_step * velocity;
    spring = grown - dot(grown, normal) * normal;
  }

  template <class Vector, class Parameters>
  static Vector force(const SlidingContact<Vector>& c, const Parameters& p, Vector& spring) {
    const double stiffness = c.normal.tangential_stiffness;
    const double elastic = stiffness * norm(spring),
                 limit = p(friction_coefficient) * std::fabs(c.normal.force);
    const bool slips = elastic > limit;
    const Vector pull = (slips ? limit / elastic : 1.0) * (-stiffness * spring);
    const double damping = slips ? 0.0 : c.normal.tangential_damping;
    spring = chosen(slips, (-1.0 / stiffness) * pull, spring); // stiffness > 0 where it slips
    return pull - damping * c.relative_velocity;
  }
};

/// The host's dashpot with Coulomb's limit.
struct NoHistory {
  static constexpr const char* style = "no_history";
  enum { friction_coefficient };
  static constexpr const char* parameters[] = {"coeffFrict"};
  static constexpr const char* memory = "";

  template <class Vector, class Parameters>
  static Vector force(const SlidingContact<Vector>& c, const Parameters& p, Vector&) {
    const double speed = norm(c.relative_velocity),
                 limit = p(friction_coefficient) * std::fabs(c.normal.force);
    const double damping =
        limit < c.normal.tangential_damping * speed ? limit / speed : c.normal.tangential_damping;
    return -damping * c.relative_velocity;
  }
};

/// No tangential force.
struct NoFriction {
  static constexpr const char* style = "off";
  static constexpr const char* memory = "";

  template <class Vector, class Parameters>
  static Vector force(const SlidingContact<Vector>&, const Parameters&, Vector&) {
    return {};
  }
};

} // namespace ellipsoid
