// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_contacthistory_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_contact_history.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran_ellipsoid.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

namespace {

/// A saved contact: tag of the partner, its centre as seen from the particle, number of values that
/// follow: the pair's row of the host, and what is beyond it.
enum { partner_tag, away_x, away_y, away_z, value_count, first_value };

Vector3 position(const double* coordinates) { return ellipsoid_host::vector(coordinates); }

std::size_t length_of(const double* contact) {
  return first_value + static_cast<std::size_t>(contact[value_count]);
}

/// Of the periodic sides of the box; infinite if there are none.
double shortest_period(const Domain& domain) {
  double side = HUGE_VAL;
  for (int k = 0; k < 3; ++k)
    if (domain.periodicity[k])
      side = std::min(side, domain.prd[k]);
  return side;
}

} // namespace

FixContactHistoryEllipsoid::FixContactHistoryEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg) {
  if (!dynamic_cast<PairGranEllipsoid*>(force->pair))
    error->fix_error(FLERR, this, "is made by pair_style gran/ellipsoid; remove this command");
  restart_peratom = 1;
  create_attribute = 1;
  force_reneighbor = 1;
  atom->add_callback(0);
  atom->add_callback(1);
}

FixContactHistoryEllipsoid::~FixContactHistoryEllipsoid() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixContactHistoryEllipsoid::setmask() {
  return FixConst::POST_INTEGRATE | FixConst::PRE_EXCHANGE | FixConst::PRE_NEIGHBOR;
}

void FixContactHistoryEllipsoid::post_integrate() {
  if (pair().near_candidates().are_outdated(*lmp))
    next_reneighbor = update->ntimestep;
}

PairGranEllipsoid& FixContactHistoryEllipsoid::pair() const {
  return *static_cast<PairGranEllipsoid*>(force->pair);
}

void FixContactHistoryEllipsoid::pre_exchange() {
  save();
  reserve_exchange();
  pair().near_candidates().prepare(*lmp);
}

void FixContactHistoryEllipsoid::pre_neighbor() { pair().ghosts_are_new(); }

/// Where a periodic side is so short that a particle may be near two images of a partner, saves all
/// contacts, with their places to tell the images apart; otherwise those beyond the host's row.
void FixContactHistoryEllipsoid::save() {
  if (!are_changed_)
    return;
  are_changed_ = false;
  are_to_be_given_ = true;
  saved_.clear();
  const NeighList &list = *pair().list, &histories = *pair().listgranhistory;
  const bool is_short = shortest_period(*domain) < 2.0 * neighbor->cutneighmax;
  const int owned = list.inum > 0 ? list.ilist[list.inum - 1] + 1 : 0; // when lists were made
  std::uint32_t index = 0;
  for (int k = 0; k < list.inum; ++k) {
    const int i = list.ilist[k];
    for (int l = 0; l < list.numneigh[i]; ++l, ++index) {
      if (!histories.firstneigh[i][l] || !(is_short || pair().more_history().size(index) > 0))
        continue;
      const int j = list.firstneigh[i][l] & NEIGHMASK;
      const double* row = pair().history(histories.firstdouble[i], l);
      const std::vector<double>& more = pair().more_history().of(index);
      save_contact(i, j, row, more, 1.0);
      if (j < owned)
        save_contact(j, i, row, more, -1.0);
    }
  }
}

/// @param[in] sign -1: the row is that of j with i
void FixContactHistoryEllipsoid::save_contact(int i, int j, const double* row,
                                              const std::vector<double>& more, double sign) {
  Saved& mine = saved_.at(i);
  const Vector3 away = position(atom->x[j]) - position(atom->x[i]);
  const int values = pair().dnum();
  mine.insert(mine.end(), {static_cast<double>(atom->tag[j]), away.x, away.y, away.z,
                           static_cast<double>(values) + static_cast<double>(more.size())});
  const auto add = [this, &mine, sign](const double* from, int count) {
    for (int k = 0; k < count; ++k)
      mine.push_back(pair().changes_sign(k) ? sign * from[k] : from[k]);
  };
  add(row, values);
  add(more.data(), static_cast<int>(more.size())); // slots like the row's
}

/// What was saved of i with this image of j, or with the nearest one; null: nothing with any.
const double* FixContactHistoryEllipsoid::find(int i, int j) const {
  const Saved& mine = saved_.of(i);
  const Vector3 away = position(atom->x[j]) - position(atom->x[i]);
  const double* nearest = nullptr;
  double least = HUGE_VAL;
  for (const double *c = mine.data(), *end = c + mine.size(); c < end; c += length_of(c)) {
    if (static_cast<int>(c[partner_tag]) != atom->tag[j])
      continue;
    const Vector3 moved = away - position(&c[away_x]);
    if (!nearest || dot(moved, moved) < least) {
      nearest = c;
      least = dot(moved, moved);
    }
  }
  return nearest;
}

void FixContactHistoryEllipsoid::give_back() {
  if (!are_to_be_given_)
    return;
  are_to_be_given_ = false;
  pair().more_history().clear();
  if (saved_.all().empty())
    return;
  const NeighList &list = *pair().list, &histories = *pair().listgranhistory;
  std::uint32_t index = 0;
  for (int k = 0; k < list.inum; ++k) {
    const int i = list.ilist[k];
    for (int l = 0; l < list.numneigh[i]; ++l, ++index)
      if (histories.firstneigh[i][l])
        give_back_pair(index, i, list.firstneigh[i][l] & NEIGHMASK, &histories.firstneigh[i][l],
                       pair().history(histories.firstdouble[i], l));
  }
}

/// The host has found a contact with some image of j, which may be another one. Images are a period
/// or more apart, by far more than particles move from one step to the next.
void FixContactHistoryEllipsoid::give_back_pair(std::uint32_t index, int i, int j, int* flag,
                                                double* row) {
  const double* contact = find(i, j);
  if (!contact)
    return;
  const int values = pair().dnum();
  const Vector3 moved = position(atom->x[j]) - position(atom->x[i]) - position(&contact[away_x]);
  if (norm(moved) > 0.5 * shortest_period(*domain)) {
    *flag = 0;
    std::fill_n(row, values, 0.0);
    return;
  }
  const double* begin = contact + first_value;
  std::copy_n(begin, values, row);
  if (length_of(contact) > first_value + static_cast<std::size_t>(values))
    pair().more_history().set(index, begin + values, contact + length_of(contact));
}

void FixContactHistoryEllipsoid::renumber(const ellipsoid_host::NewNumbers& numbers) {
  for (Saved& mine : saved_.all())
    for (double *c = mine.data(), *end = c + mine.size(); c < end; c += length_of(c)) {
      const auto found = numbers.find(static_cast<int>(c[partner_tag]));
      c[partner_tag] = found == numbers.end() ? 0.0 : found->second; // no particle has 0
    }
}

/// The host's buffer has room for 1000 values of a particle besides those that fixes ask for, of
/// which it takes the largest number and not the sum.
void FixContactHistoryEllipsoid::reserve_exchange() {
  int values = 0;
  const FixContactHistory* histories = pair().get_fix_history();
  for (int i = 0; i < atom->nlocal; ++i)
    values = std::max(values, const_cast<FixContactHistory*>(histories)->n_partner(i) *
                                      (pair().dnum() + 1) +
                                  1 + size_restart(i));
  for (int k = 0; k < modify->nfix; ++k) {
    if (modify->fix[k]->peratom_flag)
      values += std::max(1, modify->fix[k]->size_peratom_cols);
    if (const auto* rows = dynamic_cast<const ellipsoid_host::SendsRows*>(modify->fix[k]))
      values += rows->largest_row();
  }
  comm->maxexchange_fix = std::max(comm->maxexchange_fix, values);
}

double FixContactHistoryEllipsoid::memory_usage() { return saved_.bytes(); }

void FixContactHistoryEllipsoid::copy_arrays(int from, int to, int) { saved_.copy(from, to); }

void FixContactHistoryEllipsoid::set_arrays(int i) { saved_.empty(i); }

int FixContactHistoryEllipsoid::pack_exchange(int i, double* buffer) {
  return pack_restart(i, buffer);
}

int FixContactHistoryEllipsoid::unpack_exchange(int i, double* buffer) {
  return saved_.unpack(i, buffer);
}

/// Saves first: `restart N` writes files in steps without new lists.
int FixContactHistoryEllipsoid::size_restart(int i) {
  save();
  return saved_.packed_size(i);
}

int FixContactHistoryEllipsoid::pack_restart(int i, double* buffer) {
  save();
  return saved_.pack(i, buffer);
}

void FixContactHistoryEllipsoid::unpack_restart(int i, int set) {
  saved_.unpack_extra(i, atom->extra[i], set);
  are_to_be_given_ = true;
}

int FixContactHistoryEllipsoid::maxsize_restart() {
  save();
  const int largest = saved_.largest_packed_size(atom->nlocal);
  int of_all = largest;
  MPI_Allreduce(&largest, &of_all, 1, MPI_INT, MPI_MAX, world);
  return of_all;
}
