// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_balance_ellipsoid.h"

#include "atom.h"
#include "balance_settings.h"
#include "comm.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_insert.h"
#include "modify.h"
#include "timer.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace ellipsoid_host;

namespace {

/// Restart files: version of what follows, imbalance before and after, shifts, ranks in x, y, z;
/// then the planes.
constexpr std::size_t state_head = 7;
constexpr double state_version = 1.0;

} // namespace

FixBalanceEllipsoid::FixBalanceEllipsoid(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 4;
  extscalar = extvector = 0;
  global_freq = nevery = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  box_change_domain = 1;
  parse(narg, arg);
}

void FixBalanceEllipsoid::parse(int narg, char** arg) {
  ArgumentReader reader(error, this, narg, arg, 3);
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "every")
      every_ = reader.integer(keyword, 1, MAXSMALLINT - 1);
    else if (keyword == "threshold")
      threshold_ = reader.number(keyword, 1.0, HUGE_VAL);
    else if (keyword == "by")
      by_time_ = reader.choice(keyword, {"count", "time"}) == 1;
    else if (!read_balance_setting(reader, keyword, settings_))
      reader.complain("unknown keyword '" + keyword +
                      "', allowed are 'every', 'threshold', 'by', " + balance_keywords);
  }
  if (every_ == 0)
    reader.complain("a keyword is missing; add 'every N', the steps between two checks");
  if (igroup != 0)
    reader.complain("acts on all particles; give the group 'all'");
  if (by_time_)
    modify->timing = 1; // the host measures its fixes then
}

int FixBalanceEllipsoid::setmask() { return END_OF_STEP; }

void FixBalanceEllipsoid::init() {
  if (modify->n_fixes_style_strict(style) > 1)
    error->fix_error(FLERR, this, "there is another one; remove one of them");
  check_shifts_are_possible(lmp, "Fix balance/ellipsoid (id " + std::string(id) + ")");
  note_box_change(false);
  time_at_check_ = 0.0; // as the host's clocks
}

/// While `box_change` is 1 the host hands meshes round and finds their cells whenever lists are
/// built, and insertions measure their regions anew, which changes their random numbers. Here it is
/// 1 in steps with new lists, after the insertions.
void FixBalanceEllipsoid::note_box_change(bool planes_too) {
  domain->box_change = domain->box_change_size || domain->box_change_shape || planes_too ? 1 : 0;
}

/// Next step at which a fix of the host inserts; a very large one if none does.
bigint FixBalanceEllipsoid::next_insertion() const {
  bigint next = MAXBIGINT;
  for (int i = 0; i < modify->nfix; ++i)
    if (const auto* fix = dynamic_cast<const FixInsert*>(modify->fix[i]))
      if (fix->next_reneighbor > update->ntimestep)
        next = std::min(next, fix->next_reneighbor);
  return next;
}

bool FixBalanceEllipsoid::is_due() const {
  if (update->setupflag)
    return !by_time_ || !was_measured_;
  return is_for_insertion_ || update->ntimestep % every_ == 0;
}

void FixBalanceEllipsoid::balance() {
  if (comm->nprocs == 1)
    return;
  const bigint step = update->ntimestep, insertion = next_insertion();
  note_box_change(true);
  const bool insertion_is_next = insertion == step + 1;
  if (insertion_is_next || is_due()) {
    if (domain->triclinic)
      domain->x2lamda(atom->nlocal);
    exchange_particles(lmp);
    if (insertion_is_next)
      shift(even_planes(lmp));
    else
      check();
    is_for_insertion_ = insertion_is_next;
    if (domain->triclinic)
      domain->lamda2x(atom->nlocal);
  }
  next_reneighbor = std::min((step / every_ + 1) * every_, std::max(insertion - 1, step + 1));
}

/// Since the last check, of this rank: its share of particles, or seconds in forces, walls, motion
/// and neighbour lists, where ranks do not wait for each other.
double FixBalanceEllipsoid::work_since_check() {
  if (!by_time_ || update->setupflag)
    return atom->nlocal;
  double time = timer->array[TIME_PAIR] + timer->array[TIME_NEIGHBOR];
  for (int i = 0; i < modify->nfix; ++i)
    if (std::strncmp(modify->fix[i]->style, "wall/", 5) == 0 ||
        std::strncmp(modify->fix[i]->style, "nve", 3) == 0)
      time += modify->fix[i]->get_recorded_time();
  const double since = std::max(time - time_at_check_, 0.0);
  time_at_check_ = time;
  was_measured_ = true;
  return since;
}

void FixBalanceEllipsoid::check() {
  const double work = work_since_check();
  before_ = after_ = imbalance(lmp, work);
  if (before_ <= threshold_)
    return;
  const double weight = atom->nlocal > 0 ? work / atom->nlocal : 0.0;
  const BalancePlan plan = balanced_planes(lmp, settings_, weight);
  if (plan.imbalance >= before_)
    return;
  shift(plan.planes);
  after_ = by_time_ ? plan.imbalance : imbalance(lmp, atom->nlocal);
}

void FixBalanceEllipsoid::shift(const Planes& planes) {
  if (planes == present_planes(lmp))
    return;
  shift_planes(lmp, planes);
  ++shifts_;
}

double FixBalanceEllipsoid::compute_vector(int n) {
  if (n == 3) {
    int most = 0;
    MPI_Allreduce(&atom->nlocal, &most, 1, MPI_INT, MPI_MAX, world);
    return most;
  }
  return n == 0 ? before_ : n == 1 ? after_ : static_cast<double>(shifts_);
}

void FixBalanceEllipsoid::write_restart(FILE* file) {
  if (comm->me != 0)
    return;
  std::vector<double> state{state_version, before_, after_, static_cast<double>(shifts_)};
  for (const int ranks : comm->procgrid)
    state.push_back(ranks);
  for (const std::vector<double>& planes : present_planes(lmp))
    state.insert(state.end(), planes.begin(), planes.end());
  const int size = static_cast<int>(state.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, file);
  fwrite(state.data(), sizeof(double), state.size(), file);
}

void FixBalanceEllipsoid::restart(ELLIPSOID_RESTART_PARAMETERS) {
  double state[state_head];
  std::memcpy(state, buffer, sizeof(state));
  before_ = state[1];
  after_ = state[2];
  shifts_ = static_cast<bigint>(state[3]);
}

Planes FixBalanceEllipsoid::planes_of(const char* state) {
  double head[state_head];
  std::memcpy(head, state, sizeof(head));
  Planes planes;
  const char* from = state + sizeof(head);
  for (std::size_t k = 0; k < 3; ++k) {
    planes[k].resize(static_cast<std::size_t>(head[4 + k]) + 1);
    std::memcpy(planes[k].data(), from, planes[k].size() * sizeof(double));
    from += planes[k].size() * sizeof(double);
  }
  return planes;
}
