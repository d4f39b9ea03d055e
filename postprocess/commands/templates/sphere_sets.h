// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What `template` does with sets of spheres in space: for ellipsoids of any axes, from lists, from
// surfaces.
#pragma once

#include "body_files.h"
#include "command.h"
#include "output_options.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

struct SetOptions {
  std::vector<double> semiaxes; ///< a b c along x, y, z (m); empty: not given
  std::string clump, mesh;      ///< files that are read
  double needed_within = 0.0;   ///< share of the volume, for a table of needed N; 0: none
  std::vector<double> ratios;   ///< of b/a and c/a; empty: not given
  std::string map, picture;     ///< files that are drawn

  /// Whether sets are asked for, instead of chains.
  bool are_asked() const {
    return !semiaxes.empty() || !clump.empty() || !mesh.empty() || needed_within > 0.0 ||
           !ratios.empty();
  }
};

/// What both kinds of template share.
struct TemplateChoice {
  std::vector<int> counts;
  std::string spacing; ///< a word; empty: not given
  std::string measure; ///< of the tolerance; empty: not given
  double tolerance = 0.0;
  BodyFiles files;
};

void add_set_options(CLI::App& command, SetOptions& options);

/// Table, files and pictures of the sets that are asked for.
/// Throws InputError and std::invalid_argument, each in one line.
int run_sets(const SetOptions& options, const TemplateChoice& choice, OutputOptions output);

/// N needed by both placings in a plane, over (b/a, c/a) of all pairs of ratios.
Table needed_table(double share, const std::vector<double>& ratios);

/// Sets of these numbers beside their ellipsoids, over (b/a, c/a) of all pairs of ratios. Sets that
/// cannot be built are left out with a warning.
Table ratio_table(const std::vector<double>& ratios, const std::vector<int>& counts,
                  SphereSpacing spacing);

} // namespace ellipsoid::post
