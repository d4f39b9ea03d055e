// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere_contacts.h"

#include "atom.h"
#include "contact_model_constants.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "model_settings.h"
#include "pair_gran_ellipsoid.h"
#include "surface_settings.h"
#include "vectorised/prefetch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace ellipsoid_host {

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

MultisphereContacts::MultisphereContacts(LAMMPS* lmp, PairGranEllipsoid& pair)
    : SurfaceContacts(lmp, pair), chains_(lmp) {
  pair_.add_history_value("spheres", "0");
  pair_.add_history_value("sphere_difference", "1");
}

void MultisphereContacts::read_settings(const ModelSettings& settings) {
  slot_values_ = pair_.dnum_pair();
  slots_ = LIGGGHTS::ContactModels::ContactsSetting::in(settings);
  rule_ = LIGGGHTS::ContactModels::MulticontactSetting::in(settings);
  pair_.repeat_history(slots_);
}

/// 0: the pair has no history.
inline int MultisphereContacts::slots(const NearPair& pair) const {
  if (!pair.history)
    return 0;
  return slots_ + static_cast<int>(pair_.more_history().size(pair.index)) / slot_values_;
}

inline double* MultisphereContacts::slot(const NearPair& pair, int number) const {
  if (number < slots_)
    return &pair.history[slot_values_ * number];
  return pair_.more_history().at(pair.index,
                                 static_cast<std::size_t>(slot_values_ * (number - slots_)));
}

ContactCounts MultisphereContacts::compute(PairForces& forces, bool is_time_step) {
  counts_ = ContactCounts();
  particles_ = ParticleArrays(*atom);
  begin_pairs();
  if (!is_time_step)
    clocks().forget();
  if (chains_.update()) {
    begin_lists();
    pairs_.for_each([this, &forces](std::uint32_t index, int i, int j) {
      NearPair pair = pairs_.pair(index, i, j);
      if (update_contacts(pair, forces))
        pairs_.activate(pair);
    });
  } else {
    pairs_.end_due_deferrals(
        clocks(),
        [this](std::uint32_t index, int i, int j) { pairs_.activate(pairs_.pair(index, i, j)); },
        [] {});
    const auto prefetch = [this](const NearPair& pair) {
      near_spheres_.prefetch_pair(pair.index);
      ellipsoid::prefetch_to_write(pair.flag);
      pairs_.prefetch_history(pair);
      for (const int k : {pair.i, pair.j}) {
        ellipsoid::prefetch(&chains_.pose(k));
        ellipsoid::prefetch(particles_.x[k]);
        ellipsoid::prefetch(particles_.v[k]);
        ellipsoid::prefetch(particles_.omega[k]);
      }
    };
    const auto prefetch_more = [this](const NearPair& pair) {
      near_spheres_.prefetch_spheres(pair.index);
    };
    pairs_.for_each_active(prefetch, prefetch_more, [this, &forces](NearPair& pair) {
      return update_contacts(pair, forces);
    });
  }
  forces.apply_added();
  counts_.values[ContactCounts::listed_pairs] = listed_pairs_;
  counts_.values[ContactCounts::near_pairs] = near_pairs_;
  return counts_;
}

void MultisphereContacts::begin_lists() {
  listed_pairs_ = near_pairs_ = 0.0;
  pairs_.restart(neighbor->skin, clocks(),
                 [this](const NeighbourPairs::Candidate* candidates, int count, bool* keep) {
                   std::fill_n(keep, count, true);
                   for (int k = 0; k < count; ++k)
                     listed_pairs_ += share(candidates[k].j);
                 });
  near_pairs_ = listed_pairs_;
  near_spheres_.restart(pairs_.size());
}

/// @return whether there are spheres to test in the next step; the next check is deferred if not
bool MultisphereContacts::update_contacts(NearPair& pair, PairForces& forces) {
  const Vector3 distance = vector(particles_.x[pair.j]) - vector(particles_.x[pair.i]);
  if (near_spheres_.is_due(pair.index, clocks().time(pair.i), clocks().time(pair.j)) &&
      !search(pair, distance, forces))
    return false;
  find_touching(pair, distance);
  update_slots(pair, forces);
  pair.touched = found_ > 0;
  if (found_ > 0)
    add_contacts(pair, distance, forces);
  return true;
}

/// Finds the spheres that have to be tested in the next steps.
/// @return whether there are any
bool MultisphereContacts::search(NearPair& pair, const Vector3& distance, PairForces& forces) {
  const int i = pair.i, j = pair.j;
  const double approach = clocks().approach(i, j);
  const ellipsoid::NearSpheres::Search result = near_spheres_.search(
      pair.index, chains_.pose(i), chains_.pose(j), distance, search_gap(i, j, approach));
  counts_.values[ContactCounts::tested] += share(j) * result.tested;
  if (*pair.flag)
    recall_slots(pair, forces);
  if (near_spheres_.is_empty(pair.index)) {
    *pair.flag = 0;
    pairs_.end_history(pair);
    pairs_.defer(pair.index, i, result.gap, approach, clocks());
    return false;
  }
  near_spheres_.set_deadlines(pair.index, clocks().deadlines(i, j, result.gap, approach));
  return true;
}

double MultisphereContacts::search_gap(int i, int j, double approach) {
  const double radii = atom->shape[i][1] + atom->shape[j][1];
  const int spheres = std::max(chains_.pose(i).body->count(), chains_.pose(j).body->count());
  const double steps = std::min(steps_ahead, steps_ahead_of_chain / spheres);
  return std::clamp(clocks().gap_for(steps, i, j, approach), smallest_gap_share * radii,
                    largest_gap_share * radii);
}

void MultisphereContacts::find_touching(const NearPair& pair, const Vector3& distance) {
  const auto tested =
      static_cast<std::size_t>(near_spheres_.end(pair.index) - near_spheres_.begin(pair.index));
  if (touching_.size() < tested)
    touching_.resize(2 * tested);
  found_ = near_spheres_.find_touching(pair.index, chains_.pose(pair.i), chains_.pose(pair.j),
                                       distance, touching_.data());
  counts_.values[ContactCounts::tested] += share(pair.j) * static_cast<double>(tested);
}

void MultisphereContacts::add_contacts(const NearPair& pair, const Vector3& distance,
                                       PairForces& forces) {
  counts_.values[ContactCounts::touching_pairs] += share(pair.j);
  counts_.values[ContactCounts::contacts] += share(pair.j) * found_;
  *pair.flag = LIGGGHTS::ContactModels::CONTACT_SURFACE_MODEL;
  const double weight = multicontact_weight(rule_, found_);
  for (int k = 0; k < found_; ++k) {
    const ellipsoid::NearSpheres::Touching& touching = touching_[static_cast<std::size_t>(k)];
    const ellipsoid::SphereContact& c = touching.contact;
    forces.add({pair.i, pair.j, pair.flag, slot(pair, touching.spheres->slot), weight, c.sphere_i,
                c.sphere_j},
               {-c.normal, c.point, c.point - distance, std::max(0.0, c.overlap), c.reduced_radius,
                c.radius_i, c.radius_j});
  }
}

/// After a search: which of its spheres have a slot from before. Contacts of other spheres are
/// over.
void MultisphereContacts::recall_slots(const NearPair& pair, PairForces& forces) {
  SpherePair *begin = near_spheres_.begin(pair.index), *end = near_spheres_.end(pair.index);
  for (int s = 0; s < slots(pair); ++s) {
    const double* slot = this->slot(pair, s);
    if (slot[key_sum] == 0.0)
      continue;
    SpherePair* found = std::find_if(begin, end, [slot](const SpherePair& candidate) {
      return slot[key_sum] == candidate.sphere_i + candidate.sphere_j + 1 &&
             slot[key_difference] == candidate.sphere_i - candidate.sphere_j;
    });
    if (found != end)
      found->slot = static_cast<short>(s);
    else
      close_slot(pair, s, forces);
  }
}

/// Known contacts keep their slots, contacts that ended leave theirs, new ones get free slots.
void MultisphereContacts::update_slots(NearPair& pair, PairForces& forces) {
  const auto *touching = touching_.data(), *last = touching + found_;
  for (SpherePair *s = near_spheres_.begin(pair.index), *end = near_spheres_.end(pair.index);
       s != end; ++s) {
    if (touching != last && touching->spheres == s) {
      ++touching;
    } else if (s->slot >= 0) {
      close_slot(pair, s->slot, forces);
      s->slot = -1;
    }
  }
  *pair.flag = 0;
  if (found_ == 0)
    return pairs_.end_history(pair);
  if (!pair.history)
    pairs_.begin_history(pair);
  int free_slot = 0;
  for (touching = touching_.data(); touching != last; ++touching) {
    SpherePair* s = touching->spheres;
    if (s->slot >= 0)
      continue;
    free_slot = find_free_slot(pair, free_slot);
    s->slot = static_cast<short>(free_slot);
    double* slot = this->slot(pair, free_slot);
    slot[key_sum] = s->sphere_i + s->sphere_j + 1;
    slot[key_difference] = s->sphere_i - s->sphere_j;
  }
}

/// Not before `first`; a pair whose slots are full gets another one.
int MultisphereContacts::find_free_slot(const NearPair& pair, int first) {
  int free = first;
  while (free < slots(pair) && slot(pair, free)[key_sum] != 0.0)
    ++free;
  if (free > largest_slot)
    complain_of_slots(pair);
  if (free == slots(pair))
    pair_.more_history().grow(pair.index, slot_values_);
  return free;
}

void MultisphereContacts::close_slot(const NearPair& pair, int number, PairForces& forces) {
  double* slot = this->slot(pair, number);
  forces.close(pair.i, pair.j, pair.flag, slot);
  std::fill_n(slot, slot_values_, 0.0);
}

void MultisphereContacts::complain_of_slots(const NearPair& pair) const {
  error->one(FLERR,
             ("pair_style gran/ellipsoid: atoms " + std::to_string(atom->tag[pair.i]) + " and " +
              std::to_string(atom->tag[pair.j]) + " touch at " + std::to_string(found_) +
              " places, no more than " + std::to_string(largest_slot + 1) +
              " contacts of one pair can be kept; use fewer sub-spheres")
                 .c_str());
  std::abort(); // not reached: the call above ends the program
}

} // namespace ellipsoid_host
