// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "text_dump.h"

#include "number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Columns that hold words, not numbers; their values are not kept.
constexpr std::array<std::string_view, 1> text_columns = {"element"};

/// More columns than this is not a dump.
constexpr std::size_t most_columns = 10000;

/// Rows for which memory is set aside before they were seen: a wrong count in a broken file must
/// not ask for all the memory of the machine.
constexpr std::size_t most_rows_ahead = std::size_t{1} << 18;

bool is_blank(char letter) { return letter == ' ' || letter == '\t'; }

/// Cuts the next blank-separated token off `rest`; empty at the end.
std::string_view next_token(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end]))
    ++end;
  const std::string_view token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

std::vector<std::string> tokens_of(std::string_view text) {
  std::vector<std::string> tokens;
  for (auto token = next_token(text); !token.empty(); token = next_token(text))
    tokens.emplace_back(token);
  return tokens;
}

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

/// The text without blanks at its end.
std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

bool is_text_column(std::string_view name) {
  return std::find(text_columns.begin(), text_columns.end(), name) != text_columns.end();
}

} // namespace

TextDumpReader::TextDumpReader(std::unique_ptr<ByteSource> source, const std::string& name)
    : m_lines(std::move(source), name) {}

TextDumpReader::TextDumpReader(const std::string& path) : TextDumpReader(open_bytes(path), path) {}

FilePlace TextDumpReader::here() const { return {m_lines.name(), m_lines.line_number(), m_frame}; }

InputError TextDumpReader::cut_off(const std::string& expected) const {
  FilePlace place = here();
  ++place.line;
  return unexpected(place, expected, "the end of the file (the last frame is cut off)");
}

/// A line that cannot be read is one of the frame.
bool TextDumpReader::next_line(std::string_view& line) {
  try {
    return m_lines.next(line);
  } catch (const BrokenLine& broken) {
    FilePlace place = broken.place;
    place.frame = m_frame;
    throw unexpected(place, broken.expected, broken.found);
  }
}

std::string_view TextDumpReader::line_of(const char* expected) {
  std::string_view line;
  if (!next_line(line))
    throw cut_off(expected);
  return line;
}

double TextDumpReader::number(std::string_view token, const char* expected) const {
  double value = 0.0;
  const char* end = token.data() + token.size();
  if (read_number(token.data(), end, value) != end)
    throw unexpected(here(), expected, quoted(std::string(token)));
  return value;
}

std::int64_t TextDumpReader::integer(std::string_view token, const char* expected) const {
  std::int64_t value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || result.ec != std::errc() || result.ptr != token.data() + token.size())
    throw unexpected(here(), expected, quoted(std::string(token)));
  return value;
}

void TextDumpReader::read_box(Frame& frame, std::string_view title) {
  frame.box = Box();
  std::vector<std::string> words = tokens_of(title.substr(std::string_view("BOX BOUNDS").size()));
  for (const auto& word : words)
    if (word != "xy" && word != "xz" && word != "yz")
      frame.box.boundary += (frame.box.boundary.empty() ? "" : " ") + word;
  for (int k = 0; k < 3; ++k) {
    std::string_view rest = line_of("the lower and upper bound of the box");
    frame.box.lower[k] = number(next_token(rest), "the lower bound of the box, a number");
    frame.box.upper[k] = number(next_token(rest), "the upper bound of the box, a number");
  }
}

/// One section of the header behind "ITEM: "; true when it was the one that announces the rows.
bool TextDumpReader::read_section(Frame& frame, std::string_view title) {
  if (starts_with(title, "NUMBER OF ")) {
    const char* expected = "the number of rows, a whole number >= 0";
    std::string_view rest = line_of(expected);
    const std::string_view token = next_token(rest);
    const std::int64_t rows = integer(token, expected);
    if (rows < 0)
      throw unexpected(here(), expected, quoted(std::string(token)));
    frame.rows = static_cast<std::size_t>(rows);
  } else if (starts_with(title, "BOX BOUNDS")) {
    read_box(frame, title);
  } else if (starts_with(title, "TIME")) {
    std::string_view rest = line_of("the time");
    frame.time = number(next_token(rest), "the time, a number");
  } else if (starts_with(title, "UNITS")) {
    m_units = line_of("the unit system");
  } else {
    frame.names = tokens_of(title);
    if (frame.names.size() < 2 || frame.names.size() > most_columns)
      throw unexpected(here(), "\"ITEM: ATOMS\" with the names of the columns",
                       quoted("ITEM: " + std::string(title)));
    frame.label = frame.names.front();
    frame.names.erase(frame.names.begin());
    return true;
  }
  return false;
}

void TextDumpReader::read_header(Frame& frame) {
  constexpr std::string_view item = "ITEM: ";
  const char* timestep_wanted = "the time step, a whole number";
  std::string_view rest = line_of(timestep_wanted);
  frame.timestep = integer(next_token(rest), timestep_wanted);
  constexpr std::size_t no_count = static_cast<std::size_t>(-1);
  frame.rows = no_count;
  for (;;) {
    const std::string_view line = line_of("\"ITEM: ATOMS\" with the names of the columns");
    if (!starts_with(line, item))
      throw unexpected(here(), "a line that begins with \"ITEM: \"", quoted(std::string(line)));
    if (read_section(frame, line.substr(item.size())))
      break;
  }
  if (frame.rows == no_count)
    throw unexpected(here(), "\"ITEM: NUMBER OF ATOMS\" before the rows", "none");
  frame.units = m_units;
}

/// False when the line is no row of numbers.
bool TextDumpReader::read_row(Frame& frame, std::string_view line, std::size_t row) const {
  const char* place = line.data();
  const char* const end = place + line.size();
  const auto skip = [&](bool blanks) {
    while (place < end && is_blank(*place) == blanks)
      ++place;
  };
  for (std::size_t k = 0; k < m_is_text.size(); ++k) {
    skip(true);
    if (place == end)
      return false;
    if (m_is_text[k])
      skip(false);
    else if (!(place = read_number(place, end, frame.columns[k][row])))
      return false;
  }
  skip(true);
  return place == end;
}

/// What is wrong with a row that read_row refused.
InputError TextDumpReader::refused_row(const Frame& frame, std::string_view line,
                                       std::size_t row) const {
  const std::string counts =
      fmt::format("{} values in row {} of {}", frame.names.size(), row + 1, frame.rows);
  std::string_view rest = line;
  for (std::size_t k = 0; k < frame.names.size(); ++k) {
    const std::string_view token = next_token(rest);
    if (token.empty())
      return unexpected(here(), counts, fmt::format("{}: {}", k, quoted(std::string(line))));
    double value = 0.0;
    if (!m_is_text[k] && !read_number(token.data(), token.data() + token.size(), value))
      return unexpected(here(), fmt::format("a finite number in column \"{}\"", frame.names[k]),
                        quoted(std::string(token)));
  }
  return unexpected(here(), counts, fmt::format("more: {}", quoted(std::string(line))));
}

void TextDumpReader::read_rows(Frame& frame) {
  const std::size_t columns = frame.names.size();
  frame.columns.resize(columns);
  m_is_text.resize(columns);
  for (std::size_t k = 0; k < columns; ++k)
    m_is_text[k] = is_text_column(frame.names[k]);
  std::size_t held = 0;
  for (std::size_t row = 0; row < frame.rows; ++row) {
    if (row == held) {
      held = std::min(frame.rows, held + most_rows_ahead);
      for (std::size_t k = 0; k < columns; ++k)
        frame.columns[k].resize(m_is_text[k] ? 0 : held);
    }
    std::string_view line;
    const bool more = next_line(line);
    if (!more || starts_with(line, "ITEM:")) {
      const std::string expected = fmt::format("row {} of {}", row + 1, frame.rows);
      throw more ? unexpected(here(), expected, quoted(std::string(line))) : cut_off(expected);
    }
    if (!read_row(frame, line, row))
      throw refused_row(frame, line, row);
  }
  for (auto& column : frame.columns)
    column.resize(std::min(column.size(), frame.rows));
}

/// From a frame's first line to "ITEM: TIMESTEP"; units and time may stand before it.
void TextDumpReader::read_preamble(Frame& frame, std::string_view line) {
  frame.time.reset();
  constexpr const char* expected = "\"ITEM: TIMESTEP\"";
  while (without_blanks(line) != "ITEM: TIMESTEP") {
    if (without_blanks(line) != "ITEM: UNITS" && without_blanks(line) != "ITEM: TIME")
      throw unexpected(here(), expected, quoted(std::string(line)));
    read_section(frame, line.substr(std::string_view("ITEM: ").size()));
    line = line_of(expected);
  }
}

bool TextDumpReader::next(Frame& frame) {
  ++m_frame;
  std::string_view line;
  do { // blank lines between frames, as when files are joined
    if (!next_line(line))
      return false;
  } while (without_blanks(line).empty());
  read_preamble(frame, line);
  frame.place = here();
  read_header(frame);
  frame.place.line = m_lines.line_number() + 1;
  read_rows(frame);
  return true;
}

} // namespace ellipsoid::post
