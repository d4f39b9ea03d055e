// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Measures of a pile as quantities of a table, shared by the commands on piles.
#pragma once

#include "coordination.h"
#include "porosity.h"
#include "repose.h"
#include "rest.h"
#include "table.h"

namespace ellipsoid::post {

/// "smooth", "multisphere" (spheres for an ellipsoid), "clump" (any others) or "mixed", and the
/// number of sub-spheres: the groups of summaries.
void append_surface(Row& row, const ParticleSet& set);
void append_pile(Row& row, const ParticleSet& set, const PileBody& pile,
                 const PileOptions& options);
/// The flank beside a wall, or the mean of two flanks (left, right) and each of them.
void append_flanks(Row& row, const std::vector<ReposeAngle>& flanks);
void append_porosity(Row& row, const Porosity& porosity);
void append_coordination(Row& row, const Coordination& z, double mean_b);
void append_distribution(Row& row, const Coordination& z);
void append_rest(Row& row, const RestCheck& rest);

/// Shares per bin of an angle from 0 to 180 degrees.
void append_rose(Row& row, const std::vector<double>& rose);

} // namespace ellipsoid::post
