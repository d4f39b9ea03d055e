// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the hosts that this package is compiled with call differently: LIGGGHTS-PUBLIC (and
// PICI-LIGGGHTS), LIGGGHTS-INL, or LIGGGHTS-PFM. Contacts: host_contact.h; pair styles:
// host_pair.h; meshes: host_mesh.h; templates: host_template.h; insertion: host_insertion.h;
// computes: host_compute.h; contact models: models/host_models.h; walls: walls/host_wall.h.
#pragma once

#if __has_include("fix_particledistribution.h")
#define ELLIPSOID_HOST_PFM
#include <mpi.h> // before lammps.h
#endif
#if __has_include("iloopcallbackcaller.h")
#define ELLIPSOID_HOST_INL
#include "comm_brick.h"
#endif
#if __has_include("jkr_lookup_table.h")
#define ELLIPSOID_HOST_PICI
#endif

/// The parameters of Fix::restart().
#ifdef ELLIPSOID_HOST_INL
#define ELLIPSOID_RESTART_PARAMETERS char *buffer, const Version &
#else
#define ELLIPSOID_RESTART_PARAMETERS char* buffer
#endif

/// Functions that tell sizes and types of particles are const with LIGGGHTS-PFM.
#ifdef ELLIPSOID_HOST_PFM
#define ELLIPSOID_HOST_CONST const
#else
#define ELLIPSOID_HOST_CONST
#endif

namespace ellipsoid_host {

/// The order of a particle in its distribution (LIGGGHTS-PFM has none).
template <class Particle> void set_order(Particle& particle, int order) {
#ifdef ELLIPSOID_HOST_PFM
  static_cast<void>(particle);
  static_cast<void>(order);
#else
  particle.distorder = order;
#endif
}

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

/// The factor of sizes of the host's command `coarsegraining`.
template <class Force> double coarse_graining(Force& force, int type) {
#ifdef ELLIPSOID_HOST_PFM
  static_cast<void>(type);
  return force.cg();
#else
  return force.cg(type);
#endif
}

/// Does a fix follow which particles go from rank to rank? (LIGGGHTS-PFM has no such fix.)
template <class Comm> bool follows_exchange(const Comm& comm) {
#ifdef ELLIPSOID_HOST_PFM
  static_cast<void>(comm);
  return false;
#else
  return comm.exchangeEvents;
#endif
}

/// Does fix couple/cfd/force leave drag to an integrator of spheres unless told otherwise?
#ifdef ELLIPSOID_HOST_INL
constexpr bool integrators_have_drag = true;
#else
constexpr bool integrators_have_drag = false;
#endif

/// Are the sub-domains the bricks of a grid? (LIGGGHTS-INL's `comm_style tiled` exchanges nothing.)
template <class Comm> bool has_brick_domains(Comm* comm) {
#ifdef ELLIPSOID_HOST_INL
  return dynamic_cast<LAMMPS_NS::CommBrick*>(comm) != nullptr;
#else
  return comm != nullptr;
#endif
}

} // namespace ellipsoid_host
