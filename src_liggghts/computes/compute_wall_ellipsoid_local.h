// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// compute wall/ellipsoid/local: the contacts of ellipsoids with walls, one per row.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(wall/ellipsoid/local,ComputeWallEllipsoidLocal)
// clang-format on
#else
#ifndef LMP_COMPUTE_WALL_ELLIPSOID_LOCAL_H
#define LMP_COMPUTE_WALL_ELLIPSOID_LOCAL_H

#include "ellipsoid_contact_list.h"

namespace LAMMPS_NS {

class ComputeWallEllipsoidLocal : public EllipsoidContactList {
 public:
  ComputeWallEllipsoidLocal(ELLIPSOID_COMPUTE_PARAMETERS)
      : EllipsoidContactList(ELLIPSOID_COMPUTE_ARGUMENTS, ContactPartner::wall) {}
  void init() override;
};

} // namespace LAMMPS_NS

#endif
#endif
