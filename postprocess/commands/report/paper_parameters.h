// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "run_log.h"

#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

/// What in a run of inputs/piling.in is not as in the paper's piling problem (Markauskas et al.
/// 2010, table 1 and section 4), in words; empty: all is as there. Nothing where the log does not
/// name all of the parameters: it is of another problem.
std::optional<std::vector<std::string>> differences_from_paper(const RunLog& log);

} // namespace ellipsoid::post
