// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Built where voro++ is missing.
#include "set_voronoi.h"

namespace ellipsoid::post {

std::vector<SetVoronoiCell> set_voronoi(const ParticleSet&, const PeriodicCell&,
                                        const SetVoronoiOptions&) {
  throw InputError("this build of ellipsoid-post has no Voronoi cells: install voro++ (Debian: "
                   "voro++-dev), then configure and build again");
}

} // namespace ellipsoid::post
