// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame.h"

#include "named_once.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ellipsoid::post {

int Frame::find(const std::string& name) const {
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end())
    return -1;
  const std::ptrdiff_t k = it - names.begin();
  require_once(*this, name);
  if (!is_readable(static_cast<std::size_t>(k)))
    throw InputError(unreadable[static_cast<std::size_t>(k)]);
  return static_cast<int>(k);
}

void require_once(const Frame& frame, const std::string& name) {
  if (std::count(frame.names.begin(), frame.names.end(), name) > 1)
    throw unexpected(frame.location, fmt::format("one column \"{}\"", name),
                     fmt::format("several: {}", fmt::join(frame.names, " ")));
}

const std::vector<double>& Frame::required(const std::string& name,
                                           const std::string& purpose) const {
  const int k = find(name);
  if (k < 0)
    throw unexpected(location, fmt::format("a column \"{}\" ({})", name, purpose),
                     fmt::format("only: {}", fmt::join(names, " ")));
  return columns[static_cast<std::size_t>(k)];
}

} // namespace ellipsoid::post
