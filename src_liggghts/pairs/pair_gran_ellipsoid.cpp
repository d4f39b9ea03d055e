// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pair_gran_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid_host.h"
#include "ellipsoid_models.h"
#include "error.h"
#include "force.h"
#include "host_models.h"
#include "model_settings.h"
#include "multisphere_contacts.h"
#include "neighbor.h"
#include "pair_forces.h"
#include "particle_check.h"
#include "smooth_contacts.h"
#include "update.h"

#include <map>
#include <string>
#include <utility>

using namespace LAMMPS_NS;
using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

namespace {

using Creator = HostModels* (*)(LAMMPS*, IContactHistorySetup*, int64_t);

template <typename Style>
HostModels* make_models(LAMMPS* lmp, IContactHistorySetup* setup, int64_t hash) {
  return new HostModelsOf<ContactModel<Style>>(lmp, setup, hash);
}

/// Only combinations with a surface of ellipsoids are needed.
template <int Normal, int Tangential, int Cohesion, int Rolling, int Surface>
void add_combination(std::map<int64_t, Creator>& creators) {
  if constexpr (Surface == SURFACE_SMOOTH || Surface == SURFACE_MULTISPHERE) {
    using Style = GranStyle<Normal, Tangential, Cohesion, Rolling, Surface>;
    creators[int64_t{Style::HASHCODE}] = &make_models<Style>;
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

/// Null where the surface is not one of ellipsoids.
SurfaceContacts* make_contacts(LAMMPS* lmp, PairGranEllipsoid& pair, int64_t variant) {
  switch ((variant >> 24) & 63) { // as the host packs its models
  case SURFACE_SMOOTH:
    return new SmoothContacts(lmp, pair);
  case SURFACE_MULTISPHERE:
    return new MultisphereContacts(lmp, pair);
  default:
    return nullptr;
  }
}

} // namespace

PairGranEllipsoid::PairGranEllipsoid(LAMMPS* lmp) : HostPairStyle(lmp) {}

PairGranEllipsoid::~PairGranEllipsoid() = default;

/// The values that the search remembers come first in the history, those of the models follow.
void PairGranEllipsoid::create(int64_t variant) {
  contacts_.reset(make_contacts(lmp, *this, variant));
  if (!contacts_)
    error->all(FLERR, "pair_style gran/ellipsoid needs 'surface smooth' or 'surface multisphere' "
                      "after the other models; add it");
  const auto compiled = compiled_combinations().find(variant);
  // any other combination runs by virtual dispatch
  const Creator create_models =
      compiled != compiled_combinations().end() ? compiled->second : &make_models<GranStyle<>>;
  models_.reset(create_models(lmp, this, variant));
  forces_ = std::make_unique<PairForces>(lmp, *this, *models_);
  const std::string complaint = unsuitable_model(*models_);
  if (!complaint.empty())
    error->all(FLERR, ("pair_style gran/ellipsoid: " + complaint).c_str());
}

int64_t PairGranEllipsoid::hashcode() { return models_->hashcode(); }

double PairGranEllipsoid::stressStrainExponent() { return models_->stress_strain_exponent(); }

bool PairGranEllipsoid::contact_match(const std::string type, const std::string model) {
  return models_->contact_match(type, model);
}

int PairGranEllipsoid::history_offset(const std::string& name) const {
  for (std::size_t k = 0; k < history_arg.size(); ++k)
    if (history_arg[k].name == name)
      return static_cast<int>(k);
  error->all(FLERR, ("pair_style gran/ellipsoid: no contact model has the history value " + name +
                     "; a batched law must name the one of its model")
                        .c_str());
  return -1;
}

void PairGranEllipsoid::repeat_history(int times) {
  const std::size_t slot = history_arg.size();
  for (int k = 1; k < times; ++k)
    for (std::size_t value = 0; value < slot; ++value)
      add_history_value(history_arg[value].name + "_" + std::to_string(k),
                        history_arg[value].newtonflag);
}

void PairGranEllipsoid::settings(int narg, char** arg) {
  if (models_)
    error->all(FLERR, "pair_style gran/ellipsoid is given twice; give it once per run, or 'clear' "
                      "before the second");
  const int64_t variant = ellipsoid_host::select_models(narg, arg, lmp, force);
  if (variant == -1)
    error->all(FLERR, "pair_style gran/ellipsoid: unknown contact model; allowed are the host's "
                      "and this package's, in the order model, tangential, cohesion, "
                      "rolling_friction, surface; correct the names and their order");
  create(variant);
  const std::string complaint = unsuitable_setting(narg, arg);
  if (!complaint.empty())
    error->all(FLERR, ("pair_style gran/ellipsoid: " + complaint).c_str());
  read_settings(narg, arg);
}

/// Of all that the models and the search can be told.
void PairGranEllipsoid::read_settings(int narg, char** arg) {
  const std::string problem = models_->read_settings(narg, arg, this);
  if (!problem.empty())
    error->all(FLERR, ("pair_style gran/ellipsoid: " + problem +
                       "; give settings of the chosen models, each with its value")
                          .c_str());
  const ModelSettings settings(narg, arg);
  forces_->read_settings(settings);
  contacts_->read_settings(settings);
}

void PairGranEllipsoid::init_granular() {
  models_->connect(force->registry);
  forces_->connect(force->registry);
  tell_of_batches();
}

void PairGranEllipsoid::tell_of_batches() {
  const std::string obstacle = forces_->obstacle();
  const std::string text =
      obstacle.empty() ? "pair_style gran/ellipsoid: forces of contacts are computed in batches"
                       : "pair_style gran/ellipsoid: forces of contacts are computed one by one, "
                         "which takes longer: " +
                             obstacle;
  if (text == told_)
    return;
  told_ = text;
  for (FILE* out : {screen, logfile})
    if (comm->me == 0 && out)
      fprintf(out, "%s\n", text.c_str());
}

void PairGranEllipsoid::init_style() {
  if (!atom->superquadric_flag)
    error->all(FLERR, "pair_style gran/ellipsoid needs particles with shape: use atom_style "
                      "granular/ellipsoid");
  constexpr int neighbor_style_multi = 2; // MULTI of the host's neighbor.cpp
  if (neighbor->style == neighbor_style_multi)
    error->all(FLERR,
               "pair_style gran/ellipsoid: with 'neighbor ... multi' the host makes no lists for "
               "granular pair styles; use 'bin' or 'nsq'");
  check_pages();
  ellipsoid_host::check_particles(lmp, "pair_style gran/ellipsoid");
  PairGran::init_style();
  if (store_multicontact_data_)
    error->all(FLERR, "pair_style gran/ellipsoid does not work with fix multicontact/halfspace; "
                      "remove that fix");
}

/// The host keeps the histories of all partners of a particle in one page, and does not look
/// whether they fit: it crashes when the neighbour lists are rebuilt.
void PairGranEllipsoid::check_pages() {
  const long long needed = static_cast<long long>(neighbor->oneatom) * dnum_pair();
  if (needed <= neighbor->pgsize)
    return;
  error->all(FLERR, ("pair_style gran/ellipsoid: the history of a pair has " +
                     std::to_string(dnum_pair()) +
                     " values (setting 'contacts'), 'neigh_modify page' is " +
                     std::to_string(neighbor->pgsize) + ", needed are " + std::to_string(needed) +
                     ": raise 'neigh_modify page' to that, or lower 'neigh_modify one' to " +
                     std::to_string(neighbor->pgsize / dnum_pair()))
                        .c_str());
}

void PairGranEllipsoid::add_forces(int eflag, int vflag, bool for_list) {
  if (computeflag_)
    begin_records(update->ntimestep);
  if (eflag || vflag)
    ev_setup(eflag, vflag);
  else
    evflag = vflag_fdotr = 0;
  forces_->begin_step(for_list);
  const ContactCounts counts = contacts_->compute(*forces_, computeflag_ && shearupdate_);
  forces_->end_step();
  if (!computeflag_)
    return;
  counts_ = counts;
  warn_of_searches();
}

void PairGranEllipsoid::write_restart_settings(FILE* file) {
  const int64_t hash = models_->hashcode();
  fwrite(&hash, sizeof(hash), 1, file);
}

void PairGranEllipsoid::read_settings_again(FILE* file) {
  int64_t variant = -1;
  if (comm->me == 0 && fread(&variant, sizeof(variant), 1, file) != 1)
    error->one(FLERR, "The restart file ends within pair_style gran/ellipsoid; use a whole file");
  MPI_Bcast(&variant, sizeof(variant), MPI_CHAR, 0, world);
  create(variant);
  read_settings(0, nullptr); // defaults: the file does not keep settings
}

void PairGranEllipsoid::warn_of_searches() {
  if (warned_ || counts_.values[ContactCounts::not_converged] == 0.0)
    return;
  warned_ = true;
  error->warning(FLERR, "pair_style gran/ellipsoid: a contact search did not converge; the best "
                        "geometry found is used. 'compute contacts/ellipsoid' counts these");
}
