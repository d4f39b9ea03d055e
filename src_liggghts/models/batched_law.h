// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The material tables that the kernel's batch of the contact law takes: those of the host's
// properties.
#ifndef BATCHED_LAW_H
#define BATCHED_LAW_H

#include "law/law_batch.h"
#include "property_registry.h"

#include <cstddef>
#include <vector>

namespace LIGGGHTS {
namespace ContactModels {

/// Tables per pair of types.
class PaperLawTables {
 public:
  /// After the models have registered their properties.
  void connect(PropertyRegistry& registry) {
    const char* caller = "pair_style gran/ellipsoid";
    registry.connect("Yeff", effective_modulus_, caller);
    registry.connect("Geff", effective_shear_modulus_, caller);
    registry.connect("viscousDampingNormal", normal_damping_, caller);
    registry.connect("viscousDampingTangential", tangential_damping_, caller);
    registry.connect("coeffFrict", friction_, caller);
    row_ = static_cast<std::size_t>(registry.max_type()) + 1;
    of_types_.resize(row_ * row_);
  }

  /// The host's tables may have changed.
  void begin_step() {
    for (std::size_t i = 1; i < row_; ++i)
      for (std::size_t j = 1; j < row_; ++j)
        of_types_[row_ * i + j] = {effective_modulus_[i][j], effective_shear_modulus_[i][j],
                                   normal_damping_[i][j], tangential_damping_[i][j],
                                   friction_[i][j]};
  }

  const ellipsoid::LawParameters& parameters(int itype, int jtype) const {
    return of_types_[row_ * static_cast<std::size_t>(itype) + static_cast<std::size_t>(jtype)];
  }

 private:
  double** effective_modulus_ = nullptr;
  double** effective_shear_modulus_ = nullptr;
  double** normal_damping_ = nullptr;
  double** tangential_damping_ = nullptr;
  double** friction_ = nullptr;
  std::size_t row_ = 0;
  std::vector<ellipsoid::LawParameters> of_types_;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
