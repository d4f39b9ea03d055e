// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "html.h"
#include "report_runs.h"

#include <string>
#include <vector>

namespace ellipsoid::post {

/// Words that each picture of --curve and --map takes: a file and columns.
constexpr std::size_t words_of_curve = 3, words_of_map = 4;

/// The whole page. Throws InputError for CSV files that do not have what is asked for.
std::string report_page(const ReportOptions& options, const std::vector<ReportedRun>& runs);

/// A path as a link from the report's folder.
std::string relative_to_report(const std::string& path, const std::string& report);

} // namespace ellipsoid::post
