// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The pair loop of pair_style gran/ellipsoid: finds the contacts, calls the contact models, adds up
// forces and torques. The host's own loop (pair_gran_base.h) knows one contact per pair, on the line
// of centres.
//
// Per pair the history starts with what the search remembers: the unit normal from j to i (it flips
// with the order of the pair, as the host's flag 1 says) and whether the pair touched.
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
#include <vector>

namespace LIGGGHTS {

using namespace ContactModels;

template <typename Model>
class EllipsoidContactLoop : private Pointers, public PairStyles::IGranularPairStyle {
public:
  EllipsoidContactLoop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash)
      : Pointers(lmp), pair_(pair), model_((reserve_history(pair), lmp), pair, false, hash) {}

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
      error->all(FLERR, ("pair_style gran/ellipsoid: " + settings.error_message).c_str());
  }

  void write_restart_settings(FILE* file) override {
    const int64_t hash = model_.hashcode();
    fwrite(&hash, sizeof(hash), 1, file);
  }

  void read_restart_settings(FILE* file, int64_t) override {
    int64_t hash = -1;
    if (comm->me == 0 && fread(&hash, sizeof(hash), 1, file) != 1)
      error->one(FLERR, "The restart file ends within pair_style gran/ellipsoid; use a whole file");
  }

  void compute_force(PairGran*, int eflag, int vflag, int addflag) override {
    begin(eflag, vflag, addflag);
    const NeighList* list = pair_->list;
    for (int ii = 0; ii < list->inum; ++ii) {
      const int i = list->ilist[ii];
      double* history = pair_->listgranhistory->firstdouble[i];
      int* flags = pair_->listgranhistory->firstneigh[i];
      for (int jj = 0; jj < list->numneigh[i]; ++jj)
        treat_pair(i, list->firstneigh[i][jj] & NEIGHMASK, flags[jj],
                   &history[history_values_ * jj]);
    }
    end();
  }

private:
  // the search's own part of the history, at the offset 0
  enum SearchHistory { normal_x, normal_y, normal_z, was_touching };

  PairGranEllipsoid* pair_;
  Model model_;
  SurfacesIntersectData contact_;
  ForceData force_i_, force_j_;
  ContactCounts counts_;
  const std::vector<ellipsoid::EllipsoidShape>* shapes_ = nullptr;
  int history_values_ = 0;
  bool collect_ = false; // for compute pair/gran/local

  static void reserve_history(PairGranEllipsoid* pair) {
    pair->add_history_value("normalx", "1");
    pair->add_history_value("normaly", "1");
    pair->add_history_value("normalz", "1");
    pair->add_history_value("touching", "0");
  }

  void begin(int eflag, int vflag, int addflag) {
    if (eflag || vflag)
      pair_->ev_setup(eflag, vflag);
    else
      pair_->evflag = pair_->vflag_fdotr = 0;
    shapes_ = &pair_->update_shapes();
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

  void treat_pair(int i, int j, int& flag, double* history) {
    const double* x_i = atom->x[i];
    const double* x_j = atom->x[j];
    const double reach = atom->radius[i] + atom->radius[j];
    const ellipsoid::Vector3 distance{x_j[0] - x_i[0], x_j[1] - x_i[1], x_j[2] - x_i[2]};
    const double squared_distance = dot(distance, distance);
    counts_.values[ContactCounts::near_pairs] += j < atom->nlocal ? 1.0 : 0.5;
    if (squared_distance < reach * reach) {
      const ellipsoid::ContactGeometry geometry = search(i, j, distance, history);
      if (geometry.status != ellipsoid::ContactStatus::separated) {
        fill_contact(i, j, distance, squared_distance, geometry, flag, history);
        apply_contact();
        return;
      }
    }
    if (flag || history[was_touching] != 0.0)
      forget_contact(i, j, flag, history);
  }

  /// A touching pair starts from its last normal. All others start from scratch once a remembered
  /// separating normal fails: what a new contact is does not depend on what happened before it, nor
  /// on whether the run was interrupted.
  ellipsoid::ContactGeometry search(int i, int j, const ellipsoid::Vector3& distance,
                                    double* history) {
    using namespace ellipsoid;
    const EllipsoidShape& shape_i = (*shapes_)[static_cast<std::size_t>(i)];
    const EllipsoidShape& shape_j = (*shapes_)[static_cast<std::size_t>(j)];
    const Vector3 remembered = -ellipsoid_host::vector(&history[normal_x]);
    const bool has_normal = dot(remembered, remembered) > 0.5; // unit vector, or zero
    ContactGeometry geometry;
    if (has_normal && history[was_touching] != 0.0) {
      geometry = find_contact_from(remembered, shape_i, shape_j, distance);
    } else {
      if (has_normal && overlap_along(shape_i, shape_j, distance, remembered) < 0.0)
        return geometry;
      geometry = find_contact(shape_i, shape_j, distance);
    }
    count_search(geometry, j < atom->nlocal ? 1.0 : 0.5);
    if (contact_.computeflag)
      ellipsoid_host::store(-geometry.normal, &history[normal_x]);
    return geometry;
  }

  void count_search(const ellipsoid::ContactGeometry& geometry, double share) {
    counts_.values[ContactCounts::searched_pairs] += share;
    counts_.values[ContactCounts::newton_steps] += share * geometry.iterations;
    if (geometry.status == ellipsoid::ContactStatus::not_converged)
      counts_.values[ContactCounts::not_converged] += share;
  }

  void forget_contact(int i, int j, int& flag, double* history) {
    contact_.i = i;
    contact_.j = j;
    contact_.contact_flags = &flag;
    contact_.contact_history = history;
    contact_.has_force_update = false;
    force_i_.reset();
    force_j_.reset();
    model_.surfacesClose(contact_, force_i_, force_j_);
    history[was_touching] = 0.0;
    flag = 0;
  }

  void fill_contact(int i, int j, const ellipsoid::Vector3& distance, double squared_distance,
                    const ellipsoid::ContactGeometry& geometry, int& flag, double* history) {
    using ellipsoid_host::store;
    SurfacesIntersectData& c = contact_;
    c.i = i;
    c.j = j;
    c.itype = atom->type[i];
    c.jtype = atom->type[j];
    store(-distance, c.delta);
    c.rsq = squared_distance;
    c.r = std::sqrt(squared_distance);
    c.rinv = 1.0 / c.r;
    store(-geometry.normal, c.en);
    store(ellipsoid_host::vector(atom->x[i]) + geometry.point, c.contact_point);
    c.deltan = std::max(0.0, geometry.overlap);
    c.reff = geometry.reduced_radius;
    // local spheres with the Gaussian radii of curvature, scaled so that their R is that of (19)
    const double r_i = geometry.curvature_radius_i, r_j = geometry.curvature_radius_j;
    const double scale = geometry.reduced_radius * (r_i + r_j) / (r_i * r_j);
    c.radi = pair_->curvature_radius_i = scale * r_i;
    c.radj = pair_->curvature_radius_j = scale * r_j;
    c.radsum = c.radi + c.radj;
    c.v_i = atom->v[i];
    c.v_j = atom->v[j];
    c.omega_i = atom->omega[i];
    c.omega_j = atom->omega[j];
    set_masses();
    c.contact_flags = &flag;
    c.contact_history = history;
    if (c.computeflag)
      history[was_touching] = 1.0;
    flag |= CONTACT_SURFACE_MODEL;
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

  void apply_contact() {
    force_i_.reset();
    force_j_.reset();
    model_.surfacesIntersect(contact_, force_i_, force_j_);
    model_.endSurfacesIntersect(contact_, nullptr, force_i_, force_j_);
    contact_.has_force_update = true;
    const int i = contact_.i, j = contact_.j;
    const bool owns_j = force->newton_pair || j < atom->nlocal;
    counts_.values[ContactCounts::contacts] += owns_j ? 1.0 : 0.5;
    if (contact_.computeflag) {
      add_force(i, force_i_);
      if (owns_j)
        add_force(j, force_j_);
    }
    report_contact(i, j, owns_j);
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
