// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// An in-plane pile (paper, section 4): which particles belong to it and its free surface.
#pragma once

#include "contacts.h"
#include "envelope.h"
#include "particles.h"

#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

struct PileOptions {
  std::optional<double> wall = 0.0; ///< abscissa of the wall on the left; none: two-sided pile
  double floor = 0.0;               ///< ordinate of the floor (length)
  std::optional<double> section;    ///< z of the section plane; none: mean z of the particles
  /// Particles belong together when they touch after an enlargement of all semi-axes by half of
  /// this share of the mean smallest semi-axis.
  double cluster_gap = 0.1;
  /// Parts of the pile's height that are left out of the fit at the bottom and at the top.
  double cut_bottom = 0.2, cut_top = 0.2;
  /// Distance of the sampled columns of the free surface as a share of the mean smallest
  /// semi-axis.
  double column_spacing = 0.05;
  OutlineKind outline = OutlineKind::true_shape;
};

/// What belongs to a pile and how far it reaches.
struct PileBody {
  std::vector<std::size_t> members;   ///< indices of the set, ascending
  std::size_t strays = 0;             ///< particles that do not belong to it
  NearPairs near;                     ///< of all particles, from which the members were chosen
  double section = 0.0;               ///< z of the plane (length)
  double out_of_plane = 0.0;          ///< largest |z - section| of a member (length)
  std::vector<PlaneEllipse> outlines; ///< of the members
  double left = 0.0, right = 0.0;     ///< extent above the floor, from the wall (length)
  double top = 0.0;                   ///< ordinate of the highest point (length)
  double mean_a = 0.0, mean_b = 0.0;  ///< largest and smallest semi-axis, means (length)
};

/// With its free surface.
struct Pile : PileBody {
  UpperEnvelope surface;
};

/// Indices of the particles that belong to the pile, ascending.
/// @param[in] near its gap: particles this close belong together
/// @param[in] touching pairs that are known to touch, if any
std::vector<std::size_t> pile_members(const ParticleSet& set, const PileOptions& options,
                                      const NearPairs& near,
                                      const std::vector<PairContact>& touching = {});

/// Wall and floor as planes.
std::vector<PlaneWall> walls_of(const PileOptions& options);

/// Pairs of particles near enough to each other to belong to one pile.
NearPairs near_pairs(const ParticleSet& set, const PileOptions& options);

/// The pile: the connected cluster of particles that touches the wall (the largest if several
/// do; without a wall, or if none does, the largest cluster of all) and its outlines.
/// Throws InputError when there are no particles.
/// @param[in] near see near_pairs(), @param[in] touching see pile_members()
PileBody find_pile_body(const ParticleSet& set, const PileOptions& options, NearPairs near,
                        const std::vector<PairContact>& touching = {});
/// The same with its free surface.
Pile find_pile(const ParticleSet& set, const PileOptions& options, NearPairs near,
               const std::vector<PairContact>& touching = {});

} // namespace ellipsoid::post
