// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "batched_law.h"

#include "contact_models.h"
#include "host_contact.h"
#include "model_settings.h"

#include <algorithm>
#include <iterator>

namespace LIGGGHTS {
namespace ContactModels {

using ellipsoid::BatchedLaw;
using ellipsoid::LawKind;
using ellipsoid_host::ModelSettings;

namespace {

struct Kind {
  LawKind kind;
  const char* word;    ///< of contact_match()
  const char* keyword; ///< of the command
  bool may_be_off;     ///< then no law is needed
};
constexpr Kind kinds[] = {{LawKind::normal, "normal", "model", false},
                          {LawKind::cohesion, "cohesion", "cohesion", true},
                          {LawKind::tangential, "tangential", "tangential", false},
                          {LawKind::rolling, "rolling_friction", "rolling_friction", true}};

/// The name of a model's law under its settings, some of which make another law of it.
std::string variant(const std::string& style, const ModelSettings& settings) {
  if (style == "history/viscous" && settings.value("direction", "displacement") == "velocity")
    return style + " velocity";
  if (style == "hooke/stiffness" && settings.is_on("absolute_damping"))
    return style + " absolute";
  return style;
}

const BatchedLaw* chosen_law(const Kind& kind, const ModelMatch& matches,
                             const ModelSettings& settings) {
  const auto is_variant = [](const BatchedLaw& law) { // no name of the host's, which takes it for 0
    return law.style.find(' ') != std::string::npos;
  };
  for (const BatchedLaw& law : ellipsoid::batched_laws())
    if (law.kind == kind.kind && !is_variant(law) && matches(kind.word, law.style))
      return ellipsoid::find_batched_law(kind.kind, variant(law.style, settings));
  return nullptr;
}

/// A setting that is on and that no batched law knows, or an empty string.
std::string unknown_setting(const ModelSettings& settings) {
  const char* const known[] = {"limitForce",       "tangential_damping", "ktToKnUser",
                               "absolute_damping", "tangential_reduce",  "torsionTorque"};
  for (const std::string& keyword : settings.switched_on())
    if (std::find(std::begin(known), std::end(known), keyword) == std::end(known))
      return keyword;
  return {};
}

} // namespace

LawChoice choose_laws(const ModelMatch& matches, const ModelSettings& settings) {
  LawChoice choice;
  for (const Kind& kind : kinds) {
    choice.laws[kind.kind] = chosen_law(kind, matches, settings);
    if (!choice.laws[kind.kind] && !(kind.may_be_off && matches(kind.word, "off")))
      choice.obstacle = std::string("this '") + kind.keyword + "' does not run in batches";
  }
  const std::string setting = unknown_setting(settings);
  if (!setting.empty())
    choice.obstacle = "'" + setting + " on' does not run in batches";
  choice.settings.no_attraction = settings.is_on("limitForce");
  choice.settings.tangential_damping = settings.is_on("tangential_damping", true);
  constexpr double two_sevenths = 0.285714286; // as the host's model hooke has it
  choice.settings.tangential_stiffness_factor = settings.is_on("ktToKnUser") ? two_sevenths : 1.0;
  choice.settings.cohesion_lessens_friction = settings.is_on("tangential_reduce");
  choice.settings.resists_torsion = settings.is_on("torsionTorque");
  return choice;
}

void LawTables::connect(PropertyRegistry& registry, const ellipsoid::ContactLaws& laws) {
  const char* caller = "pair_style gran/ellipsoid";
  source_count_ = 0;
  for (const BatchedLaw* law : laws.of_kind) {
    if (!law)
      continue;
    int parameter = ellipsoid::LawParameters::first(law->kind);
    for (const std::string& name : law->parameters) {
      Source& source = sources_[source_count_++];
      source = {parameter++, nullptr, 0.0};
      if (name == "charVel") // the host keeps it once for all types
        registry.connect(name, source.number, caller);
      else
        registry.connect(name, source.table, caller);
    }
  }
  row_ = static_cast<std::size_t>(registry.max_type()) + 1;
  of_types_.assign(row_ * row_, {});
}

void LawTables::begin_step() {
  are_uniform_ = true;
  for (std::size_t i = 1; i < row_; ++i)
    for (std::size_t j = 1; j < row_; ++j)
      for (std::size_t k = 0; k < source_count_; ++k) {
        const Source& source = sources_[k];
        const double value = source.table ? source.table[i][j] : source.number;
        of_types_[row_ * i + j].values[source.parameter] = value;
        are_uniform_ = are_uniform_ && value == of_types_[row_ + 1].values[source.parameter];
      }
}

void BatchedModels::choose(const ModelMatch& matches, const ModelSettings& settings,
                           const std::function<int(const std::string&)>& offset_of) {
  choice_ = choose_laws(matches, settings);
  if (!run_in_batches())
    return;
  const auto memory = [this, &offset_of](LawKind kind) {
    const BatchedLaw* law = choice_.laws[kind];
    return law && !law->memory.empty() ? offset_of(law->memory) : -1;
  };
  spring_offset_ = memory(LawKind::tangential);
  rolling_offset_ = memory(LawKind::rolling);
  flags_ = CONTACT_NORMAL_MODEL | (choice_.laws[LawKind::cohesion] ? CONTACT_COHESION_MODEL : 0) |
           CONTACT_TANGENTIAL_MODEL | (rolling_offset_ >= 0 ? CONTACT_ROLLING_MODEL : 0);
}

void BatchedModels::connect(PropertyRegistry& registry, bool has_si_forces) {
  if (!has_si_forces)
    choice_.obstacle = "these 'units' do not run in batches";
  if (run_in_batches())
    tables_.connect(registry, choice_.laws);
}

void BatchedModels::begin_step(ellipsoid::ContactLawBatch& batch) {
  tables_.begin_step();
  if (tables_.are_uniform())
    batch.set_parameters_of_all(tables_.parameters(1, 1));
}

void BatchedModels::solve(ellipsoid::ContactLawBatch& batch, double time_step, bool is_time_step,
                          bool with_wall) {
  choice_.settings.time_step = time_step;
  choice_.settings.is_time_step = is_time_step;
  choice_.settings.with_wall = with_wall;
  batch.solve(choice_.laws, choice_.settings);
}

} // namespace ContactModels
} // namespace LIGGGHTS
