// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "rows_command.h"

#include "input_error.h"
#include "messages.h"

#include <iterator>

namespace ellipsoid::post {

int run_rows_command(const FrameOptions& options, const std::string& title, FrameOrder order,
                     const std::function<std::vector<Row>(const ChosenFrame&)>& make_rows) {
  Table table{title, {}};
  const auto append = [&table](std::vector<Row> rows) {
    std::move(rows.begin(), rows.end(), std::back_inserter(table.rows));
  };
  int code = order == FrameOrder::ascending
                 ? for_chosen_frames(options, [&](const ChosenFrame& f) { append(make_rows(f)); })
                 : for_measured_frames(options, [&](const ChosenFrame& f) {
                     return [&append, rows = make_rows(f)] { append(rows); };
                   });
  try {
    write_table(options, table);
  } catch (const InputError& error) {
    report_error(error.what());
    code = exit_bad_data;
  }
  return code;
}

} // namespace ellipsoid::post
