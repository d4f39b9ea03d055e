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

/// Names of history values, and whether they change sign when the pair is seen from j.
using SearchHistory = std::vector<std::pair<std::string, bool>>;

/// @tparam Surface the derived class; it has prepare(), and treat_pair(i, j, flag, history)
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
    surface.prepare();
    const NeighList* list = pair_->list;
    for (int ii = 0; ii < list->inum; ++ii) {
      const int i = list->ilist[ii];
      double* history = pair_->listgranhistory->firstdouble[i];
      int* flags = pair_->listgranhistory->firstneigh[i];
      for (int jj = 0; jj < list->numneigh[i]; ++jj)
        surface.treat_pair(i, list->firstneigh[i][jj] & NEIGHMASK, flags[jj],
                           &history[history_values_ * jj]);
    }
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

  static void reserve(PairGranEllipsoid* pair, const SearchHistory& search_history) {
    for (const auto& value : search_history)
      pair->add_history_value(value.first, value.second ? "1" : "0");
  }

  /// x_j - x_i if the bounding spheres overlap.
  bool is_near(int i, int j, ellipsoid::Vector3& distance) {
    counts_.values[ContactCounts::near_pairs] += share(j);
    const double* x_i = atom->x[i];
    const double* x_j = atom->x[j];
    distance = {x_j[0] - x_i[0], x_j[1] - x_i[1], x_j[2] - x_i[2]};
    const double reach = atom->radius[i] + atom->radius[j];
    return dot(distance, distance) < reach * reach;
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
  void fill_pair(int i, int j, const ellipsoid::Vector3& distance, int& flag) {
    SurfacesIntersectData& c = contact_;
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
    set_masses();
  }

  /// @param[in] normal  unit, from i to j
  /// @param[in] point   relative to the centre of i (length)
  /// @param[in] radius_i, radius_j of the local spheres (length)
  void fill_contact(const ellipsoid::Vector3& normal, const ellipsoid::Vector3& point,
                    double overlap, double reduced_radius, double radius_i, double radius_j,
                    double* history) {
    SurfacesIntersectData& c = contact_;
    ellipsoid_host::store(-normal, c.en);
    ellipsoid_host::store(ellipsoid_host::vector(atom->x[c.i]) + point, c.contact_point);
    c.deltan = std::max(0.0, overlap);
    c.reff = reduced_radius;
    c.radi = pair_->curvature_radius_i = radius_i;
    c.radj = pair_->curvature_radius_j = radius_j;
    c.radsum = radius_i + radius_j;
    c.contact_history = history;
  }

  void set_masses() {
    SurfacesIntersectData& c = contact_;
    c.mi = atom->rmass[c.i];
    c.mj = atom->rmass[c.j];
    if (pair_->fr_pair()) {
      const double* rigid = pair_->mr_pair();
      if (rigid[c.i] > 0.0)
        c.mi = rigid[c.i];
      if (rigid[c.j] > 0.0)
        c.mj = rigid[c.j];
    }
    c.meff = c.mi * c.mj / (c.mi + c.mj);
    const int frozen = pair_->freeze_group_bit();
    if (atom->mask[c.i] & frozen)
      c.meff = c.mj;
    if (atom->mask[c.j] & frozen)
      c.meff = c.mi;
  }

  /// @param[in] weight of its force in the sum
  void apply_contact(double weight = 1.0) {
    force_i_.reset();
    force_j_.reset();
    model_.surfacesIntersect(contact_, force_i_, force_j_);
    model_.endSurfacesIntersect(contact_, nullptr, force_i_, force_j_);
    if (weight != 1.0) {
      scale(force_i_, weight);
      scale(force_j_, weight);
    }
    contact_.has_force_update = true;
    const int i = contact_.i, j = contact_.j;
    const bool owns_j = force->newton_pair || j < atom->nlocal;
    if (contact_.computeflag) {
      add_force(i, force_i_);
      if (owns_j)
        add_force(j, force_j_);
    }
    report_contact(i, j, owns_j);
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
  void report_contact(int i, int j, bool owns_j) {
    const double* f = force_i_.delta_F;
    if (contact_.computeflag && pair_->store_sum_normal_force()) {
      const double normal_force = vectorDot3D(f, contact_.en);
      *pair_->get_sum_normal_force_ptr(i) += normal_force;
      if (owns_j)
        *pair_->get_sum_normal_force_ptr(j) += normal_force;
    }
    if (collect_)
      pair_->cpl_add_pair(contact_, force_i_);
    if (pair_->evflag)
      pair_->ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, 0.0, 0.0, f[0], f[1], f[2],
                          contact_.delta[0], contact_.delta[1], contact_.delta[2]);
    if (pair_->storeContactForces() && 0 == update->ntimestep % pair_->storeContactForcesEvery()) {
      store_partner(pair_->fix_contact_forces(), i, j, force_i_);
      store_partner(pair_->fix_contact_forces(), j, i, force_j_);
    }
    if (pair_->storeContactForcesStress()) {
      store_stress_partner(i, j, force_i_);
      store_stress_partner(j, i, force_j_);
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
