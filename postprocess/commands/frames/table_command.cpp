// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "table_command.h"

#include "frame_options.h"
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
  Table table{title, {}};
  const int code = for_measured_frames(options, [&](const ChosenFrame& chosen) {
    return [&table, row = make_row(chosen)] { table.rows.push_back(row); };
  });
  write_table(options, table);
  if (prints_text(options) && table.rows.size() > 1 && options.frames != "all")
    write_text("-",
               "\n" + as_text(summary_for_people(table, {"surface", "subspheres"}, summarised)));
  return code;
}

} // namespace ellipsoid::post
