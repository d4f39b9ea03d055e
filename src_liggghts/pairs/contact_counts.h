// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid_host {

/// What the contact search did in a time step, on this rank: pairs of owned particles count once,
/// pairs with a ghost half on each of the two ranks that have it.
struct ContactCounts {
  enum Item {
    touching_pairs,
    contacts,
    listed_pairs, ///< in the host's lists: bounding spheres are near
    tested, ///< smooth: pairs that were searched; multi-spheres: distances between sub-spheres
    newton_steps,
    not_converged,
    near_pairs, ///< those of listed_pairs that are near by their true shapes
    item_count
  };
  double values[item_count] = {};
};

} // namespace ellipsoid_host
