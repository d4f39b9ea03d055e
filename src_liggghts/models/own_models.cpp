// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "host_models.h"

#ifdef ELLIPSOID_HOST_PFM

#include "own_models.h"

#include "ellipsoid_host.h"
#include "error.h"
#include "lammps.h"
#include "settings.h"
#include "slip_direction_setting.h"
#include "surface_settings.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <vector>

namespace ellipsoid_host {

using namespace LAMMPS_NS;
using namespace LIGGGHTS::ContactModels;
using ellipsoid::BatchedLaw;
using ellipsoid::LawKind;

namespace {

struct Kind {
  const char* keyword; ///< of the command
  const char* word;    ///< of contact_match()
  bool may_be_missing; ///< which means "off"
};
constexpr Kind kinds_of_models[] = {{"model", "normal", false},
                                    {"tangential", "tangential", true},
                                    {"cohesion", "cohesion", true},
                                    {"rolling_friction", "rolling_friction", true},
                                    {"surface", "surface", false}};

/// The names of a kind, those that may be missing first; a model's place in this list is its
/// number.
std::vector<std::string> names_of(std::size_t kind) {
  if (kind == std::size(kinds_of_models) - 1)
    return {"smooth", "multisphere"};
  constexpr LawKind laws[] = {LawKind::normal, LawKind::tangential, LawKind::cohesion,
                              LawKind::rolling};
  std::vector<std::string> names;
  if (kinds_of_models[kind].may_be_missing)
    names.emplace_back("off");
  for (const BatchedLaw& law : ellipsoid::batched_laws()) {
    const bool is_variant = law.style.find(' ') != std::string::npos;
    if (law.kind == laws[kind] && !is_variant && law.style != "off")
      names.push_back(law.style);
  }
  return names;
}

constexpr int bits_per_model = 6;

/// The name of a kind in a number of select().
std::string name_in(std::int64_t number, std::size_t kind) {
  const std::vector<std::string> names = names_of(kind);
  const auto place = static_cast<std::size_t>(number >> (bits_per_model * kind)) &
                     ((std::size_t{1} << bits_per_model) - 1);
  return place < names.size() ? names[place] : std::string();
}

/// How the host makes the table of a law's parameter from the script's properties.
struct TableMaker {
  const char* parameter;
  MatrixPropertyCreator create;
};
constexpr TableMaker table_makers[] = {
    {"Yeff", &MODEL_PARAMS::createYeff},
    {"Geff", &MODEL_PARAMS::createGeff},
    {"betaeff", &MODEL_PARAMS::createBetaEff},
    {"coeffRestLog", &MODEL_PARAMS::createCoeffRestLog},
    {"k_n", &MODEL_PARAMS::createKn},
    {"k_t", &MODEL_PARAMS::createKt},
    {"gamma_n", &MODEL_PARAMS::createGamman},
    {"gamma_t", &MODEL_PARAMS::createGammat},
    {"gamman", &MODEL_PARAMS::createGamman},
    {"gammat", &MODEL_PARAMS::createGammat},
    {"gamman_abs", &MODEL_PARAMS::createGammanAbs},
    {"gammat_abs", &MODEL_PARAMS::createGammatAbs},
    {"cohEnergyDens", &MODEL_PARAMS::createCohesionEnergyDensity},
    {"coeffFrict", &MODEL_PARAMS::createCoeffFrict},
    {"coeffRollFrict", &MODEL_PARAMS::createCoeffRollFrict},
    {"viscousDampingNormal", &viscous_damping_normal},
    {"viscousDampingTangential", &viscous_damping_tangential},
    {"springStiffnessNormal", &spring_stiffness_normal},
    {"springStiffnessTangential", &spring_stiffness_tangential},
};

/// Settings of one model that are on or off.
struct Switches {
  const char *word, *name;
  std::vector<const char*> keywords;
};
const std::vector<Switches>& switches() {
  static const std::vector<Switches> table{
      {"normal", "hertz/viscous", {"limitForce"}},
      {"normal", "hooke/viscous", {"limitForce"}},
      {"normal", "hertz", {"limitForce", "tangential_damping"}},
      {"normal", "hertz/stiffness", {"limitForce", "tangential_damping"}},
      {"normal", "hooke", {"limitForce", "tangential_damping", "ktToKnUser"}},
      {"normal", "hooke/stiffness", {"limitForce", "tangential_damping", "absolute_damping"}},
      {"cohesion", "sjkr", {"tangential_reduce"}},
      {"cohesion", "sjkr2", {"tangential_reduce"}},
      {"rolling_friction", "cdt", {"torsionTorque"}},
      {"rolling_friction", "epsd2", {"torsionTorque"}},
  };
  return table;
}

} // namespace

std::int64_t OwnModels::select(int& narg, char**& arg) {
  std::int64_t number = 0;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (narg < 2 || std::strcmp(arg[0], kinds_of_models[kind].keyword) != 0) {
      if (!kinds_of_models[kind].may_be_missing)
        return -1;
      continue; // "off" is the first of its kind
    }
    const std::vector<std::string> names = names_of(kind);
    const auto found = std::find(names.begin(), names.end(), arg[1]);
    if (found == names.end())
      return -1;
    number |= static_cast<std::int64_t>(found - names.begin()) << (bits_per_model * kind);
    narg -= 2;
    arg += 2;
  }
  return number;
}

std::string OwnModels::surface_in(std::int64_t number) { return name_in(number, kinds - 1); }

OwnModels::OwnModels(LAMMPS* lmp, LIGGGHTS::IContactHistorySetup* setup, std::int64_t number)
    : lmp_(lmp), number_(number) {
  for (std::size_t kind = 0; kind < kinds; ++kind)
    names_[kind] = name_in(number, kind);
  choice_ = laws(ModelSettings());
  for (const LawKind kind : {LawKind::tangential, LawKind::rolling}) {
    const BatchedLaw* law = choice_.laws[kind];
    if (!law || law->memory.empty())
      continue;
    memories_.push_back(setup->add_history_value(law->memory, "1"));
    for (const char* further : {"_y", "_z"})
      setup->add_history_value(law->memory + further, "1");
  }
}

LawChoice OwnModels::laws(const ModelSettings& settings) {
  return choose_laws([this](const std::string& kind,
                            const std::string& name) { return contact_match(kind, name); },
                     settings);
}

bool OwnModels::contact_match(const std::string& kind, const std::string& name) {
  for (std::size_t k = 0; k < kinds; ++k)
    if (kind == kinds_of_models[k].word)
      return name == names_[k];
  return false;
}

double OwnModels::stress_strain_exponent() { return names_[0].rfind("hertz", 0) == 0 ? 1.5 : 1.0; }

std::string OwnModels::read_settings(int count, char** arguments, LIGGGHTS::IContactHistorySetup*) {
  Settings settings(lmp_);
  // where the host puts what it has checked; who needs the values reads them from the command
  bool on = false;
  int contacts = 0;
  auto rule = ellipsoid::MulticontactRule::sum;
  auto direction = ellipsoid::SlipDirection::displacement;
  for (const Switches& row : switches())
    if (contact_match(row.word, row.name))
      for (const char* keyword : row.keywords)
        settings.registerOnOff(keyword, on);
  if (contact_match("tangential", "history/viscous"))
    settings.registerSetting<SlipDirectionSetting>("direction", direction, direction);
  settings.registerSetting<ContactsSetting>("contacts", contacts, ContactsSetting::standard);
  if (contact_match("surface", "multisphere"))
    settings.registerSetting<MulticontactSetting>("multicontact", rule, rule);
  if (!settings.parseArguments(count, arguments))
    return settings.error_message;
  choice_ = laws(ModelSettings(count, arguments));
  return {};
}

void OwnModels::connect(PropertyRegistry& registry) {
  for (const BatchedLaw* law : choice_.laws.of_kind) {
    if (!law)
      continue;
    for (const std::string& parameter : law->parameters) {
      if (parameter == "charVel")
        registry.registerProperty(parameter, &MODEL_PARAMS::createCharacteristicVelocity);
      for (const TableMaker& maker : table_makers)
        if (parameter == maker.parameter)
          registry.registerProperty(parameter, maker.create);
    }
  }
}

void OwnModels::apply(SurfacesIntersectData&, ForceData&, ForceData&) {
  lmp_->error->one(FLERR, "internal error: a contact that does not run in batches");
}

void OwnModels::close(SurfacesIntersectData& contact) {
  *contact.contact_flags &= ~(CONTACT_NORMAL_MODEL | CONTACT_COHESION_MODEL |
                              CONTACT_TANGENTIAL_MODEL | CONTACT_ROLLING_MODEL);
  for (const int first : memories_)
    std::fill_n(&contact.contact_history[first], 3, 0.0);
}

} // namespace ellipsoid_host

namespace LIGGGHTS {
namespace ContactModels {

ContactSurface surface_of(std::int64_t variant) {
  const std::string name = ellipsoid_host::OwnModels::surface_in(variant);
  return name == "smooth"        ? ContactSurface::smooth
         : name == "multisphere" ? ContactSurface::multisphere
                                 : ContactSurface::other;
}

std::unique_ptr<HostModels> make_models(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* setup,
                                        std::int64_t variant) {
  return std::make_unique<ellipsoid_host::OwnModels>(lmp, setup, variant);
}

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
