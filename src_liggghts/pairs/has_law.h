// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <string>

namespace ellipsoid_host {

/// A wall whose contact law and kind are kept in restart files (by fix pair_settings/ellipsoid).
class HasLaw {
 public:
  virtual ~HasLaw() = default;
  /// Models and settings, as in the command.
  virtual const std::string& law() const = 0;
  /// What the wall is, to which its contacts belong: 'zplane', 'xcylinder', or 'meshes ID ...'.
  virtual std::string kind() const = 0;
};

} // namespace ellipsoid_host
