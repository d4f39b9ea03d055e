// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_options.h"
#include "pile_rows.h"

namespace ellipsoid::post {

/// Options of the commands on in-plane piles; each command adds the groups it uses.
struct PileCommandOptions {
  FrameOptions frames;
  PlaneOptions plane;
  std::string region = "whole";
  double margin = 2.0; ///< of the core, in a
  bool with_walls = false;
  double contact_gap = 0.0; ///< in b
  double gravity = 9.81;    ///< m/s2
};

void add_porosity_options(CLI::App& command, PileCommandOptions& options);
void add_coordination_options(CLI::App& command, PileCommandOptions& options);
void add_rest_options(CLI::App& command, PileCommandOptions& options);

PorosityOptions porosity_settings(const PileCommandOptions& options);
CoordinationOptions coordination_settings(const PileCommandOptions& options,
                                          const PileOptions& pile, double mean_b);

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
PileResult analyse_pile(const PileCommandOptions& options, const ChosenFrame& chosen);

// What the commands say about their definitions in --help.
extern const char* const repose_definition;
extern const char* const porosity_definition;
extern const char* const coordination_definition;
extern const char* const pile_definition;

} // namespace ellipsoid::post
