// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which of the kernel's batched laws (law/contact_laws.h) compute what the chosen contact models
// say, and the material tables that they take: those of the host's properties.
#pragma once

#include "law/contact_laws.h"
#include "property_registry.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ellipsoid_host {
class ModelSettings;
}

namespace LIGGGHTS {
namespace ContactModels {

class HostModels;

struct LawChoice {
  ellipsoid::ContactLaws laws;
  ellipsoid::LawSettings settings;
  std::string obstacle; ///< why the models do not run in batches; empty: they do
};

LawChoice choose_laws(HostModels& models, const ellipsoid_host::ModelSettings& settings);

/// Material parameters per pair of types.
class LawTables {
 public:
  /// After the models have registered their properties.
  void connect(PropertyRegistry& registry, const ellipsoid::ContactLaws& laws);
  /// The host's tables may have changed.
  void begin_step();
  /// Whether all pairs of types have the same parameters.
  bool are_uniform() const { return are_uniform_; }

  const ellipsoid::LawParameters& parameters(int itype, int jtype) const {
    return of_types_[row_ * static_cast<std::size_t>(itype) + static_cast<std::size_t>(jtype)];
  }

 private:
  /// Where one parameter comes from: a table of the host, or one number. The host keeps their
  /// addresses.
  struct Source {
    int parameter = 0;
    double** table = nullptr;
    double number = 0.0;
  };
  std::array<Source, ellipsoid::LawParameters::count> sources_;
  std::size_t source_count_ = 0;
  std::size_t row_ = 0;
  std::vector<ellipsoid::LawParameters> of_types_;
  bool are_uniform_ = false;
};

} // namespace ContactModels
} // namespace LIGGGHTS
