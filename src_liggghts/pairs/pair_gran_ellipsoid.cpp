// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pair_gran_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid_host.h"
#include "ellipsoid_models.h"
#include "error.h"
#include "fix_contact_history.h"
#include "fix_contacthistory_ellipsoid.h"
#include "force.h"
#include "host_models.h"
#include "model_names.h"
#include "model_settings.h"
#include "modify.h"
#include "multisphere_contacts.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "pair_forces.h"
#include "pair_histories.h"
#include "particle_check.h"
#include "smooth_contacts.h"
#include "update.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;
using namespace LIGGGHTS::ContactModels;
using namespace ellipsoid_host;

namespace {

/// Null where the surface is not one of ellipsoids.
SurfaceContacts* make_contacts(LAMMPS* lmp, PairGranEllipsoid& pair, int64_t variant) {
  switch (surface_of(variant)) {
  case ContactSurface::smooth:
    return new SmoothContacts(lmp, pair);
  case ContactSurface::multisphere:
    return new MultisphereContacts(lmp, pair);
  default:
    return nullptr;
  }
}

/// Begins the arguments in restart files, after the host's number of the models.
constexpr std::int64_t arguments_mark = 0x53474e4954544553;

} // namespace

PairGranEllipsoid::PairGranEllipsoid(LAMMPS* lmp) : HostPairStyle(lmp) {}

PairGranEllipsoid::~PairGranEllipsoid() = default;

/// The values that the search remembers come first in the history, those of the models follow.
void PairGranEllipsoid::create(int64_t variant) {
  contacts_.reset(make_contacts(lmp, *this, variant));
  if (!contacts_)
    error->all(FLERR, "pair_style gran/ellipsoid needs 'surface smooth' or 'surface multisphere' "
                      "after the other models; add it");
  models_ = make_models(lmp, this, variant);
  forces_ = std::make_unique<PairForces>(lmp, *this, *models_);
  refuse(unsuitable_model(*models_)); // of a restart file
}

void PairGranEllipsoid::refuse(const std::string& complaint) {
  if (!complaint.empty())
    error->all(FLERR, ("pair_style gran/ellipsoid: " + complaint).c_str());
}

int64_t PairGranEllipsoid::hashcode() { return models_->hashcode(); }

void* PairGranEllipsoid::extract(const char* what, int& dimension) {
  dimension = 0;
  if (std::strcmp(what, "contacts") == 0)
    return &counts_.values[ContactCounts::contacts];
  return PairGran::extract(what, dimension);
}

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
  for (int k = 0; k < narg; ++k)
    arguments_ += (k ? " " : "") + std::string(arg[k]);
  const NamedModels names(narg, arg);
  const int64_t variant = select_models(narg, arg, lmp, force);
  if (variant == -1)
    error->all(FLERR,
               (std::string("pair_style gran/ellipsoid: unknown contact model; allowed are ") +
                known_models +
                ", in the order model, tangential, cohesion, "
                "rolling_friction, surface; correct the names and their order")
                   .c_str());
  refuse(unsuitable_model(names));
  create(variant);
  refuse(unsuitable_setting(narg, arg));
  read_settings(narg, arg);
}

/// The settings of the models and of the search.
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
  batch_notice_.tell(*lmp, "pair_style gran/ellipsoid", forces_->obstacle());
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
  if (arguments_.empty())
    error->all(FLERR, "pair_style gran/ellipsoid: the restart file is of an earlier version and "
                      "does not have the settings of this command; repeat it after read_restart");
  save_contact_history();
  check_pages();
  check_particles(lmp, "pair_style gran/ellipsoid");
  PairGran::init_style();
  shorten_lists();
  if (store_multicontact_data_)
    error->all(FLERR, "pair_style gran/ellipsoid does not work with fix multicontact/halfspace; "
                      "remove that fix");
  keep_arguments();
  keep_history();
}

/// Only pairs that touch have a history: the host's lists hold one number per pair, its row.
void PairGranEllipsoid::shorten_lists() {
  for (int k = 0; k < neighbor->nrequest; ++k)
    if (neighbor->requests[k]->requestor == this && neighbor->requests[k]->granhistory)
      neighbor->requests[k]->dnum = 1;
}

double* PairGranEllipsoid::history(double* in_list, int entry) const {
  return contacts_->history_rows().at(static_cast<int>(in_list[entry]));
}

void PairGranEllipsoid::keep_histories() { contacts_->histories_are_kept(true); }

namespace ellipsoid_host {

double* pair_history(Pair* pair, double* in_list, int values, int entry) {
  const auto* own = dynamic_cast<const PairGranEllipsoid*>(pair);
  return own ? own->history(in_list, entry) : &in_list[values * entry];
}

void keep_pair_histories(Pair* pair) {
  if (auto* own = dynamic_cast<PairGranEllipsoid*>(pair))
    own->keep_histories();
}

} // namespace ellipsoid_host

/// The host makes new neighbour lists for a run when another command wants one, or when pages
/// differ from the host's default: histories go to the atoms before.
void PairGranEllipsoid::save_contact_history() {
  const int pages[2] = {neighbor->pgsize, neighbor->oneatom};
  if (fix_history) {
    if (pages[0] != pages_[0] || pages[1] != pages_[1])
      error->all(FLERR, ("pair_style gran/ellipsoid: neigh_modify page and one were " +
                         std::to_string(pages_[0]) + " and " + std::to_string(pages_[1]) +
                         " in the last run, are " + std::to_string(pages[0]) + " and " +
                         std::to_string(pages[1]) +
                         " now, which would lose the contact history; keep them as they were, or "
                         "write a restart file and go on from it")
                            .c_str());
    fix_history->setup_pre_exchange();
    history_keeper_->setup_pre_exchange();
  }
  pages_[0] = pages[0];
  pages_[1] = pages[1];
}

/// The fix stops if the contact history comes from a run with other arguments.
void PairGranEllipsoid::keep_arguments() {
  own_fix("pair_settings_ellipsoid", "pair_settings/ellipsoid");
}

void PairGranEllipsoid::keep_history() {
  history_keeper_ = static_cast<FixContactHistoryEllipsoid*>(
      own_fix("contacthistory_ellipsoid", "contacthistory/ellipsoid"));
}

/// The fix of this ID, which is made when a run is set up for the first time.
Fix* PairGranEllipsoid::own_fix(const char* id, const char* style) {
  const char* words[] = {id, "all", style};
  if (modify->find_fix(id) < 0)
    modify->add_fix(3, const_cast<char**>(words));
  return modify->fix[modify->find_fix(id)];
}

/// The host keeps the histories of all partners of a particle in one page, and does not look
/// whether they fit, nor whether it can count what a page of the lists holds: it crashes when the
/// neighbour lists are rebuilt.
void PairGranEllipsoid::check_pages() {
  const int largest_page = std::numeric_limits<int>::max() / std::max(1, dnum_pair());
  if (neighbor->pgsize > largest_page)
    error->all(FLERR,
               ("pair_style gran/ellipsoid: the history of a pair has " +
                std::to_string(dnum_pair()) +
                " values (setting 'contacts'), 'neigh_modify page' is " +
                std::to_string(neighbor->pgsize) + ", the most is " + std::to_string(largest_page) +
                ": lower 'neigh_modify page' to that, or 'contacts'")
                   .c_str());
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
  if (neighbor->ago == 0) {
    if (contacts_->recall_histories())
      history_keeper_->give_back_again();
    history_keeper_->give_back();
  }
  forces_->begin_step(for_list);
  const ContactCounts counts = contacts_->compute(*forces_, computeflag_ && shearupdate_);
  forces_->end_step();
  if (!computeflag_)
    return;
  history_keeper_->histories_changed();
  contacts_->histories_are_kept(false);
  counts_ = counts;
  warn_of_searches();
}

void PairGranEllipsoid::ghosts_are_new() { contacts_->ghosts_are_new(); }

NearCandidates* PairGranEllipsoid::candidates_of(int i) {
  return near_candidates_.serve(i, *lmp, *contacts_) ? &near_candidates_ : nullptr;
}

void PairGranEllipsoid::write_restart_settings(FILE* file) {
  const std::int64_t head[] = {hashcode(), arguments_mark,
                               static_cast<std::int64_t>(arguments_.size())};
  fwrite(head, sizeof(head), 1, file);
  fwrite(arguments_.data(), 1, arguments_.size(), file);
}

void PairGranEllipsoid::read_settings_again(FILE* file) {
  std::int64_t head[3] = {-1, 0, 0}; // as written
  const auto read = [this, file](void* to, std::size_t size) {
    if (comm->me == 0 && fread(to, 1, size, file) != size)
      error->one(FLERR, "The restart file ends within pair_style gran/ellipsoid; use a whole file");
    MPI_Bcast(to, static_cast<int>(size), MPI_CHAR, 0, world);
  };
  read(head, sizeof(head[0]));
  read(&head[1], sizeof(head[1]));
  if (head[1] != arguments_mark) { // an earlier version: the number of the models alone
    if (comm->me == 0)
      fseek(file, -static_cast<long>(sizeof(head[1])), SEEK_CUR);
    create(head[0]);
    read_settings(0, nullptr);
    return;
  }
  read(&head[2], sizeof(head[2]));
  std::string text(static_cast<std::size_t>(head[2]), ' ');
  read(text.data(), text.size());
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;)
    words.push_back(word);
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  settings(static_cast<int>(arguments.size()), arguments.data());
}

void PairGranEllipsoid::warn_of_searches() {
  if (warned_ || counts_.values[ContactCounts::not_converged] == 0.0)
    return;
  warned_ = true;
  error->warning(FLERR, "pair_style gran/ellipsoid: a contact search did not converge; the best "
                        "geometry found is used. 'compute contacts/ellipsoid' counts these");
}
