// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The contact models with LIGGGHTS-PFM, whose own have the interface of an older LIGGGHTS: the laws
// of the kernel, which run in batches, and no others.
#pragma once

#include "batched_law.h"
#include "host_models.h"
#include "model_settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ellipsoid_host {

class OwnModels : public LIGGGHTS::ContactModels::HostModels {
 public:
  static constexpr const char* known_names =
      "with LIGGGHTS-PFM those that run in batches: model hertz/viscous, hooke/viscous, hertz, "
      "hertz/stiffness, hooke, hooke/stiffness; tangential history/viscous, history, no_history, "
      "off; cohesion sjkr, sjkr2, off; rolling_friction cdt, epsd2, off; surface smooth, "
      "multisphere";

  /// Takes the names of the models from the arguments.
  /// @return a number for all of them together; -1 if one is unknown
  static std::int64_t select(int& narg, char**& arg);

  /// The name of the surface in such a number.
  static std::string surface_in(std::int64_t number);

  /// What the models remember of a contact is registered with `setup`.
  OwnModels(LAMMPS_NS::LAMMPS* lmp, LIGGGHTS::IContactHistorySetup* setup, std::int64_t number);

  int64_t hashcode() override { return number_; }
  /// Of the force over the overlap.
  double stress_strain_exponent() override;
  bool contact_match(const std::string& kind, const std::string& name) override;
  std::string read_settings(int count, char** arguments,
                            LIGGGHTS::IContactHistorySetup* setup) override;
  void connect(PropertyRegistry& registry) override;
  void begin_pass(LIGGGHTS::ContactModels::SurfacesIntersectData&) override {}
  void end_pass(LIGGGHTS::ContactModels::SurfacesIntersectData&) override {}
  /// Is not called: whatever does not run in batches is refused before.
  void apply(LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
             LIGGGHTS::ContactModels::ForceData& force_i,
             LIGGGHTS::ContactModels::ForceData& force_j) override;
  void close(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) override;

 private:
  static constexpr std::size_t kinds = 5;
  LAMMPS_NS::LAMMPS* lmp_;
  std::int64_t number_;
  std::array<std::string, kinds> names_; // normal, tangential, cohesion, rolling friction, surface
  LIGGGHTS::ContactModels::LawChoice choice_;
  std::vector<int> memories_; // places of three values each in the history of a contact

  LIGGGHTS::ContactModels::LawChoice laws(const ModelSettings& settings);
};

} // namespace ellipsoid_host
