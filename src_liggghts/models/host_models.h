// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The contact models of a pair style, as the host has chosen and compiled them.
#pragma once

#include "host_contact.h"
#include "property_registry.h"

#include <cstdint>
#include <memory>
#include <string>

namespace LIGGGHTS {
namespace ContactModels {

class HostModels {
 public:
  virtual ~HostModels() = default;
  virtual int64_t hashcode() = 0;
  virtual double stress_strain_exponent() = 0;
  /// Whether the model of a kind ("normal", "tangential" ...) has this name.
  virtual bool contact_match(const std::string& kind, const std::string& name) = 0;
  /// Returns what is wrong, or an empty string.
  virtual std::string read_settings(int count, char** arguments, IContactHistorySetup* setup) = 0;
  virtual void connect(PropertyRegistry& registry) = 0;
  virtual void begin_pass(SurfacesIntersectData& data) = 0;
  virtual void end_pass(SurfacesIntersectData& data) = 0;
  /// Adds the forces of a contact on i and j.
  virtual void apply(SurfacesIntersectData& contact, ForceData& force_i, ForceData& force_j) = 0;
  /// The contact is over: its part of the history is cleared.
  virtual void close(SurfacesIntersectData& contact) = 0;
};

enum class ContactSurface { other, smooth, multisphere };

/// @param[in] variant number of the chosen models, see select_models()
ContactSurface surface_of(std::int64_t variant);

/// Null where the number is none of models.
std::unique_ptr<HostModels> make_models(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* setup,
                                        std::int64_t variant);

} // namespace ContactModels
} // namespace LIGGGHTS
