// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Contacts of multi-sphere ellipsoids: every touching pair of sub-spheres is a contact of its own
// (Markauskas et al. 2010, section 3.4).
//
// The history of a pair is a row of equal slots, one per contact. A slot starts with its key: the sum
// of the two sphere numbers + 1 (0: free) and their difference, which changes sign when the pair is
// seen from j; the values of the contact models follow.
#ifndef MULTISPHERE_CONTACT_LOOP_H_
#define MULTISPHERE_CONTACT_LOOP_H_

#include "ellipsoid_contact_loop.h"
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

  ellipsoid_host::MultisphereParticles particles_;
  std::vector<ellipsoid::SphereContact> found_;
  std::vector<int> slot_of_; // per contact found
  std::vector<char> taken_;  // per slot
  int slot_values_ = 0, slots_ = 0;
  ellipsoid::MulticontactRule rule_ = ellipsoid::MulticontactRule::sum;

  void prepare() { particles_.update(); }
  void finish() {}

  double treat_pair(int i, int j, int& flag, double* history) {
    const ellipsoid::Vector3 distance = this->centre_distance(i, j);
    double gap = this->bounding_gap(i, j, distance);
    found_.clear();
    if (gap == 0.0) {
      const ellipsoid::ContactCount count =
          find_contacts(particles_.pose(i), particles_.pose(j), distance, found_);
      counts_.values[ContactCounts::tested] += this->share(j) * count.tested;
      if (found_.empty())
        gap = smallest_gap(particles_.pose(i), particles_.pose(j), distance);
    }
    if (found_.empty() && !flag)
      return gap;
    assign_slots(i, j, flag, history);
    flag = 0;
    if (found_.empty())
      return gap;
    counts_.values[ContactCounts::touching_pairs] += this->share(j);
    counts_.values[ContactCounts::contacts] +=
        this->share(j) * static_cast<double>(found_.size());
    flag = CONTACT_SURFACE_MODEL;
    const SurfacesIntersectData pair = this->pair_record(i, j, distance, flag);
    const double weight = multicontact_weight(rule_, static_cast<int>(found_.size()));
    for (std::size_t k = 0; k < found_.size(); ++k) {
      const ellipsoid::SphereContact& c = found_[k];
      SurfacesIntersectData record = pair;
      this->fill_contact(record, c.normal, c.point, c.overlap, c.reduced_radius, c.radius_i,
                         c.radius_j, &history[slot_values_ * slot_of_[k]]);
      pair_->set_spheres(c.sphere_i, c.sphere_j, weight);
      this->apply_contact(record, weight);
    }
    return 0.0;
  }

  /// Known contacts keep their slots, contacts that ended leave theirs, new ones get free slots.
  void assign_slots(int i, int j, int& flag, double* history) {
    taken_.assign(static_cast<std::size_t>(slots_), 0);
    slot_of_.assign(found_.size(), -1);
    for (std::size_t k = 0; k < found_.size(); ++k) {
      slot_of_[k] = slot_with(found_[k], history);
      if (slot_of_[k] >= 0)
        taken_[static_cast<std::size_t>(slot_of_[k])] = 1;
    }
    for (int s = 0; s < slots_; ++s) {
      double* slot = &history[slot_values_ * s];
      if (taken_[static_cast<std::size_t>(s)] || slot[key_sum] == 0.0)
        continue;
      this->forget_contact(i, j, flag, slot);
      std::fill_n(slot, slot_values_, 0.0);
    }
    int free_slot = 0;
    for (std::size_t k = 0; k < found_.size(); ++k) {
      if (slot_of_[k] >= 0)
        continue;
      while (free_slot < slots_ && taken_[static_cast<std::size_t>(free_slot)])
        ++free_slot;
      if (free_slot == slots_)
        complain_of_slots(i, j);
      taken_[static_cast<std::size_t>(free_slot)] = 1;
      slot_of_[k] = free_slot;
      double* slot = &history[slot_values_ * free_slot];
      slot[key_sum] = found_[k].sphere_i + found_[k].sphere_j + 1;
      slot[key_difference] = found_[k].sphere_i - found_[k].sphere_j;
    }
  }

  int slot_with(const ellipsoid::SphereContact& c, const double* history) const {
    for (int s = 0; s < slots_; ++s) {
      const double* slot = &history[slot_values_ * s];
      if (slot[key_sum] == c.sphere_i + c.sphere_j + 1 &&
          slot[key_difference] == c.sphere_i - c.sphere_j)
        return s;
    }
    return -1;
  }

  void complain_of_slots(int i, int j) {
    error->one(FLERR, ("pair_style gran/ellipsoid: atoms " + std::to_string(atom->tag[i]) +
                       " and " + std::to_string(atom->tag[j]) + " touch at " +
                       std::to_string(found_.size()) + " places, setting 'contacts' allows " +
                       std::to_string(slots_) + "; raise it")
                          .c_str());
  }
};

} // namespace LIGGGHTS

#endif
