// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid_host {

/// A wall whose contact law is kept in restart files (by fix pair_settings/ellipsoid).
class HasLaw {
 public:
  virtual ~HasLaw() = default;
  /// Models and settings, as in the command.
  virtual const std::string& law() const = 0;
};

} // namespace ellipsoid_host
