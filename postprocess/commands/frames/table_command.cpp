// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table_command.h"

#include "frame_options.h"
#include "long_tables.h"
#include "run_summary.h"

#include <algorithm>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Quantities of the summary below a table of several runs.
const std::vector<std::string> summarised = {"repose_angle_deg", "porosity", "zpp", "zss"};

} // namespace

int run_table_command(const FrameOptions& options, const std::string& title,
                      const std::function<Row(const ChosenFrame&)>& make_row) {
  RowStore rows;
  const int code = for_measured_frames(options, [&](const ChosenFrame& chosen) {
    return [&rows, row = make_row(chosen)] { rows.add(row); };
  });
  write_rows(options, title, rows);
  if (prints_text(options) && rows.size() > 1 && options.frames != "all")
    write_text("-", "\n" + as_text(summary_for_people(rows.table(title), {"surface", "subspheres"},
                                                      summarised)));
  return code;
}

} // namespace ellipsoid::post
