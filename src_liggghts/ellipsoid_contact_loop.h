// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The pair loop of pair_style gran/ellipsoid, as far as it is the same for all surfaces: walks over
// the neighbour list, calls the contact models, adds up forces and torques. The host's own loop
// (pair_gran_base.h) knows one contact per pair, on the line of centres. What the contacts of a pair
// are is for the derived classes (smooth_contact_loop.h, multisphere_contact_loop.h).
#ifndef ELLIPSOID_CONTACT_LOOP_H_
#define ELLIPSOID_CONTACT_LOOP_H_

#include "atom.h"
#include "comm.h"
#include "contact_models.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_contact_property_atom.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran_ellipsoid.h"
#include "settings.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace LIGGGHTS {

using namespace ContactModels;

/// Travels are sums of many terms, which are rounded: so much of a gap is relied upon.
constexpr double trusted_share_of_gap = 1.0 - 1e-9;

/// Names of history values, and whether they change sign when the pair is seen from j.
using SearchHistory = std::vector<std::pair<std::string, bool>>;

/// @tparam Surface the derived class. It has
///          - prepare(): before the first pair; returns whether the neighbour lists are new;
///          - begin_lists(pairs): after that, if they are;
///          - travelled(i): how far any point of particle i has moved at most since then (length);
///          - treat_pair(i, j, pair, travelled, flag, history), `pair` the place in the lists and
///            `travelled` that of both: returns a length by which the surfaces are apart at least,
///            0 if they touch or nothing is known;
///          - finish(): after the last pair.
/// @tparam Model   the host's ContactModel<...>
template <typename Surface, typename Model>
class EllipsoidContactLoop : protected Pointers, public PairStyles::IGranularPairStyle {
public:
  /// @param[in] search_history what the search remembers of a pair or contact: (name, flips) each;
  ///            these values come first in the history, those of the models follow
  EllipsoidContactLoop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash,
                       const SearchHistory& search_history)
      : Pointers(lmp), pair_(pair), model_((reserve(pair, search_history), lmp), pair, false, hash) {
  }

  int64_t hashcode() override { return model_.hashcode(); }
  int get_history_offset(const std::string name) override {
    return model_.get_history_offset(name);
  }
  double stressStrainExponent() override { return model_.stressStrainExponent(); }
  bool contact_match(const std::string type, const std::string model) override {
    return model_.contact_match(type, model);
  }
  void init_granular() override { model_.connectToProperties(force->registry); }

  void settings(int narg, char** arg, IContactHistorySetup* setup) override {
    Settings settings(lmp);
    model_.registerSettings(settings);
    const bool success = settings.parseArguments(narg, arg);
    model_.postSettings(setup);
    if (!success)
      error->all(FLERR, ("pair_style gran/ellipsoid: " + settings.error_message +
                         "; give settings of the chosen models, each with its value")
                            .c_str());
  }

  void write_restart_settings(FILE* file) override {
    const int64_t hash = model_.hashcode();
    fwrite(&hash, sizeof(hash), 1, file);
  }

  /// The pair style has read the one value that there is: it says which loop to make.
  void read_restart_settings(FILE*, int64_t) override {}

  void compute_force(PairGran*, int eflag, int vflag, int addflag) override {
    begin(eflag, vflag, addflag);
    Surface& surface = static_cast<Surface&>(*this);
    if (surface.prepare())
      surface.begin_lists(wake_all());
    counts_.values[ContactCounts::near_pairs] = near_pairs_;
    const NeighList* list = pair_->list;
    std::size_t pair = 0;
    for (int ii = 0; ii < list->inum; ++ii) {
      const int i = list->ilist[ii];
      const double travelled_i = surface.travelled(i);
      double* history = pair_->listgranhistory->firstdouble[i];
      int* flags = pair_->listgranhistory->firstneigh[i];
      const int* neighbours = list->firstneigh[i];
      const int count = list->numneigh[i];
      for (int jj = 0; jj < count; ++jj, ++pair) {
        const int j = neighbours[jj] & NEIGHMASK;
        const double travelled = travelled_i + surface.travelled(j);
        if (travelled < asleep_until_[pair])
          continue;
        const double gap = surface.treat_pair(i, j, pair, travelled, flags[jj],
                                              &history[history_values_ * jj]);
        asleep_until_[pair] = gap > 0.0 ? travelled + trusted_share_of_gap * gap : 0.0;
      }
    }
    surface.finish();
    end();
  }

protected:
  PairGranEllipsoid* pair_;
  Model model_;
  SurfacesIntersectData contact_;
  ForceData force_i_, force_j_;
  ContactCounts counts_;
  int history_values_ = 0; // per pair
  bool collect_ = false;   // for compute pair/gran/local
  bool reports_ = false;   // somebody wants to know of each contact
  int frozen_group_ = 0;
  const double* rigid_masses_ = nullptr; // of the bodies that particles belong to

  // Surfaces that are apart cannot touch before the two particles have travelled their gap: until
  // then the pair sleeps. One value per pair of the neighbour lists.
  std::vector<double> asleep_until_;
  double near_pairs_ = 0.0;

  static void reserve(PairGranEllipsoid* pair, const SearchHistory& search_history) {
    for (const auto& value : search_history)
      pair->add_history_value(value.first, value.second ? "1" : "0");
  }

  /// x_j - x_i.
  ellipsoid::Vector3 centre_distance(int i, int j) const {
    const double* x_i = atom->x[i];
    const double* x_j = atom->x[j];
    return {x_j[0] - x_i[0], x_j[1] - x_i[1], x_j[2] - x_i[2]};
  }

  /// Gap between the bounding spheres, 0 if they overlap.
  double bounding_gap(int i, int j, const ellipsoid::Vector3& distance) const {
    const double reach = atom->radius[i] + atom->radius[j], squared = dot(distance, distance);
    return squared < reach * reach ? 0.0 : std::sqrt(squared) - reach;
  }

  /// Returns the number of pairs in the neighbour lists.
  std::size_t wake_all() {
    const NeighList* list = pair_->list;
    std::size_t pairs = 0;
    near_pairs_ = 0.0;
    for (int ii = 0; ii < list->inum; ++ii) {
      const int i = list->ilist[ii];
      pairs += static_cast<std::size_t>(list->numneigh[i]);
      for (int jj = 0; jj < list->numneigh[i]; ++jj)
        near_pairs_ += share(list->firstneigh[i][jj] & NEIGHMASK);
    }
    asleep_until_.assign(pairs, 0.0);
    return pairs;
  }

  /// Pairs with a ghost are treated by two ranks.
  double share(int j) const { return j < atom->nlocal ? 1.0 : 0.5; }

  void begin(int eflag, int vflag, int addflag) {
    if (eflag || vflag)
      pair_->ev_setup(eflag, vflag);
    else
      pair_->evflag = pair_->vflag_fdotr = 0;
    history_values_ = pair_->dnum();
    counts_ = ContactCounts();
    collect_ = pair_->cpl() && addflag;
    reports_ = collect_ || pair_->evflag || pair_->store_sum_normal_force() ||
               pair_->storeContactForces() || pair_->storeContactForcesStress();
    frozen_group_ = pair_->freeze_group_bit();
    rigid_masses_ = pair_->fr_pair() ? pair_->mr_pair() : nullptr;
    contact_ = SurfacesIntersectData();
    contact_.is_wall = false;
    contact_.is_non_spherical = true;
    contact_.area_ratio = 1.0;
    contact_.computeflag = pair_->computeflag();
    contact_.shearupdate = pair_->shearupdate();
    model_.beginPass(contact_, force_i_, force_j_);
  }

  void end() {
    model_.endPass(contact_, force_i_, force_j_);
    if (contact_.computeflag)
      pair_->publish(counts_);
    if (collect_)
      pair_->cpl_pair_finalize();
    if (pair_->storeContactForces())
      pair_->fix_contact_forces()->do_forward_comm();
    if (pair_->storeContactForcesStress())
      pair_->fix_contact_forces_stress()->do_forward_comm();
  }

  /// Tells the models that a contact is over: they clear their part of its history.
  void forget_contact(int i, int j, int& flag, double* history) {
    contact_.i = i;
    contact_.j = j;
    contact_.contact_flags = &flag;
    contact_.contact_history = history;
    contact_.has_force_update = false;
    force_i_.reset();
    force_j_.reset();
    model_.surfacesClose(contact_, force_i_, force_j_);
  }

  /// What all contacts of one pair have in common.
  SurfacesIntersectData pair_record(int i, int j, const ellipsoid::Vector3& distance, int& flag) {
    SurfacesIntersectData c;
    c.is_non_spherical = true;
    c.computeflag = contact_.computeflag;
    c.shearupdate = contact_.shearupdate;
    c.i = i;
    c.j = j;
    c.itype = atom->type[i];
    c.jtype = atom->type[j];
    ellipsoid_host::store(-distance, c.delta);
    c.rsq = dot(distance, distance);
    c.r = std::sqrt(c.rsq);
    c.rinv = 1.0 / c.r;
    c.v_i = atom->v[i];
    c.v_j = atom->v[j];
    c.omega_i = atom->omega[i];
    c.omega_j = atom->omega[j];
    c.contact_flags = &flag;
    set_masses(c);
    return c;
  }

  /// @param[in] normal  unit, from i to j
  /// @param[in] point   relative to the centre of i (length)
  /// @param[in] radius_i, radius_j of the local spheres (length)
  void fill_contact(SurfacesIntersectData& c, const ellipsoid::Vector3& normal,
                    const ellipsoid::Vector3& point, double overlap, double reduced_radius,
                    double radius_i, double radius_j, double* history) {
    ellipsoid_host::store(-normal, c.en);
    ellipsoid_host::store(ellipsoid_host::vector(atom->x[c.i]) + point, c.contact_point);
    c.deltan = std::max(0.0, overlap);
    c.reff = reduced_radius;
    c.radi = pair_->curvature_radius_i = radius_i;
    c.radj = pair_->curvature_radius_j = radius_j;
    c.radsum = radius_i + radius_j;
    c.contact_history = history;
  }

  void set_masses(SurfacesIntersectData& c) {
    c.mi = atom->rmass[c.i];
    c.mj = atom->rmass[c.j];
    if (rigid_masses_) {
      if (rigid_masses_[c.i] > 0.0)
        c.mi = rigid_masses_[c.i];
      if (rigid_masses_[c.j] > 0.0)
        c.mj = rigid_masses_[c.j];
    }
    c.meff = c.mi * c.mj / (c.mi + c.mj);
    if (atom->mask[c.i] & frozen_group_)
      c.meff = c.mj;
    if (atom->mask[c.j] & frozen_group_)
      c.meff = c.mi;
  }

  /// Contact models and sums of forces, all inlined: the record then lives in registers.
  /// @param[in] weight of its force in the sum
  __attribute__((flatten)) void apply_contact(SurfacesIntersectData& c, double weight = 1.0) {
    ForceData force_i, force_j;
    model_.surfacesIntersect(c, force_i, force_j);
    model_.endSurfacesIntersect(c, nullptr, force_i, force_j);
    if (weight != 1.0) {
      scale(force_i, weight);
      scale(force_j, weight);
    }
    contact_.has_force_update = true;
    const bool owns_j = force->newton_pair || c.j < atom->nlocal;
    if (c.computeflag) {
      add_force(c.i, force_i);
      if (owns_j)
        add_force(c.j, force_j);
    }
    if (reports_)
      report_contact(c, force_i, force_j, owns_j);
  }

  static void scale(ForceData& f, double factor) {
    for (int k = 0; k < 3; ++k) {
      f.delta_F[k] *= factor;
      f.delta_torque[k] *= factor;
    }
  }

  void add_force(int i, const ForceData& force) {
    const double relax = pair_->relax(i);
    for (int k = 0; k < 3; ++k) {
      atom->f[i][k] += relax * force.delta_F[k];
      atom->torque[i][k] += relax * force.delta_torque[k];
    }
  }

  /// What other commands of the host want to know of each contact.
  __attribute__((noinline)) void report_contact(SurfacesIntersectData c, const ForceData& force_i,
                                                const ForceData& force_j, bool owns_j) {
    const int i = c.i, j = c.j;
    const double* f = force_i.delta_F;
    if (c.computeflag && pair_->store_sum_normal_force()) {
      const double normal_force = vectorDot3D(f, c.en);
      *pair_->get_sum_normal_force_ptr(i) += normal_force;
      if (owns_j)
        *pair_->get_sum_normal_force_ptr(j) += normal_force;
    }
    if (collect_) {
      ForceData force = force_i; // the host's signature
      pair_->cpl_add_pair(c, force);
    }
    if (pair_->evflag)
      pair_->ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, 0.0, 0.0, f[0], f[1], f[2],
                          c.delta[0], c.delta[1], c.delta[2]);
    if (pair_->storeContactForces() && 0 == update->ntimestep % pair_->storeContactForcesEvery()) {
      store_partner(pair_->fix_contact_forces(), i, j, force_i);
      store_partner(pair_->fix_contact_forces(), j, i, force_j);
    }
    if (pair_->storeContactForcesStress()) {
      store_stress_partner(i, j, force_i);
      store_stress_partner(j, i, force_j);
    }
  }

  void store_partner(FixContactPropertyAtom* fix, int i, int j, const ForceData& force) {
    if (fix->has_partner(i, atom->tag[j]) != -1)
      return;
    double values[6];
    std::copy(force.delta_F, force.delta_F + 3, values);
    std::copy(force.delta_torque, force.delta_torque + 3, values + 3);
    fix->add_partner(i, atom->tag[j], values);
  }

  void store_stress_partner(int i, int j, const ForceData& force) {
    FixContactPropertyAtom* fix = pair_->fix_contact_forces_stress();
    if (fix->has_partner(i, atom->tag[j]) != -1)
      return;
    double values[4] = {force.delta_F[0], force.delta_F[1], force.delta_F[2],
                        static_cast<double>(j)};
    fix->add_partner(i, atom->tag[j], values);
  }
};

} // namespace LIGGGHTS

#endif
