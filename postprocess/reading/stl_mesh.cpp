// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "stl_mesh.h"

#include "input_error.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace ellipsoid::post {
namespace {

using Triangle = std::array<Vector3, 3>;

constexpr std::size_t head_size = 84, triangle_size = 50; ///< of a binary file (bytes)

std::uint32_t whole_number(const char* bytes) {
  std::uint32_t value = 0;
  for (unsigned k = 0; k < 4; ++k)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) << 8 * k;
  return value;
}

double real_number(const char* bytes) {
  const std::uint32_t bits = whole_number(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return static_cast<double>(value);
}

std::vector<Triangle> binary_triangles(const std::string& bytes) {
  std::vector<Triangle> triangles;
  for (std::size_t at = head_size; at + triangle_size <= bytes.size(); at += triangle_size) {
    Triangle triangle;
    for (unsigned corner = 0; corner < 3; ++corner) {
      const char* first = bytes.data() + at + 12 + 12 * corner; // behind the normal
      triangle[corner] = {real_number(first), real_number(first + 4), real_number(first + 8)};
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<Triangle> text_triangles(const std::string& bytes, const std::string& path) {
  std::istringstream words(bytes);
  std::vector<Triangle> triangles;
  std::string word;
  unsigned corner = 0;
  bool has_end = false;
  while (words >> word) {
    has_end = has_end || word == "endsolid";
    if (word != "vertex")
      continue;
    if (corner == 0)
      triangles.emplace_back();
    Vector3& v = triangles.back()[corner];
    if (!(words >> v.x >> v.y >> v.z))
      throw unexpected({path, 0, 0}, "three numbers after \"vertex\"", "something else or the end");
    corner = (corner + 1) % 3;
  }
  if (corner != 0 || !has_end)
    throw unexpected({path, 0, 0}, "whole triangles and \"endsolid\"", "the end of the file");
  return triangles;
}

} // namespace

std::vector<Triangle> read_stl(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path + ": cannot be opened; give an STL file that is there");
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const bool is_binary =
      bytes.size() >= head_size &&
      bytes.size() == head_size + triangle_size * whole_number(bytes.data() + head_size - 4);
  if (!is_binary && bytes.compare(0, 5, "solid") != 0)
    throw unexpected({path, 0, 0},
                     "an STL file (\"solid ...\", or binary with as many triangles as "
                     "its head says)",
                     "something else, or a file cut off");
  auto triangles = is_binary ? binary_triangles(bytes) : text_triangles(bytes, path);
  for (const Triangle& triangle : triangles)
    for (const Vector3& corner : triangle)
      if (!std::isfinite(corner.x + corner.y + corner.z))
        throw unexpected({path, 0, 0}, "finite coordinates", "a corner that is none");
  return triangles;
}

} // namespace ellipsoid::post
