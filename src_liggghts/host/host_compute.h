// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Base class of a compute, the same for every host.
#pragma once

#include "compute.h"
#include "host_variants.h"

/// The parameters of a compute's constructor, and what its base class takes of them. The arguments
/// of the style begin at `iarg`.
#ifdef ELLIPSOID_HOST_PFM
#define ELLIPSOID_COMPUTE_PARAMETERS class LAMMPS *lmp, int narg, char **arg
#define ELLIPSOID_COMPUTE_ARGUMENTS lmp, narg, arg
#else
#define ELLIPSOID_COMPUTE_PARAMETERS class LAMMPS *lmp, int &iarg, int narg, char **arg
#define ELLIPSOID_COMPUTE_ARGUMENTS lmp, iarg, narg, arg
#endif

namespace ellipsoid_host {

class HostCompute : public LAMMPS_NS::Compute {
 protected:
  using Compute::Compute;
#ifdef ELLIPSOID_HOST_PFM
  static constexpr int iarg = 3; // behind ID, group and style
#endif
};

} // namespace ellipsoid_host
