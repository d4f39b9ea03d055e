// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "legacy_vtk_check.h"

#include "byte_source.h"

#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

namespace ellipsoid::post {
namespace {

/// Bytes of one value of a type's name in binary files.
std::size_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"char", 1},     {"unsigned_char", 1}, {"short", 2},        {"unsigned_short", 2},
      {"int", 4},      {"unsigned_int", 4},  {"long", 8},         {"unsigned_long", 8},
      {"float", 4},    {"double", 8},        {"vtktypeint64", 8}, {"vtktypeuint64", 8},
      {"vtkIdType", 4}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

/// Walks through a legacy file section by section.
class LegacyFile {
 public:
  LegacyFile(std::string path, std::string text)
      : m_path(std::move(path)), m_text(std::move(text)) {}

  void check() {
    if (m_text.empty() || line().rfind("# vtk DataFile", 0) != 0)
      return; // VTK says what is wrong with it
    line();   // title
    m_is_binary = line() == "BINARY";
    while (m_position < m_text.size())
      section(line());
    if (m_text.back() != '\n')
      throw cut("the end of the last line");
    if (m_points > 0 && !m_has_data)
      throw cut("the values of the points (POINT_DATA)");
    if (m_arrays > 0)
      throw cut(fmt::format("{} more arrays", m_arrays));
  }

 private:
  InputError cut(const std::string& expected) const {
    return InputError(
        fmt::format("{}: expected {}, found the end of the file: it is cut off", m_path, expected));
  }
  std::string line() {
    const std::size_t end = std::min(m_text.find('\n', m_position), m_text.size());
    std::string text = m_text.substr(m_position, end - m_position);
    m_position = std::min(end + 1, m_text.size());
    while (!text.empty() && (is_blank(text.back()) || text.back() == '\r'))
      text.pop_back();
    return text;
  }
  /// The whole number at a position of a header, 0 where there is none.
  static std::size_t count(const std::vector<std::string>& words, std::size_t k) {
    std::size_t value = 0;
    if (k < words.size())
      std::from_chars(words[k].data(), words[k].data() + words[k].size(), value);
    return value;
  }
  /// Steps over `values` values.
  void skip(std::size_t values, const std::string& type, const std::string& what) {
    if (m_is_binary) {
      const std::size_t left = m_text.size() - m_position, size = bytes_of(type);
      if (size == 0 || values > left / size)
        throw cut(fmt::format("{} values of {}", values, what));
      m_position += values * size;
      if (m_position < m_text.size() && m_text[m_position] == '\n')
        ++m_position;
      return;
    }
    for (std::size_t k = 0; k < values; ++k) {
      m_position = m_text.find_first_not_of(" \t\r\n", m_position);
      if (m_position == m_text.npos)
        throw cut(fmt::format("{} values of {}, not {}", values, what, k));
      m_position = std::min(m_text.find_first_of(" \t\r\n", m_position), m_text.size());
    }
    if (m_position < m_text.size())
      line(); // what is left of the last line
  }
  void section(const std::string& header) {
    std::vector<std::string> words;
    std::string_view rest = header;
    for (auto word = next_token(rest); !word.empty(); word = next_token(rest))
      words.emplace_back(word);
    if (words.empty())
      return;
    const std::string& key = words[0];
    if (key == "METADATA") {
      skip_metadata();
    } else if (key == "POINTS") {
      m_points = count(words, 1);
      skip(3 * m_points, type_at(words, 2), "POINTS");
    } else if (key == "POINT_DATA" || key == "CELL_DATA") {
      m_tuples = count(words, 1);
      m_has_data = m_has_data || key == "POINT_DATA";
    } else if (!cells(words) && !attribute(words)) {
      field(words);
    }
  }
  void skip_metadata() {
    while (m_position < m_text.size())
      if (line().empty())
        return;
    throw cut("an empty line behind METADATA");
  }
  static std::string type_at(const std::vector<std::string>& words, std::size_t k) {
    return k < words.size() ? words[k] : "";
  }
  /// Connections of points; false for other sections.
  bool cells(const std::vector<std::string>& words) {
    const std::string& key = words[0];
    if (key == "CELL_TYPES") {
      skip(count(words, 1), "int", key);
    } else if (key == "OFFSETS") {
      skip(m_offsets, type_at(words, 1), key);
    } else if (key == "CONNECTIVITY") {
      skip(m_connections, type_at(words, 1), key);
    } else if (key == "CELLS" || key == "VERTICES" || key == "LINES" || key == "POLYGONS" ||
               key == "TRIANGLE_STRIPS") {
      m_offsets = count(words, 1);
      m_connections = count(words, 2);
      if (m_text.compare(m_position, 7, "OFFSETS") != 0) // before version 5
        skip(m_connections, "int", key);
    } else {
      return false;
    }
    return true;
  }
  /// Values by point; false for other sections.
  bool attribute(const std::vector<std::string>& words) {
    const std::string& key = words[0];
    const std::size_t width = key == "VECTORS" || key == "NORMALS" ? 3 : key == "TENSORS" ? 9 : 1;
    if (key == "SCALARS") {
      if (m_text.compare(m_position, 12, "LOOKUP_TABLE") == 0)
        line();
      skip(m_tuples * std::max<std::size_t>(1, count(words, 3)), type_at(words, 2), words[1]);
    } else if (key == "TEXTURE_COORDINATES") {
      skip(m_tuples * count(words, 2), type_at(words, 3), words[1]);
    } else if (width > 1) {
      skip(m_tuples * width, type_at(words, 2), type_at(words, 1));
    } else {
      return false;
    }
    return true;
  }
  /// "FIELD NAME COUNT", or an array "NAME WIDTH TUPLES TYPE" in it.
  void field(const std::vector<std::string>& words) {
    if (words[0] == "FIELD") {
      m_arrays = count(words, 2);
    } else if (m_arrays > 0 && words.size() == 4) {
      --m_arrays;
      skip(count(words, 1) * count(words, 2), words[3], words[0]);
    } else if (m_arrays > 0) {
      throw cut("an array NAME WIDTH TUPLES TYPE");
    }
  }

  std::string m_path, m_text;
  std::size_t m_position = 0, m_points = 0, m_tuples = 0, m_offsets = 0, m_connections = 0;
  std::size_t m_arrays = 0; ///< of the field that are still to come
  bool m_is_binary = false, m_has_data = false;
};

} // namespace

void check_legacy_vtk(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  LegacyFile(path, {std::istreambuf_iterator<char>(file), {}}).check();
}

} // namespace ellipsoid::post
