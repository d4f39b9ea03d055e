// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What the commands on in-plane piles take from one frame.
#pragma once

#include "frame_loop.h"
#include "pile_options.h"
#include "repose.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// The pile of a frame; warns when its particles do not lie in one plane and no section was chosen.
Pile plane_pile(const ChosenFrame& chosen, const PileOptions& options);
/// @param[in] near see near_pairs(), @param[in] touching see pile_members()
Pile plane_pile(const ChosenFrame& chosen, const PileOptions& options, NearPairs near,
                const std::vector<PairContact>& touching);

/// The contacts of all particles, where no gap is asked for that must wait for the pile's mean
/// size: which particles belong to the pile is found faster with them.
ContactNetwork early_contacts(const PileCommandOptions& options, const ParticleSet& set,
                              const NearPairs& near);

/// The fitted flank beside the wall, or both of a pile without a wall, the left one first.
/// Throws InputError where the surface is too short.
std::vector<ReposeAngle> fitted_flanks(const Pile& pile, const PileOptions& options);

/// The same; nothing where the surface is too short (the reason to `why`).
std::vector<ReposeAngle> try_flanks(const Pile& pile, const PileOptions& options,
                                    std::string* why = nullptr);

/// All measures of one frame.
struct PileResult {
  PileOptions settings;
  Pile pile;
  std::vector<ReposeAngle> flanks;
  Row row;
};
PileResult measure_pile(const PileCommandOptions& options, const ChosenFrame& chosen);

} // namespace ellipsoid::post
