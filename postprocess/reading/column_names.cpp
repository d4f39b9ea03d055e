// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "column_names.h"

#include "named_once.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ellipsoid::post {

const std::vector<std::string> known_columns = {
    "id",           "type",      "mass",     "x",        "y",        "z",      "vx",
    "vy",           "vz",        "omegax",   "omegay",   "omegaz",   "quat1",  "quat2",
    "quat3",        "quat4",     "shapex",   "shapey",   "shapez",   "radius", "diameter",
    "f_subspheres", "f_spacing", "inertiax", "inertiay", "inertiaz", "xu",     "yu",
    "zu",           "xs",        "ys",       "zs",       "xsu",      "ysu",    "zsu",
    "ix",           "iy",        "iz"};

void add_column_name(ColumnNames& names, const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  const std::string name = assignment.substr(0, sign);
  if (sign == std::string::npos || sign + 1 == assignment.size())
    throw InputError(fmt::format("--column \"{}\": expected NAME=COLUMN", assignment));
  if (std::find(known_columns.begin(), known_columns.end(), name) == known_columns.end())
    throw InputError(fmt::format("--column \"{}\": NAME must be one of {}", assignment,
                                 fmt::join(known_columns, " ")));
  names[name] = assignment.substr(sign + 1);
}

NamedColumns::NamedColumns(const Frame& frame, const ColumnNames& names)
    : frame_(frame), names_(names) {
  for (const auto& [name, column] : names)
    frame.required(column, fmt::format("--column {}={}", name, column));
}

/// Number of a column in the frame, or -1.
std::ptrdiff_t NamedColumns::index_of(const std::string& name) const {
  const auto named = names_.find(name);
  const std::vector<std::string>& there = frame_.names;
  const std::string& column = named == names_.end() ? name : named->second;
  const auto found = std::find(there.begin(), there.end(), column);
  if (found != there.end())
    require_once(frame_, column);
  return found == there.end() ? -1 : found - there.begin();
}

Column NamedColumns::find(const std::string& name) const {
  const std::ptrdiff_t index = index_of(name);
  if (index < 0)
    return nullptr;
  const auto k = static_cast<std::size_t>(index);
  if (!frame_.is_readable(k))
    throw InputError(frame_.unreadable[k]);
  return &frame_.columns[k];
}

std::string NamedColumns::fault(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    const std::ptrdiff_t k = index_of(name);
    if (k >= 0 && !frame_.is_readable(static_cast<std::size_t>(k)))
      return frame_.unreadable[static_cast<std::size_t>(k)];
  }
  return "";
}

VectorColumns NamedColumns::find(const std::string& x, const std::string& y,
                                 const std::string& z) const {
  return {find(x), find(y), find(z)};
}

} // namespace ellipsoid::post
