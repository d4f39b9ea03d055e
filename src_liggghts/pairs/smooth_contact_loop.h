// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of smooth ellipsoids: at most one per pair.
//
// The history of a pair starts with what the search remembers: the unit normal from j to i (it
// flips with the order of the pair, as the host's flag 1 says) and whether the pair touched.
#ifndef SMOOTH_CONTACT_LOOP_H_
#define SMOOTH_CONTACT_LOOP_H_

#include "ellipsoid/contact_batch.h"
#include "ellipsoid_contact_loop.h"
#include "ellipsoid_shapes.h"
#include "surface_motions.h"

namespace LIGGGHTS {

template <typename Model>
class SmoothContactLoop : public EllipsoidContactLoop<SmoothContactLoop<Model>, Model> {
  using Base = EllipsoidContactLoop<SmoothContactLoop<Model>, Model>;
  friend Base;
  using Base::contact_;
  using Base::counts_;

 public:
  SmoothContactLoop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash)
      : Base(lmp, pair, hash,
             {{"normalx", true}, {"normaly", true}, {"normalz", true}, {"touching", false}}) {}

 private:
  enum { normal_x, normal_y, normal_z, was_touching }; // offsets in the history
  static constexpr bool asks_flags = false;

  EllipsoidShapes shapes_;
  SurfaceMotions motions_;
  bool flags_are_set_ = false; // of all pairs that touched in the last step

  bool prepare() {
    const bool new_lists = motions_.update(*this->atom, this->update->dt, this->neighbor->ago == 0);
    shapes_.begin_step(*this->atom, new_lists);
    flags_are_set_ = !new_lists;
    return new_lists;
  }
  void begin_lists(std::size_t) {}
  /// What the search and the law will read of a particle.
  __attribute__((always_inline)) void prefetch_particle(int i) const {
    __builtin_prefetch(shapes_.address(i), 1);
    __builtin_prefetch(this->particles_.x[i]);
    __builtin_prefetch(this->particles_.v[i]);
    __builtin_prefetch(this->particles_.omega[i]);
  }
  ellipsoid::MotionClocks& clocks() { return motions_.clocks(); }

  const ellipsoid::EllipsoidShape& shape(int i) { return shapes_[i]; }

  /// Most pairs that do not touch need no search.
  void treat_new_lists() {
    std::uint32_t place = 0;
    this->woken_.clear();
    this->for_each_pair([this, &place](int i, int j) {
      const typename Base::ListPair pair{place++, i, j};
      if (this->history(pair)[was_touching] != 0.0) {
        this->stay_awake(pair);
        return;
      }
      this->woken_.push_back(pair);
      if (this->woken_.size() == this->looked_at_together) {
        look_at_woken(this->woken_);
        this->woken_.clear();
      }
    });
    look_at_woken(this->woken_);
    this->treat_awake_pairs();
  }

  /// Most pairs that slept are still apart: one Newton step from the normal that separated them
  /// tells how far.
  __attribute__((noinline)) void look_at_woken(const std::vector<typename Base::ListPair>& pairs) {
    for (const typename Base::ListPair& pair : pairs) {
      const ellipsoid::Vector3 distance = this->centre_distance(pair.i, pair.j);
      double* history = this->history(pair);
      const double bounding_gap = this->bounding_gap(pair.i, pair.j, distance);
      if (bounding_gap > 0.0) {
        this->put_to_sleep(pair, bounding_gap, normalized(distance));
        continue;
      }
      const ellipsoid::Vector3 remembered = -ellipsoid_host::vector(&history[normal_x]);
      const bool has_normal = dot(remembered, remembered) > 0.5; // unit vector, or zero
      looked_at_[batch_.size()] = {pair, history};
      batch_.add(shape(pair.i), shape(pair.j), distance,
                 has_normal ? remembered : ellipsoid::normalized(distance));
      if (batch_.full())
        finish_woken();
    }
    finish_woken();
  }

  struct WokenPair {
    typename Base::ListPair pair;
    double* history;
  };
  WokenPair looked_at_[ellipsoid::ContactBatch::capacity];

  void finish_woken() {
    batch_.find_gaps();
    for (int k = 0; k < batch_.size(); ++k) {
      const auto [pair, history] = looked_at_[k];
      const double gap = batch_.gap(k), share = this->share(pair.j);
      counts_.values[ContactCounts::tested] += share;
      counts_.values[ContactCounts::newton_steps] += share;
      if (!(gap > 0.0)) {
        this->stay_awake(pair);
        continue;
      }
      if (!this->is_set_up())
        ellipsoid_host::store(-batch_.normal(k), &history[normal_x]);
      this->put_to_sleep(pair, gap, batch_.normal(k));
    }
    batch_.clear();
  }

  /// Most pairs are searched in one step and touch: the others are counted besides.
  struct Counts {
    double tested = 0.0, more_steps = 0.0, apart = 0.0, not_converged = 0.0;
  };

  /// A touching pair starts from its last normal, together with others.
  __attribute__((always_inline)) bool treat_pair(const typename Base::ListPair& pair, int& flag,
                                                 double* history) {
    if (history[was_touching] == 0.0)
      return treat_new_contact(pair, flag, history);
    const ellipsoid::Vector3 distance = this->centre_distance(pair.i, pair.j);
    PairAtHand& waiting = waiting_[batch_.size()]; // number by number: see contact_batch.h
    waiting.i = pair.i;
    waiting.j = pair.j;
    waiting.flag = &flag;
    waiting.history = history;
    batch_.add(shape(pair.i), shape(pair.j), distance, -ellipsoid_host::vector(&history[normal_x]));
    if (batch_.full())
      finish();
    return true;
  }

  /// All others start from scratch: what a new contact is does not depend on what happened before
  /// it, nor on whether the run was interrupted.
  __attribute__((noinline)) bool treat_new_contact(const typename Base::ListPair& pair, int& flag,
                                                   double* history) {
    const int i = pair.i, j = pair.j;
    const ellipsoid::Vector3 distance = this->centre_distance(i, j);
    const double bounding_gap = this->bounding_gap(i, j, distance);
    if (bounding_gap > 0.0) {
      forget(i, j, flag, history);
      this->put_to_sleep(pair, bounding_gap, normalized(distance));
      return false;
    }
    const ellipsoid::Vector3 remembered = -ellipsoid_host::vector(&history[normal_x]);
    if (dot(remembered, remembered) > 0.5) { // unit vector, or zero
      const double gap = -overlap_along(shape(i), shape(j), distance, remembered);
      if (gap > 0.0) {
        this->put_to_sleep(pair, gap, remembered);
        return false;
      }
    }
    ellipsoid::SearchOptions options;
    options.goal = ellipsoid::SearchGoal::distance; // the farther apart, the longer the pair sleeps
    const ellipsoid::ContactGeometry contact = find_contact(shape(i), shape(j), distance, options);
    Counts counts;
    treat_result({i, j, &flag, history, false}, contact, counts);
    publish(counts);
    if (contact.status != ellipsoid::ContactStatus::separated)
      return true;
    this->put_to_sleep(pair, -contact.overlap, contact.normal);
    return false;
  }

  /// The waiting pairs, in the order in which they came.
  __attribute__((noinline)) void finish() {
    batch_.solve();
    Counts counts; // here, to live in registers
    if (this->in_batches_)
      treat_together(counts);
    else
      treat_one_by_one(counts);
    publish(counts);
    batch_.clear();
  }

  void treat_one_by_one(Counts& counts) {
    for (int k = 0; k < batch_.size(); ++k)
      treat_result(waiting_[k], batch_.geometry(k), counts);
  }

  /// By the batch of the contact law, which takes its places from that of the search.
  __attribute__((flatten)) void treat_together(Counts& counts) {
    this->apply_waiting_contacts();
    batch_.solve_open();
    this->law_batch_.take_places(batch_);
    for (int k = 0; k < batch_.size(); ++k) {
      PairAtHand& pair = waiting_[k];
      if (!touches(pair,
                   {batch_.normal(k), batch_.steps(k), batch_.is_apart(k), batch_.has_converged(k)},
                   counts)) {
        pair.history = nullptr;
        continue;
      }
      if (!flags_are_set_) {
        *pair.flag |= CONTACT_SURFACE_MODEL;
        this->flag_for_law(*pair.flag);
      }
      this->law_batch_.move(k, this->motion(pair.i, pair.j), this->law_parameters(pair.i, pair.j),
                            this->masses(pair.i, pair.j), this->spring(pair.history));
    }
    this->apply_contacts([this](int k) -> typename Base::WaitingContact {
      const PairAtHand& pair = waiting_[k];
      return {pair.i,
              pair.j,
              pair.flag,
              pair.history,
              1.0,
              batch_.curvature_radius_i(k),
              batch_.curvature_radius_j(k),
              -1,
              -1};
    });
  }

  void publish(const Counts& counts) {
    const double touching = counts.tested - counts.apart;
    counts_.values[ContactCounts::tested] += counts.tested;
    counts_.values[ContactCounts::newton_steps] += counts.tested + counts.more_steps;
    counts_.values[ContactCounts::touching_pairs] += touching;
    counts_.values[ContactCounts::contacts] += touching;
    counts_.values[ContactCounts::not_converged] += counts.not_converged;
  }

  /// What a search says of a pair, besides the place of the contact.
  struct Finding {
    ellipsoid::Vector3 normal;
    double steps;
    bool apart, converged;
  };

  struct PairAtHand {
    int i, j;
    int* flag;
    double* history;
    bool touched = true; ///< in the last step
  };

  ellipsoid::ContactBatch batch_;
  PairAtHand waiting_[ellipsoid::ContactBatch::capacity];

  /// Counts the pair, remembers its normal, forgets the contact where there is none.
  __attribute__((always_inline)) bool touches(const PairAtHand& pair, const Finding& finding,
                                              Counts& counts) {
    const double share = this->share(pair.j);
    counts.tested += share;
    if (finding.steps != 1.0)
      counts.more_steps += share * (finding.steps - 1.0);
    if (!this->is_set_up())
      ellipsoid_host::store(-finding.normal, &pair.history[normal_x]);
    if (finding.apart) {
      counts.apart += share;
      forget(pair.i, pair.j, *pair.flag, pair.history);
      return false;
    }
    if (!finding.converged)
      counts.not_converged += share;
    return true;
  }

  void treat_result(const PairAtHand& pair, const ellipsoid::ContactGeometry& geometry,
                    Counts& counts) {
    using Status = ellipsoid::ContactStatus;
    if (!touches(pair,
                 {geometry.normal, static_cast<double>(geometry.iterations),
                  geometry.status == Status::separated, geometry.status != Status::not_converged},
                 counts))
      return;
    treat_contact(pair, geometry);
  }

  void forget(int i, int j, int& flag, double* history) {
    if (!flag && history[was_touching] == 0.0)
      return;
    this->forget_contact(i, j, flag, history);
    history[was_touching] = 0.0;
    flag = 0;
  }

  void treat_contact(const PairAtHand& pair, const ellipsoid::ContactGeometry& geometry) {
    const typename Base::TouchingPair touching{pair.i, pair.j, pair.flag,
                                               this->centre_distance(pair.i, pair.j),
                                               pair.touched && flags_are_set_};
    if (!touching.is_flagged)
      *pair.flag |= CONTACT_SURFACE_MODEL;
    if (!this->is_set_up() && !pair.touched)
      pair.history[was_touching] = 1.0;
    this->add_contact(touching,
                      {geometry.normal, geometry.point, geometry.overlap, geometry.reduced_radius,
                       geometry.curvature_radius_i, geometry.curvature_radius_j, pair.history});
  }
};

} // namespace LIGGGHTS

#endif
