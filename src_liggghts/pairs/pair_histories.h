// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the host's fix contacthistory asks before it takes histories out of the neighbour lists.
#pragma once

namespace LAMMPS_NS {
class Pair;
}

namespace ellipsoid_host {

/// History of a pair that touches.
/// @param[in] pair the pair style, any
/// @param[in] in_list what the lists hold of the first particle
/// @param[in] values of a pair, @param[in] entry of the pair in the list
double* pair_history(LAMMPS_NS::Pair* pair, double* in_list, int values, int entry);
/// The histories are about to be taken.
void keep_pair_histories(LAMMPS_NS::Pair* pair);

} // namespace ellipsoid_host
