// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rows_command.h"

#include <iterator>

namespace ellipsoid::post {

int run_rows_command(const FrameOptions& options, const std::string& title, FrameOrder order,
                     const std::function<std::vector<Row>(const ChosenFrame&)>& make_rows) {
  Table table{title, {}};
  const auto append = [&table](std::vector<Row> rows) {
    std::move(rows.begin(), rows.end(), std::back_inserter(table.rows));
  };
  const int code =
      order == FrameOrder::ascending
          ? for_chosen_frames(options, [&](const ChosenFrame& f) { append(make_rows(f)); })
          : for_measured_frames(options, [&](const ChosenFrame& f) {
              return [&append, rows = make_rows(f)] { append(rows); };
            });
  write_table(options, table);
  return code;
}

} // namespace ellipsoid::post
