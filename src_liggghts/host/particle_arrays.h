// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The host's arrays of particles as they lie in memory: row behind row. Going there through the
// host's pointers to rows costs a second access to memory each time.
#pragma once

#include "atom.h"
#include "math/vector3.h"

#include <cstddef>

namespace ellipsoid_host {

/// Rows of `Width` numbers, owned particles first, then ghosts. Good until particles come, go or
/// change places.
template <int Width> class ParticleRows {
 public:
  ParticleRows() = default;
  explicit ParticleRows(double** rows) : first_(rows ? rows[0] : nullptr) {}
  double* operator[](int i) const { return first_ + Width * static_cast<std::ptrdiff_t>(i); }

 private:
  double* first_ = nullptr;
};

/// Those that the loops over pairs and particles take.
struct ParticleArrays {
  ParticleArrays() = default;
  explicit ParticleArrays(const LAMMPS_NS::Atom& atom)
      : x(atom.x), v(atom.v), omega(atom.omega), f(atom.f), torque(atom.torque),
        angmom(atom.angmom), shape(atom.shape), inertia(atom.inertia), quaternion(atom.quaternion),
        radius(atom.radius), mass(atom.rmass), type(atom.type), mask(atom.mask),
        owned(atom.nlocal) {}

  ParticleRows<3> x, v, omega, f, torque, angmom, shape, inertia;
  ParticleRows<4> quaternion;
  const double* radius = nullptr;
  const double* mass = nullptr;
  const int* type = nullptr;
  const int* mask = nullptr;
  int owned = 0; ///< number of owned particles
};

} // namespace ellipsoid_host
