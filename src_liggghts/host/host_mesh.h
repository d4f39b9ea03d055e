// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Calls to the host's meshes, the same for every host.
#pragma once

#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "host_variants.h"

#ifdef ELLIPSOID_HOST_PFM
#include "fix_mesh_surface_stress.h"
#endif

namespace ellipsoid_host {

/// Notes that particle i touches a triangle of the mesh.
inline void note_triangle(LAMMPS_NS::FixMeshSurface* mesh, int i, int triangle_id) {
  double* unused = nullptr;
#if defined(ELLIPSOID_HOST_PFM)
  mesh->contactHistory()->handleContact(i, triangle_id, unused);
#elif defined(ELLIPSOID_HOST_INL)
  mesh->contactHistory()->handleContact(i, triangle_id, unused, true, false, false);
#else
  mesh->contactHistory()->handleContact(i, triangle_id, unused, true, false);
#endif
}

/// Tells the mesh the force that particle i feels at the point (length).
inline void add_to_mesh(LAMMPS_NS::FixMeshSurface* mesh, int i, double* force, double* point,
                        int triangle, double* wall_velocity) {
#if defined(ELLIPSOID_HOST_PFM)
  if (mesh->trackStress())
    static_cast<LAMMPS_NS::FixMeshSurfaceStress*>(mesh)->add_particle_contribution(
        i, force, point, triangle, wall_velocity);
#elif defined(ELLIPSOID_HOST_INL)
  mesh->add_particle_contribution(i, force, point, triangle, wall_velocity, nullptr);
#else
  mesh->add_particle_contribution(i, force, point, triangle, wall_velocity);
#endif
}

/// Is the mesh to weigh its contacts in a way of its own?
inline bool weighs_contacts(LAMMPS_NS::FixMeshSurface* mesh) {
#ifdef ELLIPSOID_HOST_INL
  return mesh->triMesh()->getWeightedWallFormulation();
#else
  static_cast<void>(mesh);
  return false;
#endif
}

} // namespace ellipsoid_host
