// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "clump_files.h"

#include "input_error.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ellipsoid::post {
namespace {

ClumpTemplate read_clump(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  if (!stream || !(content << stream.rdbuf()))
    throw InputError(fmt::format("--clump: file \"{}\" cannot be read, or is empty", file));
  try {
    return make_clump(parse_sphere_list(content.str()));
  } catch (const std::invalid_argument& problem) {
    throw InputError(fmt::format("--clump: file \"{}\": {}", file, problem.what()));
  }
}

/// The number before "=", or 0.
int number_before(const std::string& assignment, std::size_t equals) {
  const std::string digits = assignment.substr(0, equals);
  const bool is_number = !digits.empty() && digits.size() <= 3 &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? std::stoi(digits) : 0;
}

} // namespace

ClumpFiles::ClumpFiles(const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    const int number = equals == std::string::npos ? 0 : number_before(assignment, equals);
    if (number == 0)
      throw InputError(fmt::format("--clump \"{}\": allowed is NUMBER=FILE with a number from 1 to "
                                   "{}: that of the clump's template, f_spacing less {}",
                                   assignment, largest_clump_number, clump_spacing));
    if (!clumps_.emplace(number, read_clump(assignment.substr(equals + 1))).second)
      throw InputError(fmt::format("--clump: clump {} is given twice; give each one once", number));
  }
}

const ClumpTemplate& ClumpFiles::find(double spacing, int count, const Vector3& semiaxes) const {
  const int number = static_cast<int>(spacing) - clump_spacing;
  const auto found = clumps_.find(number);
  if (spacing != std::floor(spacing) || found == clumps_.end())
    throw std::invalid_argument(fmt::format(
        "it is clump {} (f_spacing {}), whose spheres the file does not hold: give --clump "
        "{}=FILE, the file of its template",
        number, spacing, number));
  const ClumpTemplate& clump = found->second;
  if (clump.spheres.count() != count)
    throw std::invalid_argument(fmt::format("--clump {}: the file has {} spheres, the particle {}",
                                            number, clump.spheres.count(), count));
  if (!has_shape_of(clump, semiaxes))
    throw std::invalid_argument(
        fmt::format("--clump {}: the file's spheres reach {} {} {} along the body's axes, those of "
                    "the particle {} {} {}: it is another shape",
                    number, clump.semiaxes.x, clump.semiaxes.y, clump.semiaxes.z, semiaxes.x,
                    semiaxes.y, semiaxes.z));
  return clump;
}

} // namespace ellipsoid::post
