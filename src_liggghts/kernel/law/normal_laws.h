// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Normal contact laws. A law is a class with the names of its material parameters (those of the
// host's properties per pair of atom types) and a function without branches that makes the response
// of a contact from them; a row in contact_laws.cpp registers it.
#pragma once

#include "law/contact_law.h"

#include <cmath>

namespace ellipsoid {

/// Elastic spheres of Hertz with a dashpot in proportion to the mass: Markauskas et al. 2010,
/// eq. 23.
struct HertzViscous {
  static constexpr const char* style = "hertz/viscous";
  enum { effective_modulus, effective_shear_modulus, damping };
  static constexpr const char* parameters[] = {"Yeff", "Geff", "viscousDampingNormal"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    const double root = std::sqrt(c.reduced_radius * c.overlap);
    const double stiffness = normal_stiffness(p(effective_modulus), root);
    return spring_and_dashpot(c, stiffness, p(damping) * c.reduced_mass,
                              tangential_stiffness(p(effective_shear_modulus), root), 0.0);
  }
};

/// Linear springs with a dashpot in proportion to the mass: Cundall and Strack 1979.
struct HookeViscous {
  static constexpr const char* style = "hooke/viscous";
  enum { normal_spring, tangential_spring, damping };
  static constexpr const char* parameters[] = {"springStiffnessNormal", "springStiffnessTangential",
                                               "viscousDampingNormal"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    return spring_and_dashpot(c, p(normal_spring), p(damping) * c.reduced_mass,
                              p(tangential_spring), 0.0);
  }
};

/// The host's Hertz: the dashpot follows from the coefficient of restitution e by
/// beta = ln e / sqrt(ln^2 e + pi^2) (Tsuji et al. 1992; Antypov and Elliott 2011).
struct Hertz {
  static constexpr const char* style = "hertz";
  enum { effective_modulus, effective_shear_modulus, beta };
  static constexpr const char* parameters[] = {"Yeff", "Geff", "betaeff"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    const double root = std::sqrt(c.reduced_radius * c.overlap);
    const double slope_n = 2.0 * p(effective_modulus) * root,
                 slope_t = 8.0 * p(effective_shear_modulus) * root;
    const double share = -2.0 * 0.91287092917527685576 * p(beta); // sqrt(5/6)
    const double stiffness = 4.0 / 3.0 * p(effective_modulus) * root;
    return spring_and_dashpot(c, stiffness, share * std::sqrt(slope_n * c.reduced_mass), slope_t,
                              share * std::sqrt(slope_t * c.reduced_mass));
  }
};

/// The host's linear spring whose stiffness makes, at a characteristic velocity, the same largest
/// overlap as Hertz's; dashpot from the coefficient of restitution.
struct Hooke {
  static constexpr const char* style = "hooke";
  enum { effective_modulus, characteristic_velocity, log_restitution };
  static constexpr const char* parameters[] = {"Yeff", "charVel", "coeffRestLog"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    const double plate = 16.0 / 15.0 * std::sqrt(c.reduced_radius) * p(effective_modulus);
    const double energy = c.reduced_mass * p(characteristic_velocity) * p(characteristic_velocity);
    const double stiffness = plate * std::pow(energy / plate, 0.2);
    const double squared = p(log_restitution) * p(log_restitution);
    const double damping =
        std::sqrt(4.0 * c.reduced_mass * stiffness * squared / (squared + M_PI * M_PI));
    return spring_and_dashpot(c, stiffness, damping, stiffness, damping);
  }
};

/// The host's Hertz with given stiffnesses and damping per sqrt(R h).
struct HertzStiffness {
  static constexpr const char* style = "hertz/stiffness";
  enum { normal_spring, tangential_spring, normal_damping, tangential_damping };
  static constexpr const char* parameters[] = {"k_n", "k_t", "gamma_n", "gamma_t"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    const double root = std::sqrt(c.reduced_radius * c.overlap), inertia = root * c.reduced_mass;
    return spring_and_dashpot(c, root * p(normal_spring), inertia * p(normal_damping),
                              root * p(tangential_spring), inertia * p(tangential_damping));
  }
};

/// The host's linear spring with given stiffnesses; damping per mass.
struct HookeStiffness {
  static constexpr const char* style = "hooke/stiffness";
  enum { normal_spring, tangential_spring, normal_damping, tangential_damping };
  static constexpr const char* parameters[] = {"k_n", "k_t", "gamman", "gammat"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    return spring_and_dashpot(c, p(normal_spring), c.reduced_mass * p(normal_damping),
                              p(tangential_spring), c.reduced_mass * p(tangential_damping));
  }
};

/// The same with damping that does not depend on the mass.
struct HookeStiffnessAbsolute {
  static constexpr const char* style = "hooke/stiffness absolute";
  enum { normal_spring, tangential_spring, normal_damping, tangential_damping };
  static constexpr const char* parameters[] = {"k_n", "k_t", "gamman_abs", "gammat_abs"};

  template <class Parameters>
  static NormalResponse response(const NormalContact& c, const Parameters& p) {
    return spring_and_dashpot(c, p(normal_spring), p(normal_damping), p(tangential_spring),
                              p(tangential_damping));
  }
};

} // namespace ellipsoid
