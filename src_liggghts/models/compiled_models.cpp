// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The host's contact models: combinations that are compiled, and virtual dispatch for all others.
#include "host_models.h"

#ifndef ELLIPSOID_HOST_PFM

#include "contact_models.h"
#include "settings.h"

#include <map>

namespace LIGGGHTS {
namespace ContactModels {

namespace {

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

using Creator = std::unique_ptr<HostModels> (*)(LAMMPS*, IContactHistorySetup*, int64_t);

template <typename Style>
std::unique_ptr<HostModels> make_models_of(LAMMPS* lmp, IContactHistorySetup* setup, int64_t hash) {
  return std::make_unique<HostModelsOf<ContactModel<Style>>>(lmp, setup, hash);
}

/// Only combinations with a surface of ellipsoids are needed.
template <int Normal, int Tangential, int Cohesion, int Rolling, int Surface>
void add_combination(std::map<int64_t, Creator>& creators) {
  if constexpr (Surface == SURFACE_SMOOTH || Surface == SURFACE_MULTISPHERE) {
    using Style = GranStyle<Normal, Tangential, Cohesion, Rolling, Surface>;
    creators[int64_t{Style::HASHCODE}] = &make_models_of<Style>;
  }
}

/// The combinations that the whitelist has compiled.
const std::map<int64_t, Creator>& compiled_combinations() {
  static const std::map<int64_t, Creator> table = [] {
    std::map<int64_t, Creator> creators;
#define GRAN_MODEL(NORMAL, TANGENTIAL, COHESION, ROLLING, SURFACE)                                 \
  add_combination<NORMAL, TANGENTIAL, COHESION, ROLLING, SURFACE>(creators);
#include "style_contact_model.h"
#undef GRAN_MODEL
    return creators;
  }();
  return table;
}

} // namespace

/// The host packs normal, tangential, cohesion, rolling and surface model into one number, in this
/// order.
ContactSurface surface_of(std::int64_t variant) {
  constexpr int bits_per_model = 6, models_before = 4;
  const int surface =
      static_cast<int>(variant >> (models_before * bits_per_model)) & ((1 << bits_per_model) - 1);
  return surface == SURFACE_SMOOTH        ? ContactSurface::smooth
         : surface == SURFACE_MULTISPHERE ? ContactSurface::multisphere
                                          : ContactSurface::other;
}

std::unique_ptr<HostModels> make_models(LAMMPS* lmp, IContactHistorySetup* setup,
                                        std::int64_t variant) {
  const auto compiled = compiled_combinations().find(variant);
  // any other combination runs by virtual dispatch
  const Creator create =
      compiled != compiled_combinations().end() ? compiled->second : &make_models_of<GranStyle<>>;
  return create(lmp, setup, variant);
}

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
