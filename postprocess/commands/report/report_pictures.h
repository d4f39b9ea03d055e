// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The pictures of a report: piles to one scale, and all of them small enough for one page.
#pragma once

#include "frame_options.h"
#include "html.h"
#include "report_runs.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace ellipsoid::post {

std::size_t count_of_runs(const FrameOptions& frames);

/// PNG, or SVG where the build draws no PNG, as wide as one run's share of the bytes of a page with
/// so many runs allows.
std::string picture_in_space(const ParticleSet& upright, const std::string& title,
                             std::size_t runs);

/// One picture for each run, piles with one view and so to one scale.
/// @param[in] names of the runs for people
std::vector<HtmlPicture> pictures_of(const std::vector<ReportedRun>& runs,
                                     const std::map<std::string, std::string>& names);

} // namespace ellipsoid::post
