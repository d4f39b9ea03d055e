// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The planes that cut the box into sub-domains, one for each rank, and their shifting. Planes are
// fractions of the box from 0 to 1, in direction k as many as ranks side by side and one more.
#pragma once

#include <array>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace ellipsoid_host {

using Planes = std::array<std::vector<double>, 3>;

Planes present_planes(LAMMPS_NS::LAMMPS* lmp);
/// Those that the host begins with: sub-domains of equal size.
Planes even_planes(LAMMPS_NS::LAMMPS* lmp);

/// Sets the planes and nothing else: for a box without particles.
void set_planes(LAMMPS_NS::LAMMPS* lmp, const Planes& planes);

/// Puts particles that left their sub-domain where they belong. Here and below all ranks take part,
/// fixes have packed what goes with particles (pre_exchange), coordinates are those of the box
/// (tilted boxes: fractions), and neighbour lists are built afterwards.
void exchange_particles(LAMMPS_NS::LAMMPS* lmp);

/// Shifts the planes and hands particles and triangles to the ranks that own them then. As many
/// stages as it takes, in each of which everything goes to a neighbouring rank at most.
void shift_planes(LAMMPS_NS::LAMMPS* lmp, const Planes& planes);

/// How the planes are chosen.
struct BalanceSettings {
  std::array<bool, 3> shifts{true, true, true}; ///< planes across x, y, z are shifted
  double least_width = 0.0;                     ///< of a sub-domain (length); 0: by the ghosts
};

struct BalancePlan {
  Planes planes;
  double imbalance = 1.0; ///< that comes of them
};

/// Planes with which the rank with most to do has as little as can be, from where particles are
/// now.
/// @param[in] weight of each particle of this rank, >= 0
BalancePlan balanced_planes(LAMMPS_NS::LAMMPS* lmp, const BalanceSettings& settings, double weight);

/// Largest over mean of a value of each rank; 1 where all are 0.
double imbalance(LAMMPS_NS::LAMMPS* lmp, double of_this_rank);

} // namespace ellipsoid_host
