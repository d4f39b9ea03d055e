// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// compute pair/ellipsoid/local: the contacts of ellipsoids with each other, one per row.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(pair/ellipsoid/local,ComputePairEllipsoidLocal)
// clang-format on
#else
#ifndef LMP_COMPUTE_PAIR_ELLIPSOID_LOCAL_H
#define LMP_COMPUTE_PAIR_ELLIPSOID_LOCAL_H

#include "ellipsoid_contact_list.h"

namespace LAMMPS_NS {

class ComputePairEllipsoidLocal : public EllipsoidContactList {
 public:
  ComputePairEllipsoidLocal(ELLIPSOID_COMPUTE_PARAMETERS)
      : EllipsoidContactList(ELLIPSOID_COMPUTE_ARGUMENTS, ContactPartner::particle) {}
  void init() override;
};

} // namespace LAMMPS_NS

#endif
#endif
