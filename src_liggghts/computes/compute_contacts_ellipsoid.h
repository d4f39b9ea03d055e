// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// compute contacts/ellipsoid: what the contact search of pair_style gran/ellipsoid does.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(contacts/ellipsoid,ComputeContactsEllipsoid)
// clang-format on
#else
#ifndef LMP_COMPUTE_CONTACTS_ELLIPSOID_H
#define LMP_COMPUTE_CONTACTS_ELLIPSOID_H

#include "host_compute.h"

namespace LAMMPS_NS {

/// Global vector of the last time step, summed over all ranks: [1] touching pairs of particles,
/// [2] contacts between them (more than [1] for multi-spheres), [3] pairs in the neighbour list,
/// [4] searches (smooth) or distances between sub-spheres (multisphere): potential contacts,
/// [5] Newton steps, [6] searches that did not converge, [7] those pairs of [3] that are near by
/// their true shapes. In the order of ContactCounts.
class ComputeContactsEllipsoid : public ellipsoid_host::HostCompute {
 public:
  ComputeContactsEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS);
  ~ComputeContactsEllipsoid() override;
  void init() override;
  void compute_vector() override;

 private:
  class PairGranEllipsoid* pair_ = nullptr;
};

} // namespace LAMMPS_NS

#endif
#endif
