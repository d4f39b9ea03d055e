// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the hosts that this package is compiled with call differently: LIGGGHTS-PUBLIC (and
// PICI-LIGGGHTS), or LIGGGHTS-INL. Pair styles: host_pair.h; meshes: host_mesh.h; walls:
// host_wall.h.
#pragma once

#if __has_include("iloopcallbackcaller.h")
#define ELLIPSOID_HOST_INL
#include "comm_brick.h"
#endif

/// The parameters of Fix::restart().
#ifdef ELLIPSOID_HOST_INL
#define ELLIPSOID_RESTART_PARAMETERS char *buffer, const Version &
#else
#define ELLIPSOID_RESTART_PARAMETERS char* buffer
#endif

namespace ellipsoid_host {

/// The distance (length) that `reduce_dist_from_subdomain_border_to_particle_radius` of
/// LIGGGHTS-INL's fix insert/pack keeps: of one body its bounding sphere, as without that keyword.
template <class Particle> void set_distance_from_borders(Particle& particle) {
#ifdef ELLIPSOID_HOST_INL
  particle.radius_ins_max = particle.r_bound_ins;
#else
  static_cast<void>(particle);
#endif
}

/// Does a variable of the script change the shape of this region from one time step to another?
template <class Region> bool has_variable_shape(const Region& region) {
#ifdef ELLIPSOID_HOST_INL
  return region.has_varshape();
#else
  return region.varshape != 0;
#endif
}

/// Are the sub-domains the bricks of a grid? (LIGGGHTS-INL's `comm_style tiled` exchanges nothing.)
template <class Comm> bool has_brick_domains(Comm* comm) {
#ifdef ELLIPSOID_HOST_INL
  return dynamic_cast<LAMMPS_NS::CommBrick*>(comm) != nullptr;
#else
  return comm != nullptr;
#endif
}

} // namespace ellipsoid_host
