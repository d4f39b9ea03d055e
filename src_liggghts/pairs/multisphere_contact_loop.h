// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of multi-sphere ellipsoids: every touching pair of sub-spheres is a contact of its own
// (Markauskas et al. 2010, section 3.4).
//
// The history of a pair is a row of equal slots, one per contact. A slot starts with its key: the
// sum of the two sphere numbers + 1 (0: free) and their difference, which changes sign when the
// pair is seen from j; the values of the contact models follow.
#ifndef MULTISPHERE_CONTACT_LOOP_H_
#define MULTISPHERE_CONTACT_LOOP_H_

#include "ellipsoid_contact_loop.h"
#include "multisphere/multisphere_watch.h"
#include "multisphere_particles.h"

namespace LIGGGHTS {

template <typename Model>
class MultisphereContactLoop : public EllipsoidContactLoop<MultisphereContactLoop<Model>, Model> {
  using Base = EllipsoidContactLoop<MultisphereContactLoop<Model>, Model>;
  friend Base;
  using Base::atom;
  using Base::contact_;
  using Base::counts_;
  using Base::error;
  using Base::model_;
  using Base::pair_;

 public:
  MultisphereContactLoop(LAMMPS* lmp, PairGranEllipsoid* pair, int64_t hash)
      : Base(lmp, pair, hash, {{"spheres", false}, {"sphere_difference", true}}), particles_(lmp) {}

  void settings(int narg, char** arg, IContactHistorySetup* setup) override {
    Base::settings(narg, arg, setup);
    slot_values_ = pair_->dnum_pair();
    slots_ = model_.get_history_offset("contacts");
    rule_ = model_.get_history_offset("multicontact") ? ellipsoid::MulticontactRule::average
                                                      : ellipsoid::MulticontactRule::sum;
    pair_->repeat_history(slots_);
  }

 private:
  enum { key_sum, key_difference }; // offsets in a slot
  static constexpr bool asks_flags = true;
  using SpherePair = ellipsoid::ContactWatch::SpherePair;

  /// A search finds the spheres that may touch within so many time steps if motions change as
  /// usual; within fewer steps for fine chains, where a gap has the more spheres the wider it is.
  /// It is no nearer nor farther than these shares of both radii of the bodies' middles.
  static constexpr double look_ahead = 50.0, look_ahead_of_chain = 500.0;
  static constexpr double smallest_gap_share = 1e-3, largest_gap_share = 0.1;

  ellipsoid_host::MultisphereParticles particles_;
  ellipsoid::ContactWatch watch_;
  std::vector<ellipsoid::ContactWatch::Touching> touching_; // room for all spheres of a pair
  int found_ = 0;                                           // touching spheres of the pair at hand
  int slot_values_ = 0, slots_ = 0;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;

  /// Whether the neighbour lists are new.
  bool prepare() { return particles_.update(); }
  void begin_lists(std::size_t pairs) { watch_.restart(pairs); }
  __attribute__((always_inline)) void prefetch_particle(int i) const {
    __builtin_prefetch(&particles_.pose(i));
    __builtin_prefetch(Base::particles_.x[i]);
    __builtin_prefetch(Base::particles_.v[i]);
    __builtin_prefetch(Base::particles_.omega[i]);
  }
  ellipsoid::MotionClocks& clocks() { return particles_.clocks(); }
  void treat_new_lists() { this->treat_all_pairs(); }
  void look_at_woken(const std::vector<typename Base::ListPair>& pairs) {
    for (const typename Base::ListPair& pair : pairs)
      this->stay_awake(pair);
  }
  void finish() {}

  bool treat_pair(const typename Base::ListPair& pair, int& flag, double* history) {
    const int i = pair.i, j = pair.j;
    const ellipsoid::Vector3 distance = this->centre_distance(i, j);
    if (watch_.is_due(pair.place, clocks().time(i), clocks().time(j)) &&
        !search(pair, distance, flag, history))
      return false;
    find_touching(i, j, pair.place, distance);
    update_slots(i, j, pair.place, flag, history);
    if (found_ > 0)
      treat_contacts(i, j, distance, flag, history);
    return true;
  }

  /// Returns whether there are spheres to test; the pair sleeps if not.
  bool search(const typename Base::ListPair& pair, const ellipsoid::Vector3& distance, int& flag,
              double* history) {
    const int i = pair.i, j = pair.j;
    const double approach = clocks().approach(i, j);
    const ellipsoid::ContactWatch::Search result = watch_.search(
        pair.place, particles_.pose(i), particles_.pose(j), distance, search_gap(i, j, approach));
    counts_.values[ContactCounts::tested] += this->share(j) * result.tested;
    if (flag)
      recall_slots(i, j, pair.place, flag, history);
    if (watch_.is_empty(pair.place)) {
      flag = 0;
      this->put_to_sleep(pair, result.gap, approach);
      return false;
    }
    watch_.set_deadlines(pair.place, clocks().deadlines(i, j, result.gap, approach));
    return true;
  }

  double search_gap(int i, int j, double approach) {
    const double radii = atom->shape[i][1] + atom->shape[j][1];
    const int spheres =
        std::max(particles_.pose(i).chain->count(), particles_.pose(j).chain->count());
    const double steps = std::min(look_ahead, look_ahead_of_chain / spheres);
    return std::clamp(clocks().gap_for(steps, i, j, approach), smallest_gap_share * radii,
                      largest_gap_share * radii);
  }

  void find_touching(int i, int j, std::size_t pair, const ellipsoid::Vector3& distance) {
    const auto tested = static_cast<std::size_t>(watch_.end(pair) - watch_.begin(pair));
    if (touching_.size() < tested)
      touching_.resize(2 * tested);
    found_ = watch_.find_touching(pair, particles_.pose(i), particles_.pose(j), distance,
                                  touching_.data());
    counts_.values[ContactCounts::tested] += this->share(j) * static_cast<double>(tested);
  }

  void treat_contacts(int i, int j, const ellipsoid::Vector3& distance, int& flag,
                      double* history) {
    counts_.values[ContactCounts::touching_pairs] += this->share(j);
    counts_.values[ContactCounts::contacts] += this->share(j) * found_;
    flag = CONTACT_SURFACE_MODEL;
    const typename Base::TouchingPair pair{i, j, &flag, distance};
    const double weight = multicontact_weight(rule_, found_);
    for (int k = 0; k < found_; ++k) {
      const ellipsoid::SphereContact& c = touching_[static_cast<std::size_t>(k)].contact;
      double* slot = &history[slot_values_ * touching_[static_cast<std::size_t>(k)].spheres->slot];
      this->add_contact(pair, {c.normal, c.point, c.overlap, c.reduced_radius, c.radius_i,
                               c.radius_j, slot, weight, c.sphere_i, c.sphere_j});
    }
  }

  /// After a search: which of its spheres have a slot from before. Contacts of other spheres are
  /// over.
  void recall_slots(int i, int j, std::size_t pair, int& flag, double* history) {
    for (int s = 0; s < slots_; ++s) {
      double* slot = &history[slot_values_ * s];
      if (slot[key_sum] == 0.0)
        continue;
      SpherePair* found =
          std::find_if(watch_.begin(pair), watch_.end(pair), [slot](const SpherePair& candidate) {
            return slot[key_sum] == candidate.sphere_i + candidate.sphere_j + 1 &&
                   slot[key_difference] == candidate.sphere_i - candidate.sphere_j;
          });
      if (found != watch_.end(pair))
        found->slot = static_cast<short>(s);
      else
        clear_slot(i, j, flag, slot);
    }
  }

  /// Known contacts keep their slots, contacts that ended leave theirs, new ones get free slots.
  void update_slots(int i, int j, std::size_t pair, int& flag, double* history) {
    const auto *touching = touching_.data(), *last = touching + found_;
    for (SpherePair *s = watch_.begin(pair), *end = watch_.end(pair); s != end; ++s) {
      if (touching != last && touching->spheres == s) {
        ++touching;
      } else if (s->slot >= 0) {
        clear_slot(i, j, flag, &history[slot_values_ * s->slot]);
        s->slot = -1;
      }
    }
    flag = 0;
    int free_slot = 0;
    for (touching = touching_.data(); touching != last; ++touching) {
      SpherePair* s = touching->spheres;
      if (s->slot >= 0)
        continue;
      while (free_slot < slots_ && history[slot_values_ * free_slot + key_sum] != 0.0)
        ++free_slot;
      if (free_slot == slots_)
        complain_of_slots(i, j);
      s->slot = static_cast<short>(free_slot);
      double* slot = &history[slot_values_ * free_slot];
      slot[key_sum] = s->sphere_i + s->sphere_j + 1;
      slot[key_difference] = s->sphere_i - s->sphere_j;
    }
  }

  void clear_slot(int i, int j, int& flag, double* slot) {
    this->forget_contact(i, j, flag, slot);
    std::fill_n(slot, slot_values_, 0.0);
  }

  void complain_of_slots(int i, int j) {
    error->one(FLERR,
               ("pair_style gran/ellipsoid: atoms " + std::to_string(atom->tag[i]) + " and " +
                std::to_string(atom->tag[j]) + " touch at " + std::to_string(found_) +
                " places, setting 'contacts' allows " + std::to_string(slots_) + "; raise it")
                   .c_str());
  }
};

} // namespace LIGGGHTS

#endif
