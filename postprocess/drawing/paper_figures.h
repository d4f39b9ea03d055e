// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "chart.h"
#include "table.h"

#include <vector>

namespace ellipsoid::post {

/// Figures of the paper that can be drawn: 5, 12, 13, 15, 17, 18.
extern const std::vector<int> known_figures;

/// Columns of numbers that the figures are drawn from.
extern const std::vector<std::string> figure_columns;

/// The runs of smooth ellipsoids, and of ellipsoids with one number N of sub-spheres each.
Table drawn_in_figures(const Table& runs);
/// A sentence that names the others (mixtures, clumps), which are in no figure, and those without
/// a value that these figures draw; or nothing.
std::string left_out_of_figures(const Table& runs, const std::vector<int>& figures);

/// The paper's values of piles beside those of the runs: one row per quantity and number of
/// sub-spheres that the paper reports and a run has.
Table compared_with_paper(const Table& runs);

/// Whether the paper's values stand beside ours: they say something of runs with its parameters.
enum class PaperPoints { shown, hidden };

/// Ours beside the paper's points.
///
/// Figure 5 is computed from the templates. The others use rows of runs as `pile --csv` writes
/// them: surface, subspheres, outline, repose_angle_deg, porosity, zpp, zss (12, 13, 15);
/// subspheres, relative_cpu_time (17), potential_contacts_per_particle (18).
/// @param[in] aspect_ratio of the particles, for the shape factors of figure 15
/// Throws InputError for an unknown figure or rows without what it needs.
std::vector<Chart> figure(int number, const Table& runs, double aspect_ratio,
                          PaperPoints points = PaperPoints::shown);

} // namespace ellipsoid::post
