// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pair_gran_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "contact_models.h"
#include "ellipsoid_host.h"
#include "ellipsoid_models.h"
#include "error.h"
#include "force.h"
#include "multisphere_contact_loop.h"
#include "neighbor.h"
#include "particle_check.h"
#include "smooth_contact_loop.h"

#include <map>
#include <string>

using namespace LAMMPS_NS;
using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

namespace {

using Creator = PairStyles::IGranularPairStyle* (*)(LAMMPS*, PairGranEllipsoid*, int64_t);

template <template <typename> class Loop, typename Style>
PairStyles::IGranularPairStyle* make_loop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash) {
  return new Loop<ContactModel<Style>>(lmp, pair, hash);
}

/// Only combinations with a surface of ellipsoids have a loop of ellipsoids.
template <int Normal, int Tangential, int Cohesion, int Rolling, int Surface> struct Registration {
  static void add(std::map<int64_t, Creator>&) {}
};

template <int Normal, int Tangential, int Cohesion, int Rolling>
struct Registration<Normal, Tangential, Cohesion, Rolling, SURFACE_SMOOTH> {
  static void add(std::map<int64_t, Creator>& creators) {
    using Style = GranStyle<Normal, Tangential, Cohesion, Rolling, SURFACE_SMOOTH>;
    creators[int64_t{Style::HASHCODE}] = &make_loop<SmoothContactLoop, Style>;
  }
};

template <int Normal, int Tangential, int Cohesion, int Rolling>
struct Registration<Normal, Tangential, Cohesion, Rolling, SURFACE_MULTISPHERE> {
  static void add(std::map<int64_t, Creator>& creators) {
    using Style = GranStyle<Normal, Tangential, Cohesion, Rolling, SURFACE_MULTISPHERE>;
    creators[int64_t{Style::HASHCODE}] = &make_loop<MultisphereContactLoop, Style>;
  }
};

/// Any other combination runs by virtual dispatch.
Creator virtual_dispatch(int64_t variant) {
  const int surface = static_cast<int>((variant >> 24) & 63); // as the host packs its models
  if (surface == SURFACE_SMOOTH)
    return &make_loop<SmoothContactLoop, GranStyle<>>;
  if (surface == SURFACE_MULTISPHERE)
    return &make_loop<MultisphereContactLoop, GranStyle<>>;
  return nullptr;
}

/// The combinations that the whitelist has compiled.
const std::map<int64_t, Creator>& compiled_combinations() {
  static const std::map<int64_t, Creator> table = [] {
    std::map<int64_t, Creator> creators;
#define GRAN_MODEL(NORMAL, TANGENTIAL, COHESION, ROLLING, SURFACE)                                 \
  Registration<NORMAL, TANGENTIAL, COHESION, ROLLING, SURFACE>::add(creators);
#include "style_contact_model.h"
#undef GRAN_MODEL
    return creators;
  }();
  return table;
}

} // namespace

PairGranEllipsoid::PairGranEllipsoid(LAMMPS* lmp) : PairGran(lmp) {}

PairGranEllipsoid::~PairGranEllipsoid() { delete impl_; }

void PairGranEllipsoid::create(int64_t variant) {
  delete impl_;
  const auto found = compiled_combinations().find(variant);
  const Creator creator =
      found != compiled_combinations().end() ? found->second : virtual_dispatch(variant);
  if (!creator)
    error->all(FLERR, "pair_style gran/ellipsoid needs 'surface smooth' or 'surface multisphere' "
                      "after the other models; add it");
  impl_ = creator(lmp, this, variant);
  const std::string complaint = unsuitable_model(*impl_);
  if (!complaint.empty())
    error->all(FLERR, ("pair_style gran/ellipsoid: " + complaint).c_str());
}

void PairGranEllipsoid::repeat_history(int times) {
  const std::size_t slot = history_arg.size();
  for (int k = 1; k < times; ++k)
    for (std::size_t value = 0; value < slot; ++value)
      add_history_value(history_arg[value].name + "_" + std::to_string(k),
                        history_arg[value].newtonflag);
}

void PairGranEllipsoid::settings(int narg, char** arg) {
  if (impl_)
    error->all(FLERR, "pair_style gran/ellipsoid is given twice; give it once per run, or 'clear' "
                      "before the second");
  const int64_t variant = ContactModels::Factory::select(narg, arg, force->custom_contact_models);
  if (variant == -1)
    error->all(FLERR, "pair_style gran/ellipsoid: unknown contact model; allowed are the host's "
                      "and this package's, in the order model, tangential, cohesion, "
                      "rolling_friction, surface; correct the names and their order");
  create(variant);
  const std::string complaint = unsuitable_setting(narg, arg);
  if (!complaint.empty())
    error->all(FLERR, ("pair_style gran/ellipsoid: " + complaint).c_str());
  impl_->settings(narg, arg, this);
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

void PairGranEllipsoid::read_restart_settings(FILE* file, const int, const int) {
  int64_t variant = -1;
  if (comm->me == 0 && fread(&variant, sizeof(variant), 1, file) != 1)
    error->one(FLERR, "The restart file ends within pair_style gran/ellipsoid; use a whole file");
  MPI_Bcast(&variant, sizeof(variant), MPI_CHAR, 0, world);
  create(variant);
}

void PairGranEllipsoid::publish(const ContactCounts& counts) {
  counts_ = counts;
  if (counts.values[ContactCounts::not_converged] > 0.0 && !warned_) {
    warned_ = true;
    error->warning(FLERR, "pair_style gran/ellipsoid: a contact search did not converge; the best "
                          "geometry found is used. 'compute contacts/ellipsoid' counts these");
  }
}
