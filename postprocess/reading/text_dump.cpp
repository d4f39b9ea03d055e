// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "text_dump.h"

#include "frame_rows.h"
#include "number_text.h"
#include "whole_token.h"

#include <algorithm>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// More columns than this is not a dump.
constexpr std::size_t most_columns = 10000;

/// What no row begins with.
constexpr std::string_view row_stop = "ITEM:";

/// Longer rows of a frame (bytes) are not held as text.
constexpr std::size_t most_text = std::size_t{1} << 26;

std::vector<std::string> tokens_of(std::string_view text) {
  std::vector<std::string> tokens;
  for (auto token = next_token(text); !token.empty(); token = next_token(text))
    tokens.emplace_back(token);
  return tokens;
}

/// The text without blanks at its end.
std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

} // namespace

TextDumpReader::TextDumpReader(std::unique_ptr<ByteSource> source, const std::string& name)
    : lines_(std::move(source), name) {}

TextDumpReader::TextDumpReader(const std::string& path) : TextDumpReader(open_bytes(path), path) {}

FileLocation TextDumpReader::here() const { return {lines_.name(), lines_.line_number(), frame_}; }

InputError TextDumpReader::cut_off(const std::string& expected) const {
  FileLocation location = here();
  ++location.line;
  return unexpected(location, expected, "the end of the file (the last frame is cut off)");
}

/// Adds the frame to the location of a line that cannot be read.
bool TextDumpReader::next_line(std::string_view& line) {
  try {
    return lines_.next(line);
  } catch (const BrokenLine& broken) {
    FileLocation location = broken.location;
    location.frame = frame_;
    throw unexpected(location, broken.expected, broken.found);
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
  const auto value = whole_token<std::int64_t>(token);
  if (!value)
    throw unexpected(here(), expected, quoted(std::string(token)));
  return *value;
}

namespace {

/// The edges of a tilted box and its two corners, from the bounds of the rectangle around it.
/// @param[in] tilts xy, xz, yz (length)
void set_tilted(Box& box, const double (&tilts)[3]) {
  const auto [xy, xz, yz] = tilts;
  box.lower[0] -= std::min({0.0, xy, xz, xy + xz});
  box.upper[0] -= std::max({0.0, xy, xz, xy + xz});
  box.lower[1] -= std::min(0.0, yz);
  box.upper[1] -= std::max(0.0, yz);
  const double width[3] = {box.upper[0] - box.lower[0], box.upper[1] - box.lower[1],
                           box.upper[2] - box.lower[2]};
  if (xy != 0.0 || xz != 0.0 || yz != 0.0)
    box.tilted_edges = {{width[0], 0.0, 0.0}, {xy, width[1], 0.0}, {xz, yz, width[2]}};
  box.upper[0] += xy + xz;
  box.upper[1] += yz;
}

/// "pp", "fs" ...: what the box does at both sides of an axis; none: the file does not say it.
bool are_sides(const std::vector<std::string>& words) {
  return words.empty() ||
         (words.size() == 3 && std::all_of(words.begin(), words.end(), [](auto& w) {
            return w.size() == 2 && w.find_first_not_of("pfsm") == std::string::npos &&
                   (w[0] == 'p') == (w[1] == 'p');
          }));
}

/// The first axis along which the bounds leave no room for the tilts, or 3.
std::size_t impossible_axis(const Box& box, const double (&tilts)[3]) {
  const double shifts[3] = {tilts[0] + tilts[1], tilts[2], 0.0}; // of the opposite corner
  std::size_t k = 0;
  while (k < 3 && box.lower[k] <= box.upper[k] - shifts[k])
    ++k;
  return k;
}

/// The corner opposite to the origin of a box of three edges.
void set_upper(Box& box) {
  for (std::size_t k = 0; k < 3; ++k)
    box.upper[k] = box.lower[k];
  for (const Vector3& edge : box.tilted_edges) {
    box.upper[0] += edge.x;
    box.upper[1] += edge.y;
    box.upper[2] += edge.z;
  }
}

} // namespace

/// Three lines: "lower upper" of a box along the axes, "lower upper tilt" (xy, xz, yz) with the
/// bounds of the rectangle around a tilted box, "x y z origin" for each of three general edges.
void TextDumpReader::read_box(Frame& frame, std::string_view title) {
  frame.box = Box();
  std::vector<std::string> words = tokens_of(title.substr(std::string_view("BOX BOUNDS").size()));
  const auto is_said = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const bool is_general = is_said("abc"), is_tilted = is_said("xy");
  for (const auto& word : words)
    if (word != "xy" && word != "xz" && word != "yz" && word != "abc" && word != "origin")
      frame.box.boundary += (frame.box.boundary.empty() ? "" : " ") + word;
  if (!are_sides(tokens_of(frame.box.boundary)))
    throw unexpected(here(), "what the box does at its sides, as pp, ff or fs for each of x, y, z",
                     quoted(frame.box.boundary));
  double tilts[3] = {0.0, 0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    std::string_view rest = line_of("the lower and upper bound of the box");
    if (is_general) {
      Vector3& edge = frame.box.tilted_edges.emplace_back();
      for (double* x : {&edge.x, &edge.y, &edge.z})
        *x = number(next_token(rest), "an edge of the box, three numbers");
      frame.box.lower[k] = number(next_token(rest), "the origin of the box, a number");
    } else {
      frame.box.lower[k] = number(next_token(rest), "the lower bound of the box, a number");
      frame.box.upper[k] = number(next_token(rest), "the upper bound of the box, a number");
      if (is_tilted)
        tilts[k] = number(next_token(rest), "a tilt of the box, a number");
    }
    if (const std::string_view more = next_token(rest); !more.empty())
      throw unexpected(here(), "the end of the line with the box's bounds",
                       quoted(std::string(more)));
  }
  if (is_tilted)
    set_tilted(frame.box, tilts);
  if (is_general) {
    set_upper(frame.box);
  } else if (const std::size_t k = impossible_axis(frame.box, tilts); k < 3 && frame.rows > 0) {
    throw unexpected(
        here(), "a lower bound of the box below the upper one (and below it by the tilts)",
        fmt::format("{} and {} for {}", frame.box.lower[k], frame.box.upper[k], "xyz"[k]));
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
    units_ = line_of("the unit system");
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
  frame.units = units_;
}

/// Takes the rows as text; those of a frame that ends otherwise than with a last whole line, or is
/// very large, are read here.
void TextDumpReader::load_rows(Frame& frame) {
  frame.unread.clear();
  const std::size_t taken = lines_.append_lines(frame.rows, row_stop, most_text, frame.unread);
  if (taken == frame.rows && taken > 0)
    return;
  RowReader reader(frame);
  reader.read_lines(frame.unread);
  std::string().swap(frame.unread); // it may be very large
  for (std::size_t row = taken; row < frame.rows; ++row) {
    std::string_view line;
    const bool more = next_line(line);
    if (!more || starts_with(line, row_stop)) {
      const std::string expected = fmt::format("row {} of {}", row + 1, frame.rows);
      throw more ? unexpected(here(), expected, quoted(std::string(line))) : cut_off(expected);
    }
    reader.read(line);
    if (!lines_.line_has_end() && without_blanks(line).size() == line.size())
      throw unexpected(here(), "the end of the line behind the last row",
                       "the end of the file (cut off; if it is whole, add a line end)");
  }
  reader.drop_missing_rows();
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
  if (!next_unread(frame))
    return false;
  read_rows(frame);
  return true;
}

bool TextDumpReader::next_unread(Frame& frame) {
  ++frame_;
  std::string_view line;
  do { // blank lines between frames, as when files are joined
    if (!next_line(line))
      return false;
  } while (without_blanks(line).empty());
  read_preamble(frame, line);
  frame.location = here();
  read_header(frame);
  frame.location.line = lines_.line_number() + 1;
  load_rows(frame);
  return true;
}

} // namespace ellipsoid::post
