// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The pair loop of pair_style gran/ellipsoid, as far as it is the same for all surfaces: walks over
// the neighbour list, calls the contact models, adds up forces and torques. The host's own loop
// (pair_gran_base.h) knows one contact per pair, on the line of centres. What the contacts of a
// pair are is for the derived classes (smooth_contact_loop.h, multisphere_contact_loop.h).
#ifndef ELLIPSOID_CONTACT_LOOP_H_
#define ELLIPSOID_CONTACT_LOOP_H_

#include "atom.h"
#include "batched_law.h"
#include "comm.h"
#include "contact_models.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_contact_property_atom.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran_ellipsoid.h"
#include "particle_arrays.h"
#include "separation/sleeping_pairs.h"
#include "settings.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace LIGGGHTS {

using namespace ContactModels;

/// Names of history values, and whether they change sign when the pair is seen from j.
using SearchHistory = std::vector<std::pair<std::string, bool>>;

/// @tparam Surface the derived class. It has
///          - prepare(): before the first pair; returns whether the neighbour lists are new;
///          - begin_lists(pairs): after that, if they are;
///          - treat_new_lists(): then, with all pairs;
///          - asks_flags: false if every pair that stays awake touches and its flag is left alone;
///          - prefetch_particle(i): asks the processor for the data of a particle;
///          - clocks(): of the motion of the particles;
///          - look_at_woken(pairs): pairs that slept; each goes on sleeping by put_to_sleep(), or
///            stays awake by stay_awake();
///          - treat_pair(pair, flag, history) of a pair that is awake:
///            returns whether it stays awake, puts it to sleep if not; hands every contact to
///            add_contact();
///          - finish(): after the last pair.
/// @tparam Model   the host's ContactModel<...>
template <typename Surface, typename Model>
class EllipsoidContactLoop : protected Pointers, public PairStyles::IGranularPairStyle {
 public:
  /// @param[in] search_history what the search remembers of a pair or contact: (name, flips) each;
  ///            these values come first in the history, those of the models follow
  EllipsoidContactLoop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash,
                       const SearchHistory& search_history)
      : Pointers(lmp), pair_(pair),
        model_((reserve(pair, search_history), lmp), pair, false, hash) {}

  int64_t hashcode() override { return model_.hashcode(); }
  int get_history_offset(const std::string name) override {
    return model_.get_history_offset(name);
  }
  double stressStrainExponent() override { return model_.stressStrainExponent(); }
  bool contact_match(const std::string type, const std::string model) override {
    return model_.contact_match(type, model);
  }
  void init_granular() override {
    model_.connectToProperties(force->registry);
    if (IsPaperLaw<Model>::value)
      tables_.connect(force->registry);
  }

  void settings(int narg, char** arg, IContactHistorySetup* setup) override {
    Settings settings(lmp);
    model_.registerSettings(settings);
    const bool success = settings.parseArguments(narg, arg);
    model_.postSettings(setup);
    in_batches_ = IsPaperLaw<Model>::value && model_.get_history_offset("creeps") == 0 &&
                  model_.get_history_offset("ellipticalContact") <= 0;
    no_attraction_ = model_.get_history_offset("limitForce") == 1;
    spring_offset_ = model_.get_history_offset("spring");
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
    if (is_set_up())
      surface.clocks().forget();
    const bool new_lists = surface.prepare();
    if (new_lists)
      surface.begin_lists(begin_lists());
    counts_.values[ContactCounts::near_pairs] = near_pairs_;
    if (new_lists) {
      surface.treat_new_lists();
    } else {
      wake_pairs();
      treat_awake_pairs();
    }
    surface.finish();
    apply_waiting_contacts();
    end();
  }

 protected:
  PairGranEllipsoid* pair_;
  Model model_;
  SurfacesIntersectData contact_;
  ForceData force_i_, force_j_;
  ContactCounts counts_;
  ParticleArrays particles_;
  bool newton_ = false;
  int history_values_ = 0; // per pair
  bool collect_ = false;   // for compute pair/gran/local
  bool reports_ = false;   // somebody wants to know of each contact
  int frozen_group_ = 0;
  const double* rigid_masses_ = nullptr; // of the bodies that particles belong to

  ellipsoid::SleepingPairs sleeping_; // by their places in the neighbour lists
  double near_pairs_ = 0.0;

  /// A pair and its place in the neighbour lists.
  struct ListPair {
    std::uint32_t place;
    int i, j;
  };
  std::vector<ListPair> woken_;
  static constexpr std::size_t looked_at_together = 4096; // or a few more

  struct AwakePair : ListPair {
    bool touched; ///< in the last step
    int* flag;
    double* history;
  };
  std::vector<AwakePair> awake_;
  static constexpr std::size_t pairs_ahead = 16;
  static constexpr std::ptrdiff_t doubles_per_cache_line = 8;

  // What the batch of the contact law needs: see batched_law.h.
  bool in_batches_ = false, no_attraction_ = false;
  int spring_offset_ = 0;
  PaperLawTables tables_;

  static void reserve(PairGranEllipsoid* pair, const SearchHistory& search_history) {
    for (const auto& value : search_history)
      pair->add_history_value(value.first, value.second ? "1" : "0");
  }

  /// x_j - x_i.
  ellipsoid::Vector3 centre_distance(int i, int j) const {
    const double* x_i = particles_.x[i];
    const double* x_j = particles_.x[j];
    return {x_j[0] - x_i[0], x_j[1] - x_i[1], x_j[2] - x_i[2]};
  }

  /// Gap between the bounding spheres, 0 if they overlap.
  double bounding_gap(int i, int j, const ellipsoid::Vector3& distance) const {
    const double reach = particles_.radius[i] + particles_.radius[j],
                 squared = dot(distance, distance);
    return squared < reach * reach ? 0.0 : std::sqrt(squared) - reach;
  }

  /// Calls visit(i, j) for all pairs of the neighbour lists.
  template <typename Visit> void for_each_pair(const Visit& visit) const {
    const NeighList* list = pair_->list;
    for (int ii = 0; ii < list->inum; ++ii) {
      const int i = list->ilist[ii];
      for (int jj = 0; jj < list->numneigh[i]; ++jj)
        visit(i, list->firstneigh[i][jj] & NEIGHMASK);
    }
  }

  /// When a run is set up forces are evaluated without a step: this leaves no trace, so that a run
  /// may be set up any number of times.
  bool is_set_up() const { return !(contact_.computeflag && contact_.shearupdate); }

  /// Returns the number of pairs in the neighbour lists.
  std::size_t begin_lists() {
    sleeping_.restart(static_cast<std::size_t>(atom->nlocal + atom->nghost),
                      [this](const auto& visit) { for_each_pair(visit); });
    near_pairs_ = 0.0;
    for_each_pair([this](int, int j) { near_pairs_ += share(j); });
    awake_.clear();
    return sleeping_.size();
  }

  double* history(const ListPair& pair) const {
    const std::size_t jj = pair.place - sleeping_.first_place(pair.i);
    return &pair_->listgranhistory
                ->firstdouble[pair.i][static_cast<std::size_t>(history_values_) * jj];
  }

  AwakePair awake(const ListPair& pair) const {
    const std::size_t jj = pair.place - sleeping_.first_place(pair.i);
    return {pair, false, &pair_->listgranhistory->firstneigh[pair.i][jj], history(pair)};
  }

  /// Returns whether the pair stays awake.
  bool treat(const AwakePair& pair) {
    return static_cast<Surface&>(*this).treat_pair(pair, *pair.flag, pair.history);
  }

  void treat_all_pairs() {
    std::uint32_t place = 0;
    for_each_pair([this, &place](int i, int j) {
      const AwakePair pair = awake({place++, i, j});
      if (treat(pair))
        awake_.push_back(pair);
    });
  }

  void treat_awake_pairs() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < awake_.size(); ++k) {
      const AwakePair& pair = awake_[k];
      prefetch(k + pairs_ahead);
      if (!treat(pair))
        continue;
      const bool touches = Surface::asks_flags ? *pair.flag != 0 : true;
      if (kept != k)
        awake_[kept] = pair;
      awake_[kept++].touched = touches;
    }
    awake_.resize(kept);
  }

  /// Adds to the pairs that are awake those whose time has come.
  void wake_pairs() {
    Surface& surface = static_cast<Surface&>(*this);
    woken_.clear();
    const auto look = [this, &surface] {
      surface.look_at_woken(woken_);
      woken_.clear();
    };
    const auto note = [this](std::size_t place, int i, int j) {
      ListPair& pair = woken_.emplace_back(); // number by number: see contact_batch.h
      pair.place = static_cast<std::uint32_t>(place);
      pair.i = i;
      pair.j = j;
    };
    sleeping_.wake(surface.clocks(), note, [this, &look] {
      if (woken_.size() >= looked_at_together)
        look();
    });
    look();
  }

  void stay_awake(const ListPair& pair) { awake_.push_back(awake(pair)); }

  /// @param[in] gap between the particles (length), @param[in] approach see MotionClocks (length)
  void put_to_sleep(const ListPair& pair, double gap, double approach) {
    sleeping_.sleep(pair.place, pair.i, gap, approach, static_cast<Surface&>(*this).clocks());
  }

  /// @param[in] normal unit, from i to j, along which the gap is measured
  void put_to_sleep(const ListPair& pair, double gap, const ellipsoid::Vector3& normal) {
    put_to_sleep(pair, gap, static_cast<Surface&>(*this).clocks().approach(pair.i, pair.j, normal));
  }

  /// The histories of pairs lie apart in memory: asked for in time, they are there when needed.
  __attribute__((always_inline)) void prefetch(std::size_t k) const {
    if (k >= awake_.size() || !awake_[k].touched)
      return;
    if (Surface::asks_flags)
      __builtin_prefetch(awake_[k].flag, 1);
    __builtin_prefetch(awake_[k].history, 1);
    __builtin_prefetch(awake_[k].history + doubles_per_cache_line, 1);
    static_cast<const Surface&>(*this).prefetch_particle(awake_[k].j);
  }

  /// Pairs with a ghost are treated by two ranks.
  double share(int j) const { return j < particles_.owned ? 1.0 : 0.5; }

  void begin(int eflag, int vflag, int addflag) {
    if (eflag || vflag)
      pair_->ev_setup(eflag, vflag);
    else
      pair_->evflag = pair_->vflag_fdotr = 0;
    history_values_ = pair_->dnum();
    if (in_batches_)
      tables_.begin_step();
    particles_ = ParticleArrays(*atom);
    newton_ = force->newton_pair;
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
  struct TouchingPair {
    int i, j;
    int* flag;
    ellipsoid::Vector3 distance; ///< x_j - x_i (length)
    bool is_flagged = false;     ///< by the last step
  };

  /// One contact.
  struct Touch {
    ellipsoid::Vector3 normal; ///< unit, from i to j
    ellipsoid::Vector3 point;  ///< relative to the centre of i (length)
    double overlap, reduced_radius;
    double radius_i, radius_j; ///< Gaussian radii of curvature (length)
    double* history;
    double weight = 1.0; ///< of its force in the sum
    int sphere_i = -1, sphere_j = -1;
  };

  /// Of a contact in the batch, what the batch does not know.
  struct WaitingContact {
    int i, j;
    int* flag;
    double* history;
    double weight, radius_i, radius_j;
    int sphere_i, sphere_j;
  };
  ellipsoid::ContactLawBatch law_batch_;
  WaitingContact waiting_contacts_[ellipsoid::ContactLawBatch::capacity];

  double mass(int i) const {
    return rigid_masses_ && rigid_masses_[i] > 0.0 ? rigid_masses_[i] : particles_.mass[i];
  }

  ellipsoid::PairMasses masses(int i, int j) const {
    if (!frozen_group_ && !rigid_masses_)
      return {particles_.mass[i], particles_.mass[j]};
    if (particles_.mask[i] & frozen_group_)
      return ellipsoid::PairMasses::one_held(mass(j));
    if (particles_.mask[j] & frozen_group_)
      return ellipsoid::PairMasses::one_held(mass(i));
    return {mass(i), mass(j)};
  }

  __attribute__((always_inline)) void add_contact(const TouchingPair& pair, const Touch& touch) {
    if (!in_batches_) {
      apply_alone(pair, touch);
      return;
    }
    waiting_contacts_[law_batch_.size()] = {pair.i,         pair.j,         pair.flag,
                                            touch.history,  touch.weight,   touch.radius_i,
                                            touch.radius_j, touch.sphere_i, touch.sphere_j};
    if (!pair.is_flagged)
      flag_for_law(*pair.flag);
    law_batch_.add({-touch.normal, touch.point, touch.point - pair.distance,
                    std::max(0.0, touch.overlap), touch.reduced_radius},
                   motion(pair.i, pair.j), law_parameters(pair.i, pair.j), masses(pair.i, pair.j),
                   spring(touch.history));
    if (law_batch_.full())
      apply_waiting_contacts();
  }

  static void flag_for_law(int& flag) { flag |= CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL; }

  ellipsoid::PairMotion motion(int i, int j) const {
    using ellipsoid_host::vector;
    return {vector(particles_.v[i]) - vector(particles_.v[j]), vector(particles_.omega[i]),
            vector(particles_.omega[j])};
  }
  const ellipsoid::LawParameters& law_parameters(int i, int j) const {
    return tables_.parameters(particles_.type[i], particles_.type[j]);
  }
  ellipsoid::Vector3 spring(const double* history) const {
    return ellipsoid_host::vector(&history[spring_offset_]);
  }

  /// By the host's contact models.
  __attribute__((noinline)) void apply_alone(const TouchingPair& pair, const Touch& touch) {
    SurfacesIntersectData c = record(pair, touch);
    pair_->set_spheres(touch.sphere_i, touch.sphere_j, touch.weight);
    apply_contact(c, touch.weight);
  }

  void apply_waiting_contacts() {
    apply_contacts([this](int k) { return waiting_contacts_[k]; });
  }

  /// In the order in which they came.
  /// @param[in] contact_of contact_of(k): contact k of the batch; if it has no history it is none
  template <typename ContactOf>
  __attribute__((noinline)) void apply_contacts(const ContactOf& contact_of) {
    const bool advances_springs = !is_set_up(), adds = contact_.computeflag;
    const bool reports = reports_ || pair_->keeps_records();
    law_batch_.solve({update->dt, advances_springs, no_attraction_});
    const bool in_plane = law_batch_.are_in_plane();
    for (int k = 0; k < law_batch_.size(); ++k) {
      const WaitingContact contact = contact_of(k);
      if (!contact.history)
        continue;
      if (advances_springs)
        ellipsoid_host::store(law_batch_.spring(k), &contact.history[spring_offset_]);
      if (adds && in_plane)
        add_action<true>(contact, law_batch_.action(k));
      else if (adds)
        add_action<false>(contact, law_batch_.action(k));
      if (reports)
        report_action(contact, law_batch_.place(k), law_batch_.action(k));
    }
    law_batch_.clear();
  }

  bool owns(int j) const { return newton_ || j < particles_.owned; }

  /// @tparam in_plane the other numbers are 0
  template <bool in_plane>
  void add_action(const WaitingContact& contact, const ellipsoid::ContactAction& action) {
    const auto add = [this](int k, const ellipsoid::Vector3& f, const ellipsoid::Vector3& t) {
      double *to = particles_.f[k], *torque = particles_.torque[k];
      to[0] += f.x;
      to[1] += f.y;
      torque[2] += t.z;
      if (in_plane)
        return;
      to[2] += f.z;
      torque[0] += t.x;
      torque[1] += t.y;
    };
    const double share_i = contact.weight * pair_->relax(contact.i);
    add(contact.i, share_i * action.force, share_i * action.torque_i);
    if (!owns(contact.j))
      return;
    const double share_j = contact.weight * pair_->relax(contact.j);
    add(contact.j, -share_j * action.force, share_j * action.torque_j);
  }

  __attribute__((noinline)) void report_action(const WaitingContact& contact,
                                               const ellipsoid::ContactPlace& place,
                                               const ellipsoid::ContactAction& action) {
    const Touch touch{-place.normal,    place.lever_i,    place.overlap,   place.reduced_radius,
                      contact.radius_i, contact.radius_j, contact.history, contact.weight,
                      contact.sphere_i, contact.sphere_j};
    const SurfacesIntersectData c =
        record({contact.i, contact.j, contact.flag, centre_distance(contact.i, contact.j)}, touch);
    ForceData force_i, force_j;
    ellipsoid_host::store(touch.weight * action.force, force_i.delta_F);
    ellipsoid_host::store(-touch.weight * action.force, force_j.delta_F);
    ellipsoid_host::store(touch.weight * action.torque_i, force_i.delta_torque);
    ellipsoid_host::store(touch.weight * action.torque_j, force_j.delta_torque);
    if (c.computeflag && pair_->keeps_records()) {
      pair_->set_spheres(touch.sphere_i, touch.sphere_j, touch.weight);
      pair_->add_record(c, action.force, *atom, nullptr);
    }
    if (reports_)
      report_contact(c, force_i, force_j, owns(c.j));
  }

  /// As the host's contact models want it.
  SurfacesIntersectData record(const TouchingPair& pair, const Touch& touch) const {
    const int i = pair.i, j = pair.j;
    SurfacesIntersectData c;
    c.is_non_spherical = true;
    c.computeflag = contact_.computeflag;
    c.shearupdate = contact_.shearupdate;
    c.i = i;
    c.j = j;
    c.itype = atom->type[i];
    c.jtype = atom->type[j];
    ellipsoid_host::store(-pair.distance, c.delta);
    c.rsq = dot(pair.distance, pair.distance);
    c.r = std::sqrt(c.rsq);
    c.rinv = 1.0 / c.r;
    c.v_i = atom->v[i];
    c.v_j = atom->v[j];
    c.omega_i = atom->omega[i];
    c.omega_j = atom->omega[j];
    c.contact_flags = pair.flag;
    c.mi = mass(i);
    c.mj = mass(j);
    c.meff = masses(i, j).effective();
    ellipsoid_host::store(-touch.normal, c.en);
    ellipsoid_host::store(ellipsoid_host::vector(atom->x[i]) + touch.point, c.contact_point);
    c.deltan = std::max(0.0, touch.overlap);
    c.reff = touch.reduced_radius;
    // local spheres with the Gaussian radii of curvature, scaled so that their R is that of (19)
    const double scale = touch.reduced_radius * (touch.radius_i + touch.radius_j) /
                         (touch.radius_i * touch.radius_j);
    c.radi = pair_->curvature_radius_i = scale * touch.radius_i;
    c.radj = pair_->curvature_radius_j = scale * touch.radius_j;
    c.radsum = c.radi + c.radj;
    c.contact_history = touch.history;
    return c;
  }

  /// Contact models and sums of forces, all inlined: the record then lives in registers.
  /// @param[in] weight of its force in the sum
  __attribute__((flatten)) void apply_contact(SurfacesIntersectData& c, double weight) {
    ForceData force_i, force_j;
    model_.surfacesIntersect(c, force_i, force_j);
    model_.endSurfacesIntersect(c, nullptr, force_i, force_j);
    if (weight != 1.0) {
      scale(force_i, weight);
      scale(force_j, weight);
    }
    contact_.has_force_update = true;
    const bool owns_j = owns(c.j);
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
