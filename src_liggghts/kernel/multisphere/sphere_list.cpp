// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/sphere_list.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace ellipsoid {
namespace {

[[noreturn]] void refuse(int line, const std::string& what) {
  throw std::invalid_argument("list of spheres, line " + std::to_string(line) + ": " + what);
}

/// Lines end with \n, \r\n or \r; a byte order mark at the beginning says nothing here.
std::string with_plain_lines(const std::string& text) {
  const std::string mark = "\xEF\xBB\xBF";
  std::string plain;
  for (std::size_t i = text.compare(0, mark.size(), mark) == 0 ? mark.size() : 0; i < text.size();
       ++i)
    if (text[i] != '\r')
      plain += text[i];
    else if (i + 1 == text.size() || text[i + 1] != '\n')
      plain += '\n';
  return plain;
}

std::vector<std::string> words_of(std::string line) {
  line.resize(std::min(line.size(), line.find('#')));
  for (char& c : line)
    if (c == ',' || c == ';')
      c = ' ';
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#' || line[first] == '%' ||
         line.compare(first, 2, "//") == 0;
}

std::optional<double> number_of(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return end == word.c_str() || *end ? std::nullopt : std::optional<double>(value);
}

/// Where x, y, z and r stand in a line.
using Columns = std::array<std::size_t, 4>;

/// Of column k: x, y, z, r or radius.
bool is_name(std::string word, std::size_t k) {
  word.erase(std::remove(word.begin(), word.end(), '"'), word.end());
  for (char& c : word)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word == std::string(1, "xyzr"[k]) || (k == 3 && word == "radius");
}

/// From the words of the first line.
Columns named_columns(int line, const std::vector<std::string>& words) {
  Columns columns{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [k](const std::string& word) { return is_name(word, k); });
    if (found == words.end())
      refuse(line, std::string("no column ") + "xyzr"[k] +
                       "; a first line of words names the columns x, y, z and r (or radius)");
    columns[k] = static_cast<std::size_t>(found - words.begin());
    if (std::any_of(found + 1, words.end(),
                    [&](const std::string& word) { return is_name(word, k); }))
      refuse(line, std::string("two columns ") + "xyzr"[k] + "; leave one of the names out");
  }
  return columns;
}

void add_sphere(int line, const std::vector<std::string>& words, const Columns& columns,
                SphereSet& set) {
  double values[4];
  for (std::size_t k = 0; k < 4; ++k) {
    if (columns[k] >= words.size())
      refuse(line, std::to_string(words.size()) + " values; x y z r are needed");
    const std::optional<double> value = number_of(words[columns[k]]);
    if (!value)
      refuse(line, "'" + words[columns[k]] + "'; x y z r are numbers");
    values[k] = *value;
  }
  set.centres.push_back({values[0], values[1], values[2]});
  set.radii.push_back(values[3]);
}

} // namespace

SphereList parse_sphere_list(const std::string& text) {
  SphereList list;
  std::optional<std::size_t> width; // of the first line
  Columns columns{0, 1, 2, 3};
  if (text.find('\0') != std::string::npos)
    throw std::invalid_argument("list of spheres: it is no plain text; lines x y z r are needed");
  std::istringstream lines(with_plain_lines(text));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (is_comment(line)) {
      list.is_body_frame = list.is_body_frame || line.find(body_frame_mark) != std::string::npos;
      continue;
    }
    const std::vector<std::string> words = words_of(line);
    const bool is_first = !width;
    if (is_first) {
      width = words.size();
      if (!words.empty() && !number_of(words.front())) {
        columns = named_columns(number, words);
        continue;
      }
      if (words.size() != 4)
        refuse(number, std::to_string(words.size()) +
                           " values; x y z r are needed, or a first line that names the columns");
    }
    if (words.size() != *width)
      refuse(number, std::to_string(words.size()) + " values, the first line has " +
                         std::to_string(*width));
    add_sphere(number, words, columns, list.spheres);
  }
  if (list.spheres.count() == 0)
    throw std::invalid_argument("list of spheres: no sphere; lines x y z r are needed");
  return list;
}

std::string body_frame_list(const SphereSet& set, const std::string& title) {
  std::string text = "# " + title + "\n# " + body_frame_mark +
                     " (origin: centre of mass; axes: the principal ones)\nx,y,z,r\n";
  for (std::size_t k = 0; k < set.centres.size(); ++k) {
    const Vector3& c = set.centres[k];
    char line[128];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%.17g\n", c.x, c.y, c.z, set.radii[k]);
    text += line;
  }
  return text;
}

} // namespace ellipsoid
