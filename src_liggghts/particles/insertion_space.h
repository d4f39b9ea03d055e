// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The room that an insertion of the host finds: which bodies are there already, on all ranks and
// beyond periodic boundaries, and which were placed since. Used while pair_style gran/ellipsoid is.
//
// New bodies keep their bounding sphere within the domain of their rank, so that those of two ranks
// never meet.
#ifndef INSERTION_SPACE_H_
#define INSERTION_SPACE_H_

#include "math/vector3.h"

namespace LAMMPS_NS {
class BoundingBox;
class Fix;
class LAMMPS;
class ParticleToInsert;
class ParticleToInsertEllipsoid;
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

/// Whether a new body asks take_place() for its room.
bool asks_for_room(LAMMPS_NS::ParticleToInsert* particle);

/// Whether the place is free; if so it is taken.
/// @param[in] quaternion scalar first, unit
bool take_place(const LAMMPS_NS::ParticleToInsertEllipsoid& particle, const double* centre,
                const double* quaternion);

/// Says by name which templates could not be placed in full; stops if an insertion that is made
/// only once has changed the composition of a mixture. Called on all ranks.
/// @param[in] list new bodies of this rank, the `placed` first of which found a place
void report_missing(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix* insertion,
                    LAMMPS_NS::ParticleToInsert** list, int placed, int wanted, bool once);

} // namespace ellipsoid_host

#endif
