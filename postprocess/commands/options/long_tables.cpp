// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "long_tables.h"

#include "input_error.h"
#include "table_lines.h"
#include "written_file.h"

#include <algorithm>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Tables of so many rows are laid out as a whole.
constexpr std::size_t few_rows = 1000;

/// A line for each row, as as_text() has them of many rows.
void print_lines(const std::string& title, const RowStore& rows) {
  std::vector<Quantity> header = rows.header();
  std::string run; // that all rows belong to
  bool is_one_run = true;
  rows.visit([&](const Row& row) {
    const Value* value = find_value(row, "run");
    const std::string name = value ? shown(*value) : "";
    is_one_run = is_one_run && !name.empty() && (run.empty() || name == run);
    run = name;
  });
  if (is_one_run)
    header.erase(std::remove_if(header.begin(), header.end(),
                                [](const Quantity& q) { return q.key == "run"; }),
                 header.end());
  std::vector<std::size_t> widths;
  widen(widths, head_cells(header));
  rows.visit([&](const Row& row) { widen(widths, cells(row, header)); });
  WrittenFile out("-");
  out.write(title + (is_one_run ? ": " + run : "") + "\n" +
            aligned_line(head_cells(header), widths));
  rows.visit([&](const Row& row) { out.write(aligned_line(cells(row, header), widths)); });
  out.close();
}

} // namespace

void refuse_one_name(const OutputOptions& options) {
  if (!options.csv.empty() && options.csv == options.json)
    throw InputError(
        fmt::format("--csv and --json both name {}: give them two names", options.csv));
}

void write_rows(const OutputOptions& options, const std::string& title, const RowStore& rows,
                const RowStore& for_people) {
  if (rows.size() <= few_rows) {
    if (prints_text(options) && for_people.size() > 0)
      write_text("-", as_text(for_people.table(title)));
    OutputOptions files = options;
    files.quiet = true;
    write_table(files, rows.table(title));
    return;
  }
  refuse_one_name(options);
  if (prints_text(options))
    print_lines(title, for_people);
  if (!options.csv.empty()) {
    WrittenFile file(options.csv);
    file.write(csv_head(rows.header()));
    rows.visit([&](const Row& row) { file.write(csv_line(row, rows.header())); });
    file.close();
  }
  if (options.json.empty())
    return;
  WrittenFile file(options.json);
  bool is_first = true;
  rows.visit([&](const Row& row) {
    file.write((is_first ? "[\n" : ",\n") + json_element(row));
    is_first = false;
  });
  file.write("\n]\n");
  file.close();
}

void write_rows(const OutputOptions& options, const std::string& title, const RowStore& rows) {
  write_rows(options, title, rows, rows);
}

} // namespace ellipsoid::post
