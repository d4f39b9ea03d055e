// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// compute erotate/ellipsoid: rotational kinetic energy.
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(erotate/ellipsoid,ComputeERotateEllipsoid)
// clang-format on
#else
#ifndef LMP_COMPUTE_EROTATE_ELLIPSOID_H
#define LMP_COMPUTE_EROTATE_ELLIPSOID_H

#include "host_compute.h"

namespace LAMMPS_NS {

/// Global scalar: sum of m_k^2 / (2 I_k) over the body axes k of all particles of the group, with
/// the angular momentum m and the principal moments I (energy).
class ComputeERotateEllipsoid : public ellipsoid_host::HostCompute {
 public:
  ComputeERotateEllipsoid(ELLIPSOID_COMPUTE_PARAMETERS);
  void init() override;
  double compute_scalar() override;
};

} // namespace LAMMPS_NS

#endif
#endif
