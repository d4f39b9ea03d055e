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
  LegacyFile(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}

  void check() {
    if (text_.empty() || line().rfind("# vtk DataFile", 0) != 0)
      return; // VTK says what is wrong with it
    line();   // title
    is_binary_ = line() == "BINARY";
    while (position_ < text_.size())
      section(line());
    if (text_.back() != '\n')
      throw cut("the end of the last line");
    if (points_ > 0 && !has_data_)
      throw cut("the values of the points (POINT_DATA)");
    if (arrays_ > 0)
      throw cut(fmt::format("{} more arrays", arrays_));
  }

 private:
  InputError cut(const std::string& expected) const {
    return InputError(
        fmt::format("{}: expected {}, found the end of the file: it is cut off", path_, expected));
  }
  std::string line() {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    std::string text = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
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
    if (is_binary_) {
      const std::size_t left = text_.size() - position_, size = bytes_of(type);
      if (size == 0 || values > left / size)
        throw cut(fmt::format("{} values of {}", values, what));
      position_ += values * size;
      if (position_ < text_.size() && text_[position_] == '\n')
        ++position_;
      return;
    }
    for (std::size_t k = 0; k < values; ++k) {
      position_ = text_.find_first_not_of(" \t\r\n", position_);
      if (position_ == text_.npos)
        throw cut(fmt::format("{} values of {}, not {}", values, what, k));
      position_ = std::min(text_.find_first_of(" \t\r\n", position_), text_.size());
    }
    if (position_ < text_.size())
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
      points_ = count(words, 1);
      skip(3 * points_, type_at(words, 2), "POINTS");
    } else if (key == "POINT_DATA" || key == "CELL_DATA") {
      tuples_ = count(words, 1);
      has_data_ = has_data_ || key == "POINT_DATA";
    } else if (!cells(words) && !attribute(words)) {
      field(words);
    }
  }
  void skip_metadata() {
    while (position_ < text_.size())
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
      skip(offsets_, type_at(words, 1), key);
    } else if (key == "CONNECTIVITY") {
      skip(connections_, type_at(words, 1), key);
    } else if (key == "CELLS" || key == "VERTICES" || key == "LINES" || key == "POLYGONS" ||
               key == "TRIANGLE_STRIPS") {
      offsets_ = count(words, 1);
      connections_ = count(words, 2);
      if (text_.compare(position_, 7, "OFFSETS") != 0) // before version 5
        skip(connections_, "int", key);
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
      if (text_.compare(position_, 12, "LOOKUP_TABLE") == 0)
        line();
      skip(tuples_ * std::max<std::size_t>(1, count(words, 3)), type_at(words, 2), words[1]);
    } else if (key == "TEXTURE_COORDINATES") {
      skip(tuples_ * count(words, 2), type_at(words, 3), words[1]);
    } else if (width > 1) {
      skip(tuples_ * width, type_at(words, 2), type_at(words, 1));
    } else {
      return false;
    }
    return true;
  }
  /// "FIELD NAME COUNT", or an array "NAME WIDTH TUPLES TYPE" in it.
  void field(const std::vector<std::string>& words) {
    if (words[0] == "FIELD") {
      arrays_ = count(words, 2);
    } else if (arrays_ > 0 && words.size() == 4) {
      --arrays_;
      skip(count(words, 1) * count(words, 2), words[3], words[0]);
    } else if (arrays_ > 0) {
      throw cut("an array NAME WIDTH TUPLES TYPE");
    }
  }

  std::string path_, text_;
  std::size_t position_ = 0, points_ = 0, tuples_ = 0, offsets_ = 0, connections_ = 0;
  std::size_t arrays_ = 0; ///< of the field that are still to come
  bool is_binary_ = false, has_data_ = false;
};

} // namespace

void check_legacy_vtk(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  LegacyFile(path, {std::istreambuf_iterator<char>(file), {}}).check();
}

} // namespace ellipsoid::post
