// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_rows.h"

#include "byte_source.h"
#include "number_text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Columns that hold words, not numbers; their values are not kept.
constexpr std::array<std::string_view, 1> text_columns = {"element"};

/// Values for which memory is set aside before they were seen: a wrong count in a broken file must
/// not ask for all the memory of the machine.
constexpr std::size_t most_values_ahead = std::size_t{1} << 16;

bool is_text_column(std::string_view name) {
  return std::find(text_columns.begin(), text_columns.end(), name) != text_columns.end();
}

} // namespace

RowReader::RowReader(Frame& frame) : m_frame(frame), m_values(frame.names.size(), nullptr) {
  frame.columns.resize(frame.names.size());
  for (std::size_t k = 0; k < frame.names.size(); ++k)
    if (is_text_column(frame.names[k]))
      frame.columns[k].clear();
}

void RowReader::set_memory_aside() {
  const std::size_t more = std::max(std::size_t{1}, most_values_ahead / m_values.size());
  m_held = std::min(m_frame.rows, m_held + more);
  for (std::size_t k = 0; k < m_values.size(); ++k)
    if (!is_text_column(m_frame.names[k])) {
      m_frame.columns[k].resize(m_held);
      m_values[k] = m_frame.columns[k].data();
    }
}

FilePlace RowReader::here() const {
  return {m_frame.place.file, m_frame.place.line + m_row, m_frame.place.frame};
}

/// False when the line is no row of numbers.
bool RowReader::take(std::string_view line) {
  const char* place = line.data();
  const char* const end = place + line.size();
  const auto skip = [&](bool blanks) {
    while (place < end && is_blank(*place) == blanks)
      ++place;
  };
  for (double* const values : m_values) {
    skip(true);
    if (place == end)
      return false;
    if (!values)
      skip(false);
    else if (!(place = read_number(place, end, values[m_row])))
      return false;
  }
  skip(true);
  return place == end;
}

/// What is wrong with a row that was not taken.
InputError RowReader::refused(std::string_view line) const {
  const std::size_t columns = m_values.size();
  const std::string counts =
      fmt::format("{} values in row {} of {}", columns, m_row + 1, m_frame.rows);
  std::string_view rest = line;
  for (std::size_t k = 0; k < columns; ++k) {
    const std::string_view token = next_token(rest);
    if (token.empty())
      return unexpected(here(), counts, fmt::format("{}: {}", k, quoted(std::string(line))));
    double value = 0.0;
    if (m_values[k] && !read_number(token.data(), token.data() + token.size(), value))
      return unexpected(here(), fmt::format("a finite number in column \"{}\"", m_frame.names[k]),
                        quoted(std::string(token)));
  }
  return unexpected(here(), counts, fmt::format("more: {}", quoted(std::string(line))));
}

void RowReader::read(std::string_view line) {
  if (m_row == m_held)
    set_memory_aside();
  if (!take(line))
    throw refused(line);
  ++m_row;
}

void RowReader::read_lines(std::string_view text) {
  const bool is_binary = std::memchr(text.data(), '\0', text.size()) != nullptr;
  while (!text.empty()) {
    const std::size_t length = text.find('\n');
    const std::string_view line = without_return(text.substr(0, length));
    if (is_binary && line.find('\0') != line.npos)
      throw nul_byte(here());
    read(line);
    text.remove_prefix(length + 1);
  }
}

void RowReader::finish() {
  for (auto& column : m_frame.columns)
    column.resize(std::min(column.size(), m_row));
}

void read_rows(Frame& frame) {
  if (frame.unread.empty())
    return;
  RowReader reader(frame);
  reader.read_lines(frame.unread);
  reader.finish();
  frame.unread.clear();
}

} // namespace ellipsoid::post
