// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The contact models of a pair style, as the host has chosen and compiled them.
#pragma once

#include "contact_models.h"
#include "settings.h"

#include <cstdint>
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

/// @tparam Model the host's ContactModel<...>
template <typename Model> class HostModelsOf final : public HostModels, protected Pointers {
 public:
  HostModelsOf(LAMMPS* lmp, IContactHistorySetup* setup, int64_t hash)
      : Pointers(lmp), model_(lmp, setup, false, hash) {}

  int64_t hashcode() override { return model_.hashcode(); }
  double stress_strain_exponent() override { return model_.stressStrainExponent(); }
  bool contact_match(const std::string& kind, const std::string& name) override {
    return model_.contact_match(kind, name);
  }
  std::string read_settings(int count, char** arguments, IContactHistorySetup* setup) override {
    Settings settings(lmp);
    model_.registerSettings(settings);
    const bool success = settings.parseArguments(count, arguments);
    model_.postSettings(setup);
    return success ? std::string() : settings.error_message;
  }
  void connect(PropertyRegistry& registry) override { model_.connectToProperties(registry); }
  void begin_pass(SurfacesIntersectData& data) override {
    ForceData force_i, force_j;
    model_.beginPass(data, force_i, force_j);
  }
  void end_pass(SurfacesIntersectData& data) override {
    ForceData force_i, force_j;
    model_.endPass(data, force_i, force_j);
  }
  __attribute__((flatten)) void apply(SurfacesIntersectData& contact, ForceData& force_i,
                                      ForceData& force_j) override {
    model_.surfacesIntersect(contact, force_i, force_j);
    model_.endSurfacesIntersect(contact, nullptr, force_i, force_j);
  }
  void close(SurfacesIntersectData& contact) override {
    ForceData force_i, force_j;
    model_.surfacesClose(contact, force_i, force_j);
  }

 private:
  Model model_;
};

} // namespace ContactModels
} // namespace LIGGGHTS
