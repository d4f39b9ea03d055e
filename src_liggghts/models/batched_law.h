// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which of the kernel's batched laws (law/contact_laws.h) compute what the chosen contact models
// say, and the material tables that they take: those of the host's properties.
#pragma once

#include "ellipsoid_host.h"
#include "law/law_batch.h"
#include "property_registry.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ellipsoid_host {
class ModelSettings;
}

namespace LIGGGHTS {
namespace ContactModels {

/// Whether the chosen model of a kind ("normal", "tangential" ...) has this name.
using ModelMatch = std::function<bool(const std::string& kind, const std::string& name)>;

struct LawChoice {
  ellipsoid::ContactLaws laws;
  ellipsoid::LawSettings settings;
  std::string obstacle; ///< why the models do not run in batches; empty: they do
};

LawChoice choose_laws(const ModelMatch& matches, const ellipsoid_host::ModelSettings& settings);

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

/// The chosen contact models as laws of a batch: what it needs to know of a contact, and where
/// the contact's history keeps what the models remember.
class BatchedModels {
 public:
  /// @param[in] offset_of where a contact's history keeps the first value of a model, by its name;
  ///            asked in the order of the models
  void choose(const ModelMatch& matches, const ellipsoid_host::ModelSettings& settings,
              const std::function<int(const std::string&)>& offset_of);
  /// Why contacts do not run in batches; empty: they do.
  const std::string& obstacle() const { return choice_.obstacle; }
  bool run_in_batches() const { return choice_.obstacle.empty(); }
  /// After the models have registered their properties.
  /// @param[in] has_si_forces force is mass times acceleration in the units of the run
  void connect(PropertyRegistry& registry, bool has_si_forces);

  void begin_step(ellipsoid::ContactLawBatch& batch);
  /// Flags that there is a contact, one per kind of model.
  int flags() const { return flags_; }
  /// Material and memory of contact k.
  void set(ellipsoid::ContactLawBatch& batch, int k, int itype, int jtype,
           const double* history) const {
    if (!tables_.are_uniform())
      batch.set_parameters(k, tables_.parameters(itype, jtype));
    if (spring_offset_ >= 0)
      batch.set_spring(k, ellipsoid_host::vector(&history[spring_offset_]));
    if (rolling_offset_ >= 0)
      batch.set_rolling_torque(k, ellipsoid_host::vector(&history[rolling_offset_]));
  }
  /// @param[in] is_time_step springs grow, otherwise forces are those of the moment
  /// @param[in] with_wall    contacts of one body each with a wall
  void solve(ellipsoid::ContactLawBatch& batch, double time_step, bool is_time_step,
             bool with_wall);
  void remember(const ellipsoid::ContactLawBatch& batch, int k, double* history) const {
    if (spring_offset_ >= 0)
      ellipsoid_host::store(batch.spring(k), &history[spring_offset_]);
    if (rolling_offset_ >= 0)
      ellipsoid_host::store(batch.rolling_torque(k), &history[rolling_offset_]);
  }

 private:
  LawChoice choice_;
  LawTables tables_;
  int flags_ = 0;
  int spring_offset_ = -1, rolling_offset_ = -1; // in the history of a contact; -1: no memory
};

} // namespace ContactModels
} // namespace LIGGGHTS
