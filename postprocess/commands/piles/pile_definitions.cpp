// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile_definitions.h"

namespace ellipsoid::post {

const char* const pile_definition =
    "Pile: all particles connected with the wall through particles whose semi-axes, enlarged by "
    "half of --cluster-gap each, touch; the largest such cluster if several touch the wall. "
    "Particles that rolled away do not belong to it (they are counted as strays).\n"
    "Free surface: y_max(x), the largest ordinate of the true outlines (ellipses, or sub-sphere "
    "discs) at x, computed exactly as a chain of arcs; the floor where there is no particle.";

const char* const repose_definition =
    "Angle of repose (paper, section 4.2.1): atan(-slope) of the least squares line y = p + slope "
    "x through y_max(x), in columns 0.05 b apart (--columns), from A to B. h(x) is the mean of "
    "y_max over x +- a (one particle length), H its largest value, at x_H. A is the first column "
    "from x_H downhill with h < (1 - cut_top) H, B the last one before h first falls below "
    "cut_bottom H: particles that rolled off and lie beyond do not count. Both cuts are 0.2 by "
    "default: about four particle lengths at top and bottom of the paper's pile of 1000; 60 % of "
    "the slope remain.\n"
    "Standard error: s / sqrt(S_xx) sqrt(n / m) / (1 + slope^2), s^2 = sum of squared residuals / "
    "(n - 2), n columns, m = length of A-B over 2a: columns on one particle are not independent.\n"
    "Without a wall (--no-wall) both flanks are fitted; the angle is the mean of both, its "
    "standard error sqrt(left^2 + right^2) / 2.";

const char* const porosity_definition =
    "Porosity (paper, section 4.2.2): 1 - solid / total. total: area between floor, wall and "
    "y_max(x), in closed form arc by arc. solid: area of the union of the section outlines, "
    "each point counted once (overlaps, lenses of about 1e-5 of the area, are subtracted), exact "
    "by Green's theorem. 'by sum' adds the areas pi a b (2) or of the cut-off spheres (9) one by "
    "one as the paper does. --outline ellipse gives 'MS ellipse' of the paper.\n"
    "Regions: whole (the pile's whole extent), middle (between the abscissas of A and B, without a "
    "wall between both B), core (at "
    "least --margin away from wall, floor and the line A-B, without the free surface itself).";

const char* const coordination_definition =
    "Coordination numbers (paper, section 4.2.3): Zpp = 2 Ncp / K with Ncp touching pairs among "
    "the K particles of the pile, Zss = 2 Ncs / K with Ncs touching pairs of sub-spheres of "
    "different particles. Touching: overlap h >= 0 of the engine's own contact kernel (or "
    "h >= -gap with --contact-gap). --with-walls adds 1 for each wall that a particle touches. "
    "Rattlers: particles with fewer than 2 contacts, walls included.";

} // namespace ellipsoid::post
