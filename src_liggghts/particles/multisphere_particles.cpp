// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere_particles.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_clumps_ellipsoid.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "multisphere/ellipsoid_spheres.h"
#include "multisphere/motion_batch.h"
#include "multisphere/near_spheres.h"
#include "neighbor.h"
#include "particle_arrays.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

using namespace LAMMPS_NS;

namespace ellipsoid_host {

namespace {

/// Aspect ratios closer than this are the same chain: far below any shape's tolerance.
constexpr double aspect_resolution = 1e-12;

FixPropertyAtom* per_atom(Modify* modify, const char* name) {
  return static_cast<FixPropertyAtom*>(modify->find_fix_property(name, "property/atom", "scalar", 0,
                                                                 0, "surface multisphere", false));
}

/// @throws std::invalid_argument there are none
const FixClumpsEllipsoid& clumps(Modify* modify) {
  const FixClumpsEllipsoid* found = FixClumpsEllipsoid::find(modify);
  if (!found)
    throw std::invalid_argument("it is a clump, and there are none; give their templates first");
  return *found;
}

constexpr const char* property_names[2] = {"subspheres", "spacing"};

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// The value of a per-atom property that is a number of its own kind of thing.
/// @throws std::invalid_argument it is no whole number, or too large for one
int whole_value(const char* name, double value) {
  constexpr double largest = 1e9;
  if (!(std::fabs(value) <= largest) || value != std::floor(value))
    throw std::invalid_argument("property/atom " + std::string(name) + " is " + shown(value) +
                                ", allowed are whole numbers");
  return static_cast<int>(value);
}

/// @throws std::invalid_argument there is none of this number
ellipsoid::SphereSpacing known_spacing(int number) {
  const auto spacing = ellipsoid::sphere_spacing_from_number(number);
  if (!spacing)
    throw std::invalid_argument("property/atom spacing is " + std::to_string(number) +
                                ", allowed are " + ellipsoid::numbers_of_spacings());
  return *spacing;
}

} // namespace

SubsphereProperties subsphere_properties(Modify* modify) {
  return {per_atom(modify, property_names[0]), per_atom(modify, property_names[1])};
}

SubsphereProperties make_subsphere_properties(Modify* modify) {
  for (const char* name : property_names) {
    if (per_atom(modify, name))
      continue;
    const char* arguments[] = {name, "all", "property/atom", name, "scalar", "yes", "yes",
                               "no", "0."};
    modify->add_fix(9, const_cast<char**>(arguments));
    per_atom(modify, name)->just_created = 0; // else the next run begins with default values
  }
  return subsphere_properties(modify);
}

void MultisphereParticles::find_properties() {
  std::tie(subspheres_, spacing_) = std::tuple_cat(subsphere_properties(modify));
  if (!subspheres_)
    error->all(FLERR, ("surface multisphere: no particle has sub-spheres; use keyword 'subspheres' "
                       "or 'clump' of fix particletemplate/ellipsoid; after read_restart " +
                       std::string(repeat_after_restart))
                          .c_str());
}

const ellipsoid::MultisphereBody* MultisphereParticles::body(const double* semiaxes, int count,
                                                             int spacing) {
  if (spacing > ellipsoid::clump_spacing)
    return clumps(modify).body(spacing, count, semiaxes);
  const double aspect = semiaxes[0] / semiaxes[1], flatness = semiaxes[2] / semiaxes[1];
  auto& entry = bodies_[Key(std::llround(aspect / aspect_resolution),
                            std::llround(flatness / aspect_resolution), count, spacing)];
  if (entry)
    return entry.get();
  if (count == 0)
    throw std::invalid_argument(
        "it is smooth (subspheres 0); give its template 'subspheres', or take "
        "surface smooth for all");
  const ellipsoid::SphereSpacing placed = known_spacing(spacing);
  if (ellipsoid::is_planar(placed)) {
    entry.reset(new ellipsoid::MultisphereBody(
        ellipsoid::make_ellipsoid_spheres({aspect, 1.0, flatness}, count, placed)));
    return entry.get();
  }
  if (semiaxes[1] != semiaxes[2])
    throw std::invalid_argument("the semi-axes b and c differ; chains need b = c, spacings medial "
                                "and minimax_volume do not");
  entry.reset(new ellipsoid::MultisphereBody(make_multisphere(aspect, 1.0, count, placed)));
  return entry.get();
}

const ellipsoid::MultisphereBody* MultisphereParticles::body(int i) {
  try {
    const int count = whole_value(property_names[0], subspheres_->vector_atom[i]);
    const int spacing = spacing_ ? whole_value(property_names[1], spacing_->vector_atom[i]) : 0;
    return body(atom->shape[i], count, spacing);
  } catch (const std::invalid_argument& problem) {
    error->one(FLERR,
               ("surface multisphere, atom " + std::to_string(atom->tag[i]) + ": " + problem.what())
                   .c_str());
  }
  return nullptr;
}

ellipsoid::MultispherePose MultisphereParticles::make_pose(const double* semiaxes,
                                                           const double* quaternion, int count,
                                                           int spacing) {
  ellipsoid::MultispherePose pose;
  pose.body = body(semiaxes, count, spacing);
  turn(pose, ellipsoid::rotation(ellipsoid_host::quaternion(quaternion)));
  pose.scale = semiaxes[1];
  return pose;
}

void MultisphereParticles::set_pose(int i, ellipsoid::MultispherePose& pose) const {
  turn(pose, ellipsoid::rotation(quaternion(atom->quaternion[i])));
  pose.scale = atom->shape[i][1];
}

ellipsoid::MultispherePose MultisphereParticles::make_pose(int i) {
  ellipsoid::MultispherePose pose;
  pose.body = body(i);
  set_pose(i, pose);
  return pose;
}

/// The host does not give new ghosts the values of these fixes.
void MultisphereParticles::ghosts_are_new() {
  find_properties();
  subspheres_->do_forward_comm();
  if (spacing_)
    spacing_->do_forward_comm();
}

ellipsoid::BodyBounds MultisphereParticles::bounds(int i) {
  return scaled(body(i)->bounds(), atom->shape[i][1]);
}

/// Which body a particle has is looked up when the neighbour lists are new: only then particles
/// come and go, on all ranks at once.
bool MultisphereParticles::update() {
  const auto count = static_cast<std::size_t>(atom->nlocal + atom->nghost);
  const bool new_lists = neighbor->ago == 0;
  if (new_lists || poses_.size() != count)
    find_properties();
  if (new_lists || poses_.size() != count) {
    begin_lists(count);
    return true;
  }
  move();
  return false;
}

void MultisphereParticles::begin_lists(std::size_t count) {
  poses_.resize(count);
  const double* centres = ParticleArrays(*atom).x[0];
  centres_.assign(centres, centres + 3 * count);
  clocks_.restart(count);
  const double time_step = lmp->update->dt;
  for (std::size_t i = 0; i < count; ++i) {
    poses_[i] = make_pose(static_cast<int>(i));
    const double half_length = poses_[i].scale * poses_[i].body->half_length();
    clocks_.expect(i, {time_step * vector(atom->v[i]),
                       time_step * half_length * norm(vector(atom->omega[i]))});
  }
}

void MultisphereParticles::move() {
  const ParticleArrays particles(*atom);
  clocks_.advance_all([&](std::size_t first, ellipsoid::Motions& motions) {
    const int i = static_cast<int>(first);
    ellipsoid::measure_motions({particles.shape[i], particles.x[i], particles.quaternion[i],
                                &centres_[3 * first], &poses_[first]},
                               motions);
  });
}

} // namespace ellipsoid_host
