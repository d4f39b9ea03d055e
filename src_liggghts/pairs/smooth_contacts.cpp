// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "smooth_contacts.h"

#include "atom.h"
#include "contact_model_constants.h"
#include "ellipsoid_host.h"
#include "neighbor.h"
#include "pair_gran_ellipsoid.h"
#include "update.h"
#include "vectorised/prefetch.h"

#include <cmath>

namespace ellipsoid_host {

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

SmoothContacts::SmoothContacts(LAMMPS* lmp, PairGranEllipsoid& pair) : SurfaceContacts(lmp, pair) {
  for (const char* component : {"normalx", "normaly", "normalz"})
    pair_.add_history_value(component, "1");
  pair_.add_history_value("touching", "0");
  for (Contact& contact : in_search_) {
    contact.weight = 1.0;
    contact.sphere_i = contact.sphere_j = -1;
  }
}

ContactCounts SmoothContacts::compute(PairForces& forces, bool is_time_step) {
  counts_ = ContactCounts();
  particles_ = ParticleArrays(*atom);
  is_time_step_ = is_time_step;
  begin_pairs();
  if (!is_time_step)
    motions_.clocks().forget();
  const bool new_lists = motions_.update(*atom, update->dt, neighbor->ago == 0);
  const bool new_pairs = new_lists || motions_.clocks().a_margin_is_used_up();
  shapes_.begin_step(*atom, new_pairs);
  flags_are_set_ = !new_lists;
  if (new_pairs) {
    choose_pairs();
    check_new_pairs(forces);
  } else {
    check_due_pairs(forces);
  }
  search_active_pairs(forces);
  counts_.values[ContactCounts::listed_pairs] = listed_pairs_;
  counts_.values[ContactCounts::near_pairs] = near_pairs_;
  return counts_;
}

ellipsoid::BodyBounds SmoothContacts::bounds(int i) {
  return ellipsoid::bounds_of_ellipsoid(vector(atom->shape[i]));
}

void SmoothContacts::choose_pairs() {
  listed_pairs_ = near_pairs_ = 0.0;
  normals_.clear();
  pairs_.restart(neighbor->skin, motions_.clocks(),
                 [this](const NeighbourPairs::Candidate* candidates, int count, bool* keep) {
                   choose(candidates, count, keep);
                 });
  pairs_.for_each([this](std::uint32_t, int, int j) { near_pairs_ += share(j); });
}

/// Flagged pairs are kept wherever they are: a contact that is over has to be closed.
__attribute__((noinline)) void SmoothContacts::choose(const NeighbourPairs::Candidate* candidates,
                                                      int count, bool* keep) {
  int asked[NeighbourPairs::candidates_together];
  Vector3 normals[NeighbourPairs::candidates_together];
  first_gaps_.clear();
  for (int k = 0; k < count; ++k) {
    const NeighbourPairs::Candidate& pair = candidates[k];
    listed_pairs_ += share(pair.j);
    const Vector3 distance = centre_distance(pair.i, pair.j);
    keep[k] = pairs_.is_flagged(pair);
    if (keep[k] || bounding_gap(pair.i, pair.j, distance) > margins(pair.i, pair.j))
      continue;
    asked[first_gaps_.size()] = k;
    first_gaps_.add(shapes_[pair.i], shapes_[pair.j], distance);
  }
  if (first_gaps_.size() > 0)
    first_gaps_.find();
  for (int k = 0; k < first_gaps_.size(); ++k) {
    const NeighbourPairs::Candidate& pair = candidates[asked[k]];
    keep[asked[k]] = !(first_gaps_.gap(k) > margins(pair.i, pair.j));
    normals[asked[k]] = first_gaps_.normal(k);
  }
  for (int k = 0; k < count; ++k)
    if (keep[k])
      normals_.push_back(normals[k]);
}

Vector3 SmoothContacts::centre_distance(int i, int j) const {
  return vector(particles_.x[j]) - vector(particles_.x[i]);
}

/// Gap between the bounding spheres, 0 if they overlap.
double SmoothContacts::bounding_gap(int i, int j, const Vector3& distance) const {
  const double reach = particles_.radius[i] + particles_.radius[j],
               squared = dot(distance, distance);
  return squared < reach * reach ? 0.0 : std::sqrt(squared) - reach;
}

/// @param[in] normal unit, from i to j, along which the gap is measured
void SmoothContacts::defer(const NearPair& pair, double gap, const Vector3& normal) {
  pairs_.defer(pair.index, pair.i, gap, motions_.clocks().approach(pair.i, pair.j, normal),
               motions_.clocks());
}

/// For a pair that is apart. It may have touched when the run was set up, of which no more than the
/// host's flag is left.
void SmoothContacts::close_and_defer(NearPair& pair, double gap, const Vector3& normal,
                                     PairForces& forces) {
  if (pair.history) {
    close({pair.i, pair.j, pair.flag, pair.history, 1.0, -1, -1}, forces);
    pairs_.end_history(pair);
  }
  defer(pair, gap, normal);
}

/// Unit, from i to j, or zero.
Vector3 SmoothContacts::last_normal(const NearPair& pair) const {
  return pair.history ? -vector(&pair.history[normal_x]) : normals_[pair.index];
}

void SmoothContacts::remember_normal(const NearPair& pair, const Vector3& normal) {
  if (is_time_step_)
    normals_[pair.index] = normal;
}

/// Pairs that touched in the last step are active, of the others those for which no gap is found.
void SmoothContacts::check_new_pairs(PairForces& forces) {
  to_check_.clear();
  pairs_.for_each([this, &forces](std::uint32_t index, int i, int j) {
    const NearPair pair = pairs_.pair(index, i, j);
    if (pair.history && pair.history[was_touching] != 0.0) {
      pairs_.activate(pair);
      return;
    }
    to_check_.push_back(pair);
    if (to_check_.size() == checked_together)
      check_gaps(forces);
  });
  check_gaps(forces);
}

void SmoothContacts::check_due_pairs(PairForces& forces) {
  to_check_.clear();
  pairs_.end_due_deferrals(
      motions_.clocks(),
      [this](std::uint32_t index, int i, int j) { to_check_.push_back(pairs_.pair(index, i, j)); },
      [this, &forces] {
        if (to_check_.size() >= checked_together)
          check_gaps(forces);
      });
  check_gaps(forces);
}

/// Most pairs to check are still apart: one Newton step from the normal that separated them tells
/// how far.
__attribute__((noinline)) void SmoothContacts::check_gaps(PairForces& forces) {
  for (NearPair& pair : to_check_) {
    const Vector3 distance = centre_distance(pair.i, pair.j);
    const double gap = bounding_gap(pair.i, pair.j, distance);
    if (gap > 0.0) {
      close_and_defer(pair, gap, normalized(distance), forces);
      continue;
    }
    const Vector3 remembered = last_normal(pair);
    const bool has_normal = dot(remembered, remembered) > 0.5; // unit vector, or zero
    in_check_[batch_.size()] = pair;
    batch_.add(shapes_[pair.i], shapes_[pair.j], distance,
               has_normal ? remembered : normalized(distance));
    if (batch_.full())
      find_gaps(forces);
  }
  find_gaps(forces);
  to_check_.clear();
}

void SmoothContacts::find_gaps(PairForces& forces) {
  batch_.find_gaps();
  for (int k = 0; k < batch_.size(); ++k) {
    NearPair& pair = in_check_[k];
    const double gap = batch_.gap(k), share = this->share(pair.j);
    counts_.values[ContactCounts::tested] += share;
    counts_.values[ContactCounts::newton_steps] += share;
    if (!(gap > 0.0)) {
      pairs_.activate(pair);
      continue;
    }
    remember_normal(pair, batch_.normal(k));
    close_and_defer(pair, gap, batch_.normal(k), forces);
  }
  batch_.clear();
}

/// A pair that touched starts from its last normal, together with others.
void SmoothContacts::search_active_pairs(PairForces& forces) {
  const auto prefetch = [this](const NearPair& pair) {
    pairs_.prefetch_history(pair);
    ellipsoid::prefetch_to_write(shapes_.address(pair.j));
    ellipsoid::prefetch(particles_.x[pair.j]);
    ellipsoid::prefetch(particles_.v[pair.j]);
    ellipsoid::prefetch(particles_.omega[pair.j]);
  };
  pairs_.for_each_active(
      prefetch, [](const NearPair&) {},
      [this, &forces](NearPair& pair) {
        if (!pair.history || pair.history[was_touching] == 0.0) {
          const bool stays_active = search_alone(pair, forces);
          pair.touched = true;
          return stays_active;
        }
        pair.touched = true;
        Contact& contact = in_search_[batch_.size()]; // number by number: see contact_batch.h
        contact.i = pair.i;
        contact.j = pair.j;
        contact.flag = pair.flag;
        contact.history = pair.history;
        batch_.add(shapes_[pair.i], shapes_[pair.j], centre_distance(pair.i, pair.j),
                   -vector(&pair.history[normal_x]));
        if (batch_.full())
          search_together(forces);
        return true;
      });
  search_together(forces);
  forces.apply_added();
}

/// The pairs in the batch, in the order in which they came.
__attribute__((noinline)) void SmoothContacts::search_together(PairForces& forces) {
  batch_.solve();
  batch_.solve_unsolved();
  SearchCounts counts; // here, to live in registers
  for (int k = 0; k < batch_.size(); ++k) {
    Contact& contact = in_search_[k];
    record_search(contact,
                  {batch_.normal(k), batch_.steps(k), batch_.is_apart(k), batch_.has_converged(k)},
                  counts);
    if (batch_.is_apart(k)) {
      close(contact, forces);
      contact.history = nullptr;
    } else if (!flags_are_set_) {
      *contact.flag |= LIGGGHTS::ContactModels::CONTACT_SURFACE_MODEL;
    }
  }
  forces.apply_found(batch_, in_search_, flags_are_set_);
  count(counts);
  batch_.clear();
}

/// Defers the next check of a pair that its bounding spheres, or the last normal, show to be apart.
/// @return whether they do
bool SmoothContacts::defer_without_search(NearPair& pair, const Vector3& distance,
                                          PairForces& forces) {
  const double bounding_gap = this->bounding_gap(pair.i, pair.j, distance);
  if (bounding_gap > 0.0) {
    close_and_defer(pair, bounding_gap, normalized(distance), forces);
    return true;
  }
  const Vector3 remembered = last_normal(pair);
  if (dot(remembered, remembered) < 0.5) // unit vector, or zero
    return false;
  const double gap = -overlap_along(shapes_[pair.i], shapes_[pair.j], distance, remembered);
  if (!(gap > 0.0))
    return false;
  close_and_defer(pair, gap, remembered, forces);
  return true;
}

/// Pairs that did not touch start from scratch: a new contact does not depend on what happened
/// before it, nor on whether the run was interrupted.
/// @return whether the pair touches; its next check is deferred if not
__attribute__((noinline)) bool SmoothContacts::search_alone(NearPair& pair, PairForces& forces) {
  const Vector3 distance = centre_distance(pair.i, pair.j);
  if (defer_without_search(pair, distance, forces))
    return false;
  if (!pair.history)
    pairs_.begin_history(pair);
  const Contact contact{pair.i, pair.j, pair.flag, pair.history, 1.0, -1, -1};
  ellipsoid::SearchOptions options;
  options.goal = ellipsoid::SearchGoal::distance; // the farther apart, the later the next check
  const ellipsoid::ContactGeometry found =
      find_contact(shapes_[pair.i], shapes_[pair.j], distance, options);
  const bool is_apart = found.status == ellipsoid::ContactStatus::separated;
  SearchCounts counts;
  record_search(contact,
                {found.normal, static_cast<double>(found.iterations), is_apart,
                 ellipsoid::has_converged(found.status)},
                counts);
  count(counts);
  if (is_apart) {
    close(contact, forces);
    remember_normal(pair, found.normal);
    pairs_.end_history(pair);
    defer(pair, -found.overlap, found.normal);
    return false;
  }
  *pair.flag |= LIGGGHTS::ContactModels::CONTACT_SURFACE_MODEL;
  if (is_time_step_)
    pair.history[was_touching] = 1.0;
  forces.add(contact,
             {-found.normal, found.point, found.point - distance, std::fmax(0.0, found.overlap),
              found.reduced_radius, found.curvature_radius_i, found.curvature_radius_j});
  return true;
}

/// Counts the pair and remembers its normal.
inline void SmoothContacts::record_search(const Contact& pair, const Finding& finding,
                                          SearchCounts& counts) const {
  const double share = this->share(pair.j);
  counts.tested += share;
  if (finding.steps != 1.0)
    counts.more_steps += share * (finding.steps - 1.0);
  if (is_time_step_)
    store(-finding.normal, &pair.history[normal_x]);
  if (finding.is_apart)
    counts.apart += share;
  else if (!finding.has_converged)
    counts.not_converged += share;
}

void SmoothContacts::close(const Contact& pair, PairForces& forces) const {
  if (!*pair.flag && pair.history[was_touching] == 0.0)
    return;
  forces.close(pair.i, pair.j, pair.flag, pair.history);
  pair.history[was_touching] = 0.0;
  *pair.flag = 0;
}

void SmoothContacts::count(const SearchCounts& counts) {
  const double touching = counts.tested - counts.apart;
  counts_.values[ContactCounts::tested] += counts.tested;
  counts_.values[ContactCounts::newton_steps] += counts.tested + counts.more_steps;
  counts_.values[ContactCounts::touching_pairs] += touching;
  counts_.values[ContactCounts::contacts] += touching;
  counts_.values[ContactCounts::not_converged] += counts.not_converged;
}

} // namespace ellipsoid_host
