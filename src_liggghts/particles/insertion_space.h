// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The room that an insertion of the host finds: which bodies are there already, on all ranks and
// beyond periodic boundaries, and which were placed since. Used while pair_style gran/ellipsoid is.
//
// New bodies keep their bounding sphere within the domain of their rank, so that those of two ranks
// never meet.
#pragma once

#include "host_insertion.h"
#include "math/vector3.h"

namespace LAMMPS_NS {
class BoundingBox;
class Fix;
class LAMMPS;
class ParticleToInsert;
class ParticleToInsertEllipsoid;
class RanPark;
class Region;
} // namespace LAMMPS_NS

namespace ellipsoid_host {

/// Takes note of all bodies that new ones could overlap. Called on all ranks.
/// @param[in] reached box that holds the centres of new bodies and twice `largest_radius` around it
/// @param[in] largest_radius of the bounding spheres of new bodies (length)
void begin_insertion(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::BoundingBox& reached,
                     double largest_radius);

/// From now on new bodies must lie wholly in this region; null: only their centres.
void insert_within(LAMMPS_NS::Region* region);

/// Whether a new body asks occupy() for its room.
bool asks_for_room(LAMMPS_NS::ParticleToInsert* particle);

/// Occupies the room of a body, if it is free.
/// @return whether it was
/// @param[in] quaternion scalar first, unit
bool occupy(const LAMMPS_NS::ParticleToInsertEllipsoid& particle, const double* centre,
            const double* quaternion);

/// A random place for the centre of a new body in a region that it must lie in wholly: where there
/// are such, no closer to the region's surface than the body's smallest semi-axis.
void random_place(LAMMPS_NS::Region* region, LAMMPS_NS::ParticleToInsert* particle, double* centre);

/// Other random orientations of a body that found no room at `centre`, as long as the largest ball
/// in the body would find some, and only after 100 refusals on end. Returns what
/// particle->check_near_set_x_v_omega() does.
/// @param[out] quaternion the last one that was tried
int try_orientations(LAMMPS_NS::ParticleToInsert* particle, double* centre, double* velocity,
                     double* omega, double* quaternion, NearBodies& near,
                     LAMMPS_NS::RanPark* random);

/// Says by name which templates could not be placed in full; stops if an insertion that is made
/// only once has changed the composition of a mixture. Called on all ranks.
/// @param[in] list new bodies of this rank, the `placed` first of which found a place
void report_missing(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* insertion,
                    LAMMPS_NS::ParticleToInsert** list, int placed, int wanted, bool once);

} // namespace ellipsoid_host
