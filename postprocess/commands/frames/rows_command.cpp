// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rows_command.h"

#include "long_tables.h"

namespace ellipsoid::post {

int run_rows_command(const FrameOptions& options, const std::string& title, FrameOrder order,
                     const std::function<std::vector<Row>(const ChosenFrame&)>& make_rows) {
  RowStore all;
  const auto append = [&all](const std::vector<Row>& rows) {
    for (const Row& row : rows)
      all.add(row);
  };
  const int code =
      order == FrameOrder::ascending
          ? for_chosen_frames(options, [&](const ChosenFrame& f) { append(make_rows(f)); })
          : for_measured_frames(options, [&](const ChosenFrame& f) {
              return [&append, rows = make_rows(f)] { append(rows); };
            });
  write_rows(options, title, all);
  return code;
}

} // namespace ellipsoid::post
