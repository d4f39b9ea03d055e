// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Set-Voronoi cells: the points of space that are nearer to the surface of one particle than to
// that of any other (Schaller et al. 2013, Philosophical Magazine 93, 3993-4017), from the Voronoi
// cells of points on the surfaces, which voro++ computes (Rycroft 2009, Chaos 19, 041111).
#pragma once

#include "particles.h"
#include "periodic_cell.h"

#include <vector>

namespace ellipsoid::post {

struct SetVoronoiCell {
  double volume = 0.0;            ///< (length^3)
  double area = 0.0;              ///< of the cell's surface (length^2)
  double packing_fraction = 0.;   ///< volume of the body / volume of the cell
  double anisotropy = 0.0;        ///< smallest / largest eigenvalue of the integral of n n over the
                                  ///< cell's surface, W_1^(0,2) of Schroeder-Turk et al. 2013
  std::size_t neighbours = 0;     ///< particles whose cells share a face with it
  bool is_bounded_by_box = false; ///< a face is the end of the box
};

struct SetVoronoiOptions {
  /// Distance of the points on the surfaces, in mean radii of balls of the particles' volumes.
  double spacing = 0.25;
};

/// The cell of every particle. Equal spheres are taken by their centres: the ordinary Voronoi
/// cells. Throws InputError for a particle that lies outside the box, for boxes that are tilted but
/// do not repeat along all edges, and in a build without voro++.
std::vector<SetVoronoiCell> set_voronoi(const ParticleSet& set, const PeriodicCell& cell,
                                        const SetVoronoiOptions& options);

} // namespace ellipsoid::post
