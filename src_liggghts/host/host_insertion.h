// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The host's list of the bodies near an insertion, the same for every host.
#pragma once

#include "host_variants.h"
#include "particleToInsertSuperquadric.h"

#include <mpi.h>

#include "region_neighbor_list.h"

namespace ellipsoid_host {

#ifdef ELLIPSOID_HOST_PFM
using NearBodies = LIGGGHTS::RegionNeighborList;
#else
using NearBodies = LAMMPS_NS::RegionNeighborList<LAMMPS_NS::interpolate_no>;
#endif

/// Adds a new body for the host's own templates, which find their room by this list.
inline void add_body(NearBodies& near, LAMMPS_NS::ParticleToInsertSuperquadric& body,
                     double* centre, double* quaternion) {
#ifdef ELLIPSOID_HOST_PFM
  near.insert_superquadric(centre, body.radius_ins[0], body.atom_type, quaternion, body.shape_ins,
                           body.blockiness_ins);
#else
  near.insert_superquadric(centre, body.radius_ins[0], quaternion, body.shape_ins,
                           body.blockiness_ins);
#endif
}

} // namespace ellipsoid_host
