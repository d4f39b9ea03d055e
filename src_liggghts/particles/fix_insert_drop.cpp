// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_insert_drop.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_clumps_ellipsoid.h"
#include "fix_property_atom.h"
#include "insertion/counter_random.h"
#include "modify.h"
#include "multisphere_particles.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <string>

using namespace LAMMPS_NS;
using namespace FixConst;
using ellipsoid_host::store;
using ellipsoid_host::vector;

namespace {

/// First number of the state in restart files: what follows counts time.
constexpr double state_by_time = -2.0;
/// The same in files of earlier versions, which count steps; the oldest files lack it.
constexpr double state_by_steps = -1.0;

/// A taken place is tried again a few times per interval: every try rebuilds the neighbour lists.
constexpr double tries_per_interval = 10.0;

} // namespace

FixInsertDrop::FixInsertDrop(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  restart_global = 1;
  scalar_flag = 1;
  extscalar = 0;
  global_freq = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
  since_step_ = update->ntimestep + 1;
  time_step_ = update->dt;
  parse(narg, arg);
}

void FixInsertDrop::parse(int narg, char** arg) {
  ellipsoid_host::ArgumentReader reader(error, this, narg, arg, 3);
  bool has_seed = false, has_box = false;
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "seed") {
      seed_ = reader.integer(keyword, 1, MAXSMALLINT - 1);
      has_seed = true;
    } else if (keyword == "template") {
      parse_template(reader);
    } else if (keyword == "particles") {
      particles_ = reader.integer(keyword, 1, MAXSMALLINT - 1);
    } else if (keyword == "interval") {
      interval_ = reader.positive(keyword);
    } else if (keyword == "box") {
      for (int k = 0; k < 3; ++k) {
        low_[k] = reader.number(keyword, -HUGE_VAL, HUGE_VAL);
        high_[k] = reader.number(keyword, low_[k], HUGE_VAL);
      }
      has_box = true;
    } else if (keyword == "velocity") {
      for (double* component : {&velocity_.x, &velocity_.y, &velocity_.z})
        *component = reader.number(keyword, -HUGE_VAL, HUGE_VAL);
    } else {
      reader.complain("unknown keyword '" + keyword +
                      "', allowed are 'seed', 'template', 'particles', 'interval', 'box', "
                      "'velocity'");
    }
  }
  const char* missing = !has_seed          ? "seed S"
                        : !template_       ? "template ID"
                        : particles_ == 0  ? "particles K"
                        : interval_ == 0.0 ? "interval T"
                        : !has_box         ? "box xlo xhi ylo yhi zlo zhi"
                                           : nullptr;
  if (missing)
    reader.complain(std::string("a keyword is missing; add '") + missing + "'");
}

void FixInsertDrop::parse_template(ellipsoid_host::ArgumentReader& reader) {
  const std::string name = reader.word("template");
  const int index = modify->find_fix(name.c_str());
  template_ = index < 0 ? nullptr : dynamic_cast<FixParticletemplateEllipsoid*>(modify->fix[index]);
  if (!template_)
    reader.complain("keyword 'template' has the value '" + name +
                    "', allowed is the id of a fix particletemplate/ellipsoid; define it first");
}

int FixInsertDrop::setmask() { return INITIAL_INTEGRATE | PRE_EXCHANGE; }

void FixInsertDrop::init() {
  if (!is_inside_box())
    error->fix_error(FLERR, this,
                     "keyword 'box' reaches out of the simulation box; keep it inside");
  follow_time_step(update->ntimestep);
  check_interval();
  schedule();
}

/// Notices a change of the time step, by whatever command, in the first step with the new one.
void FixInsertDrop::initial_integrate(int) {
  if (update->dt == time_step_)
    return;
  follow_time_step(update->ntimestep - 1);
  check_interval();
  schedule();
}

/// @param[in] last_step the last one with the time step known so far
void FixInsertDrop::follow_time_step(bigint last_step) {
  if (update->dt == time_step_)
    return;
  if (last_step > since_step_ && time_step_ > 0.0) {
    elapsed_ += static_cast<double>(last_step - since_step_) * time_step_;
    since_step_ = last_step;
  }
  time_step_ = update->dt;
}

void FixInsertDrop::check_interval() {
  if (interval_ < time_step_)
    error->fix_error(FLERR, this,
                     "keyword 'interval' is shorter than the time step; make it longer");
}

/// Simulated time since the first drop (time).
double FixInsertDrop::elapsed() const {
  return elapsed_ + static_cast<double>(update->ntimestep - since_step_) * time_step_;
}

/// The step of the next drop: counted from the first drop, so that rounding does not add up.
void FixInsertDrop::schedule() {
  if (inserted_ >= particles_) {
    next_reneighbor = -1;
    return;
  }
  const double due = std::max(inserted_ * interval_, next_try_);
  const bigint step =
      since_step_ + static_cast<bigint>(std::llround((due - elapsed_) / time_step_));
  next_reneighbor = std::max(step, update->ntimestep + 1);
}

void FixInsertDrop::reset_timestep(bigint new_step, bigint old_step) {
  since_step_ += new_step - old_step;
  schedule();
}

double FixInsertDrop::max_rad(int type) ELLIPSOID_HOST_CONST {
  return type == template_->maxtype() ? template_->max_rad() : 0.0;
}

double FixInsertDrop::min_rad(int type) ELLIPSOID_HOST_CONST {
  return type == template_->maxtype() ? template_->min_rad() : HUGE_VAL;
}

void FixInsertDrop::draw(ParticleToInsertEllipsoid& p) const {
  ellipsoid::CounterRandom shape(~static_cast<std::uint64_t>(seed_),
                                 static_cast<std::uint64_t>(inserted_));
  template_->fill(p, [&shape] { return shape.uniform(); });
  ellipsoid::CounterRandom random(static_cast<std::uint64_t>(seed_),
                                  static_cast<std::uint64_t>(inserted_));
  double position[3], velocity[3], at_rest[3] = {0.0, 0.0, 0.0}, quaternion[4];
  for (int k = 0; k < 3; ++k)
    position[k] = random.uniform(low_[k], high_[k]);
  store(velocity_, velocity);
  if (template_->planar()) {
    const double half_angle = 0.5 * random.uniform(-M_PI, M_PI);
    store(ellipsoid::Quaternion{std::cos(half_angle), 0.0, 0.0, std::sin(half_angle)}, quaternion);
  } else { // uniform over all rotations: Shoemake 1992, Graphics Gems III
    const double u = random.uniform(), a = random.uniform(0.0, 2.0 * M_PI),
                 b = random.uniform(0.0, 2.0 * M_PI);
    store(ellipsoid::Quaternion{std::sqrt(1.0 - u) * std::sin(a), std::sqrt(1.0 - u) * std::cos(a),
                                std::sqrt(u) * std::sin(b), std::sqrt(u) * std::cos(b)},
          quaternion);
  }
  p.set_x_v_omega(position, velocity, at_rest, quaternion);
}

bool FixInsertDrop::is_mine(const double* x) const {
  const bool tilted = domain->triclinic;
  const double *low = tilted ? domain->sublo_lamda : domain->sublo,
               *high = tilted ? domain->subhi_lamda : domain->subhi;
  double place[3] = {x[0], x[1], x[2]};
  if (tilted)
    fractions_in_box(x, place);
  for (int k = 0; k < 3; ++k) {
    const bool last = comm->myloc[k] == comm->procgrid[k] - 1;
    if (place[k] < low[k] || (last ? place[k] > high[k] : place[k] >= high[k]))
      return false;
  }
  return true;
}

/// Coordinates in units of a tilted box, along periodic directions of the image within it.
void FixInsertDrop::fractions_in_box(const double* x, double* fractions) const {
  double place[3] = {x[0], x[1], x[2]};
  domain->x2lamda(place, fractions);
  for (int k = 0; k < 3; ++k)
    if (domain->periodicity[k])
      fractions[k] -= std::floor(fractions[k]);
}

/// Whether all places are within the simulation box; of a tilted one, where it is not periodic.
bool FixInsertDrop::is_inside_box() const {
  bool inside = true;
  for (int k = 0; k < 3 && !domain->triclinic; ++k)
    inside = inside && low_[k] >= domain->boxlo[k] && high_[k] <= domain->boxhi[k];
  for (int corner = 0; corner < 8 && domain->triclinic; ++corner) {
    const double x[3] = {corner & 1 ? high_[0] : low_[0], corner & 2 ? high_[1] : low_[1],
                         corner & 4 ? high_[2] : low_[2]};
    double fractions[3];
    fractions_in_box(x, fractions);
    for (const double fraction : fractions)
      inside = inside && fraction >= 0.0 && fraction <= 1.0;
  }
  return inside;
}

/// Clumps are their spheres, all other particles smooth ellipsoids.
ellipsoid::SolidBody FixInsertDrop::solid_body(const ellipsoid::Vector3& centre,
                                               const double* semiaxes, const double* quaternion,
                                               int spacing) const {
  if (spacing <= ellipsoid::clump_spacing)
    return ellipsoid::smooth_body(centre, vector(semiaxes), ellipsoid_host::quaternion(quaternion));
  const FixClumpsEllipsoid& clumps = *FixClumpsEllipsoid::find(modify);
  ellipsoid::MultispherePose pose;
  pose.body = clumps.body(spacing, clumps.clump(spacing).spheres.count(), semiaxes);
  turn(pose, ellipsoid::rotation(ellipsoid_host::quaternion(quaternion)));
  pose.scale = semiaxes[1];
  return ellipsoid::multisphere_body(centre, pose);
}

/// True on all ranks when no particle of any rank touches the new one.
bool FixInsertDrop::place_is_free(const ParticleToInsertEllipsoid& p) const {
  const ellipsoid::SolidBody body = solid_body({}, p.shape_ins, p.quat_ins, p.spacing);
  const FixPropertyAtom* spacing = ellipsoid_host::subsphere_properties(modify)[1];
  int touching = 0;
  for (int i = 0; i < atom->nlocal && !touching; ++i) {
    ellipsoid::Vector3 distance = vector(atom->x[i]) - vector(p.x_ins[0]);
    domain->minimum_image(distance.x, distance.y, distance.z);
    const double reach = atom->radius[i] + p.r_bound_ins;
    if (dot(distance, distance) >= reach * reach)
      continue;
    const int number = spacing ? static_cast<int>(std::lround(spacing->vector_atom[i])) : 0;
    touching = overlap(body, solid_body(distance, atom->shape[i], atom->quaternion[i], number));
  }
  int touching_anywhere = 0;
  MPI_Allreduce(&touching, &touching_anywhere, 1, MPI_INT, MPI_MAX, world);
  return !touching_anywhere;
}

void FixInsertDrop::insert(ParticleToInsertEllipsoid& p) {
  int here = is_mine(p.x_ins[0]) ? 1 : 0, everywhere = 0;
  if (here) {
    p.groupbit |= groupbit;
    p.insert();
  }
  MPI_Allreduce(&here, &everywhere, 1, MPI_INT, MPI_SUM, world);
  if (everywhere != 1)
    error->fix_error(FLERR, this,
                     "no rank or several ranks own the place of a new particle; "
                     "this is an error of the program, please report it");
  if (atom->tag_enable)
    atom->tag_extend();
  atom->natoms += 1;
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

void FixInsertDrop::pre_exchange() {
  if (update->ntimestep != next_reneighbor || inserted_ >= particles_)
    return;
  ParticleToInsertEllipsoid particle(lmp);
  draw(particle);
  if (place_is_free(particle)) {
    insert(particle);
    ++inserted_;
    next_try_ = -1.0;
  } else {
    if (next_try_ < 0.0 && comm->me == 0)
      error->warning(FLERR,
                     ("Fix insert/drop (id " + std::string(id) + "): the place of particle " +
                      std::to_string(inserted_ + 1) + " is taken; it waits until the place is free")
                         .c_str());
    next_try_ = elapsed() + interval_ / tries_per_interval;
  }
  schedule();
}

void FixInsertDrop::write_restart(FILE* file) {
  if (comm->me != 0)
    return;
  const double state[] = {state_by_time, static_cast<double>(inserted_),
                          elapsed_,      static_cast<double>(since_step_ - update->ntimestep),
                          time_step_,    next_try_};
  const int size = sizeof(state);
  fwrite(&size, sizeof(int), 1, file);
  fwrite(state, 1, sizeof(state), file);
}

void FixInsertDrop::restart(ELLIPSOID_RESTART_PARAMETERS) {
  double state[6];
  std::memcpy(state, buffer, sizeof(state[0]));
  if (state[0] != state_by_time) {
    restart_by_steps(buffer + (state[0] == state_by_steps ? sizeof(state[0]) : 0));
    return;
  }
  std::memcpy(state, buffer, sizeof(state));
  inserted_ = static_cast<int>(state[1]);
  elapsed_ = state[2];
  since_step_ = update->ntimestep + static_cast<bigint>(state[3]);
  time_step_ = state[4];
  next_try_ = state[5];
}

/// Of an earlier version: the number of particles and the first step, not the time step.
void FixInsertDrop::restart_by_steps(const char* buffer) {
  double state[2];
  std::memcpy(state, buffer, sizeof(state));
  inserted_ = static_cast<int>(state[0]);
  since_step_ = static_cast<bigint>(state[1]);
  elapsed_ = time_step_ = 0.0;
  next_try_ = -1.0;
  if (comm->me == 0)
    error->warning(FLERR, ("Fix insert/drop (id " + std::string(id) +
                           "): the restart file is of an earlier version, which does not keep the "
                           "time step; the present one is taken for all steps before")
                              .c_str());
}
