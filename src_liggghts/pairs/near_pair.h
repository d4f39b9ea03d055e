// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstdint>

namespace ellipsoid_host {

/// Two particles of the neighbour lists, and where the host keeps what is remembered of them.
struct NearPair {
  std::uint32_t index; ///< in the neighbour lists: 0, 1, 2 ... from the first pair on
  int i, j;
  bool touched;    ///< in the last step, as far as is known without asking the flag
  int* flag;       ///< which contact models have a contact (CONTACT_..._MODEL)
  double* history; ///< what the search remembers, then the values of the contact models
};

/// One contact of two particles, besides its geometry, which lies in the columns of a batch.
struct Contact {
  int i, j;
  int* flag;              ///< of the pair
  double* history;        ///< of the contact; null: the particles are apart, there is none
  double weight;          ///< of its force in the sum
  int sphere_i, sphere_j; ///< numbers of the touching sub-spheres from 0; -1: none
};

} // namespace ellipsoid_host
