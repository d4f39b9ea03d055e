// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "insertion_space.h"

#include "atom.h"
#include "bounding_box.h"
#include "comm.h"
#include "domain.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix.h"
#include "fix_particletemplate_ellipsoid.h"
#include "fix_property_atom.h"
#include "force.h"
#include "host_pair.h"
#include "host_variants.h"
#include "insertion/body_in_space.h"
#include "insertion/occupied_space.h"
#include "math_extra_liggghts.h"
#include "modify.h"
#include "multisphere_particles.h"
#include "random_park.h"
#include "region.h"
#include "room_in_region.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace LAMMPS_NS;
using ellipsoid::SolidBody;
using ellipsoid::Vector3;

namespace ellipsoid_host {
namespace {

/// Spheres may stick out of the bounding sphere of their ellipsoid by the ripple of spacing
/// minimax.
constexpr double sticking_out = 1.2;

/// A body as it goes to other ranks.
struct PlainBody {
  double centre[3], radius, semiaxes[3], quaternion[4], subspheres, spacing;
};
constexpr int numbers_of_plain_body = sizeof(PlainBody) / sizeof(double);

/// A box of the space.
struct Box {
  double low[3], high[3];

  /// Whether a ball reaches into the box.
  bool meets(const double* centre, double radius) const {
    for (int k = 0; k < 3; ++k)
      if (centre[k] + radius < low[k] || centre[k] - radius > high[k])
        return false;
    return true;
  }
};

class InsertionSpace : private Pointers {
 public:
  explicit InsertionSpace(LAMMPS* lmp)
      : Pointers(lmp), chains_(lmp), of_spheres_(has_surface(*force, "multisphere")) {}

  void load(BoundingBox& reached, double largest_radius);
  void stay_within(Region* region) { within_ = region; }
  bool occupy(const ParticleToInsertEllipsoid& particle, const double* centre,
              const double* quaternion);
  bool may_fit(const ParticleToInsertEllipsoid& particle, const double* centre);
  /// A body found no room. @return how many in a row have found none
  int count_refusal() { return ++refusals_; }

 private:
  int refusals_ = 0;
  ellipsoid::OccupiedSpace space_;
  MultisphereParticles chains_;
  bool of_spheres_;
  Region* within_ = nullptr;

  PlainBody plain_body(int i, const SubsphereProperties& properties) const;
  SolidBody solid_body(const PlainBody& body);
  void add_images(const PlainBody& body, const Box& room, bool itself);
  bool is_within_region(const SolidBody& body) const;
  bool reaches_others(const SolidBody& body, const PlainBody& plain) const;
};

PlainBody InsertionSpace::plain_body(int i, const SubsphereProperties& properties) const {
  PlainBody body{};
  std::copy_n(atom->x[i], 3, body.centre);
  body.radius = sticking_out * atom->radius[i];
  std::copy_n(atom->shape[i], 3, body.semiaxes);
  std::copy_n(atom->quaternion[i], 4, body.quaternion);
  body.subspheres = properties[0] ? properties[0]->vector_atom[i] : 0.0;
  body.spacing = properties[1] ? properties[1]->vector_atom[i] : 0.0;
  return body;
}

SolidBody InsertionSpace::solid_body(const PlainBody& body) {
  const Vector3 centre = vector(body.centre);
  if (!of_spheres_ || body.subspheres == 0.0)
    return ellipsoid::smooth_body(centre, vector(body.semiaxes), quaternion(body.quaternion));
  try {
    return ellipsoid::multisphere_body(centre, chains_.make_pose(body.semiaxes, body.quaternion,
                                                                 static_cast<int>(body.subspheres),
                                                                 static_cast<int>(body.spacing)));
  } catch (const std::invalid_argument& problem) {
    error->one(FLERR, (std::string("surface multisphere, insertion: ") + problem.what()).c_str());
  }
  return {};
}

/// The images of a body, and the body itself if wanted, that reach into the room.
void InsertionSpace::add_images(const PlainBody& body, const Box& room, bool itself) {
  const int* periodic = domain->periodicity;
  for (int ix = -periodic[0]; ix <= periodic[0]; ++ix)
    for (int iy = -periodic[1]; iy <= periodic[1]; ++iy)
      for (int iz = -periodic[2]; iz <= periodic[2]; ++iz) {
        if (!itself && ix == 0 && iy == 0 && iz == 0)
          continue;
        PlainBody image = body;
        image.centre[0] +=
            ix * domain->xprd + (domain->triclinic ? iy * domain->xy + iz * domain->xz : 0.0);
        image.centre[1] += iy * domain->yprd + (domain->triclinic ? iz * domain->yz : 0.0);
        image.centre[2] += iz * domain->zprd;
        if (room.meets(image.centre, image.radius))
          space_.add(solid_body(image));
      }
}

/// Bodies that reach out of their rank's domain go to all ranks; others matter only to their own.
void InsertionSpace::load(BoundingBox& reached, double largest_radius) {
  Box room, own;
  reached.getBoxBounds(room.low, room.high);
  for (int k = 0; k < 3; ++k) { // what new bodies can reach, around their centres
    room.low[k] += largest_radius;
    room.high[k] -= largest_radius;
    own.low[k] = domain->sublo[k];
    own.high[k] = domain->subhi[k];
  }
  const SubsphereProperties properties = subsphere_properties(modify);
  std::vector<PlainBody> shared;
  for (int i = 0; i < atom->nlocal; ++i) {
    const PlainBody body = plain_body(i, properties);
    bool crosses = domain->triclinic;
    for (int k = 0; k < 3; ++k)
      crosses = crosses || body.centre[k] - body.radius < own.low[k] ||
                body.centre[k] + body.radius > own.high[k];
    if (crosses)
      shared.push_back(body);
    if (room.meets(body.centre, body.radius))
      space_.add(solid_body(body));
  }
  const int mine = static_cast<int>(shared.size()) * numbers_of_plain_body;
  std::vector<int> counts(static_cast<std::size_t>(comm->nprocs)), begins(counts.size());
  MPI_Allgather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  int total = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    begins[rank] = total;
    total += counts[rank];
  }
  std::vector<PlainBody> all(static_cast<std::size_t>(total / numbers_of_plain_body));
  MPI_Allgatherv(shared.data(), mine, MPI_DOUBLE, all.data(), counts.data(), begins.data(),
                 MPI_DOUBLE, world);
  const std::size_t my_first =
      static_cast<std::size_t>(begins[static_cast<std::size_t>(comm->me)] / numbers_of_plain_body);
  for (std::size_t k = 0; k < all.size(); ++k)
    add_images(all[k], room, k < my_first || k >= my_first + shared.size());
}

/// The axis (0, 1, 2) of a region `cylinder`: the one along which a corner of its bounding box,
/// seen from the middle, is inside.
int axis_of_cylinder(Region& region, const std::array<double, 3>& middle,
                     const std::array<double, 3>& high) {
  constexpr double nearly = 0.99;
  int axis = 0;
  for (; axis < 2; ++axis) {
    std::array<double, 3> probe = middle;
    for (std::size_t k = 0; k < 3; ++k)
      if (static_cast<int>(k) != axis)
        probe[k] += nearly * (high[k] - middle[k]);
    if (!region.match(probe[0], probe[1], probe[2]))
      break; // else this face of the bounding box is a square of the cylinder's side, not its end
  }
  return axis;
}

/// Blocks, balls and cylinders have closed forms.
bool InsertionSpace::is_within_region(const SolidBody& body) const {
  const std::array<double, 3> low{within_->extent_xlo, within_->extent_ylo, within_->extent_zlo},
      high{within_->extent_xhi, within_->extent_yhi, within_->extent_zhi};
  const std::array<double, 3> middle{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]),
                                     0.5 * (low[2] + high[2])};
  const auto is = [this](const char* style) {
    return within_->interior && std::strcmp(within_->style, style) == 0;
  };
  if (is("block"))
    return is_inside_block(body, low, high);
  if (is("sphere"))
    return is_inside_ball(body, vector(middle.data()), high[0] - middle[0]);
  if (is("cylinder")) {
    const int axis = axis_of_cylinder(*within_, middle, high);
    const auto along = static_cast<std::size_t>(axis), across = (along + 1) % 3;
    return is_inside_cylinder(body, axis, vector(middle.data()), high[across] - middle[across],
                              low[along], high[along]);
  }
  return is_inside_space(body, [this](const Vector3& point, double enough) {
    return room_in_region(*domain, *within_, point, enough);
  });
}

/// Whether a sphere keeps from the borders of its rank's domain.
bool stays_within_rank(Domain& domain, double* centre, double radius) {
#ifdef ELLIPSOID_HOST_INL
  double distances[3] = {radius, radius, radius};
  return domain.check_dist_subbox_borders(centre, distances);
#else
  return domain.dist_subbox_borders(centre) >= radius;
#endif
}

PlainBody plain_body(const ParticleToInsertEllipsoid& particle, const double* centre,
                     const double* quaternion) {
  PlainBody plain{};
  std::copy_n(centre, 3, plain.centre);
  std::copy_n(particle.shape_ins, 3, plain.semiaxes);
  std::copy_n(quaternion, 4, plain.quaternion);
  plain.radius = particle.r_bound_ins;
  plain.subspheres = particle.subspheres;
  plain.spacing = static_cast<double>(particle.spacing);
  return plain;
}

/// Whether a body reaches out of its rank's domain, where it could meet new ones of other ranks, or
/// images.
bool InsertionSpace::reaches_others(const SolidBody& body, const PlainBody& plain) const {
  const bool may_meet_others =
      comm->nprocs > 1 || domain->xperiodic || domain->yperiodic || domain->zperiodic;
  PlainBody copy = plain;
  return may_meet_others && !stays_within_rank(*domain, copy.centre, body.bounding_radius);
}

bool InsertionSpace::occupy(const ParticleToInsertEllipsoid& particle, const double* centre,
                            const double* quaternion) {
  const PlainBody plain = ellipsoid_host::plain_body(particle, centre, quaternion);
  const SolidBody body = solid_body(plain);
  if (reaches_others(body, plain) || (within_ && !is_within_region(body)) || !space_.is_free(body))
    return false;
  space_.add(body);
  refusals_ = 0;
  return true;
}

/// Whether another orientation may help a body that has no room here: it never helps a sphere.
bool InsertionSpace::may_fit(const ParticleToInsertEllipsoid& particle, const double* centre) {
  const double upright[4] = {1.0, 0.0, 0.0, 0.0};
  PlainBody plain = ellipsoid_host::plain_body(particle, centre, upright);
  const SolidBody body = solid_body(plain);
  if (!(body.inscribed_radius > 0.0 && body.inscribed_radius < body.bounding_radius) ||
      reaches_others(body, plain) ||
      (within_ && !within_->match_shrinkby_cut(plain.centre, body.inscribed_radius)))
    return false;
  return space_.is_free(inscribed_ball(body));
}

/// The space of the insertion at hand: there is only one at a time.
std::unique_ptr<InsertionSpace>& present_space() {
  static std::unique_ptr<InsertionSpace> space;
  return space;
}

} // namespace

void begin_insertion(LAMMPS* lmp, BoundingBox& reached, double largest_radius) {
  present_space().reset();
  if (!lmp->force->pair_match("gran/ellipsoid", 1))
    return;
  present_space().reset(new InsertionSpace(lmp));
  present_space()->load(reached, largest_radius);
}

void insert_within(Region* region) {
  if (present_space())
    present_space()->stay_within(region);
}

bool asks_for_room(ParticleToInsert* particle) {
  return present_space() && dynamic_cast<ParticleToInsertEllipsoid*>(particle);
}

bool occupy(const ParticleToInsertEllipsoid& particle, const double* centre,
            const double* quaternion) {
  return present_space()->occupy(particle, centre, quaternion);
}

void random_place(Region* region, ParticleToInsert* particle, double* centre) {
  const auto& body = *dynamic_cast<ParticleToInsertEllipsoid*>(particle);
  // sets of spheres need not reach as far as their semi-axes say to all sides
  const double least =
      body.subspheres > 0 ? 0.0 : *std::min_element(body.shape_ins, body.shape_ins + 3);
  constexpr int most_tries = 50; // a region may have no such point
  for (int k = 0; k < most_tries; ++k) {
    region->generate_random(centre, true);
    if (region->match_shrinkby_cut(centre, least))
      return;
  }
}

int try_orientations(ParticleToInsert* particle, double* centre, double* velocity, double* omega,
                     double* quaternion, NearBodies& near, RanPark* random) {
  auto* body = dynamic_cast<ParticleToInsertEllipsoid*>(particle);
  // while room is easy to find, orientations stay those of random sequential addition
  constexpr int refusals_before = 100;
  if (!present_space() || !body || body->has_orientation ||
      present_space()->count_refusal() <= refusals_before ||
      !present_space()->may_fit(*body, centre))
    return 0;
  constexpr int most_orientations = 29; // besides the first one: bodies of aspect 3.5 then fill a
                                        // region as densely as spheres
  for (int k = 0; k < most_orientations; ++k) {
    MathExtraLiggghts::random_unit_quat(random, quaternion);
    if (const int inserted =
            body->check_near_set_x_v_omega(centre, velocity, omega, quaternion, near))
      return inserted;
  }
  return 0;
}

namespace {

/// Particles of one template, on all ranks.
struct TemplateCount {
  int placed, wanted;
};

/// In the order of the fixes; 0 of those that are no template.
std::vector<TemplateCount> counts_by_template(LAMMPS* lmp, ParticleToInsert** list, int placed,
                                              int wanted) {
  const Modify& modify = *lmp->modify;
  const auto templates = static_cast<std::size_t>(modify.nfix);
  std::vector<TemplateCount> mine(templates), all(templates);
  for (int k = 0; k < wanted; ++k) {
    const auto* particle = dynamic_cast<ParticleToInsertEllipsoid*>(list[k]);
    for (std::size_t t = 0; particle && t < templates; ++t)
      if (particle->source == modify.fix[t]) {
        mine[t].placed += k < placed;
        ++mine[t].wanted;
      }
  }
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(2 * templates), MPI_INT, MPI_SUM,
                lmp->world);
  return all;
}

} // namespace

void report_missing(LAMMPS* lmp, Fix* insertion, ParticleToInsert** list, int placed, int wanted,
                    bool once) {
  if (!lmp->force->pair_match("gran/ellipsoid", 1))
    return;
  const std::vector<TemplateCount> counts = counts_by_template(lmp, list, placed, wanted);
  double all_placed = 0.0, all_wanted = 0.0;
  for (const TemplateCount& count : counts) {
    all_placed += count.placed;
    all_wanted += count.wanted;
  }
  if (all_placed >= all_wanted)
    return;
  std::string missing;
  bool other_composition = false;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    const auto [found, sought] = counts[t];
    if (sought == 0)
      continue;
    missing += (missing.empty() ? "" : ", ") + std::to_string(found) + " of " +
               std::to_string(sought) + " of template '" + lmp->modify->fix[t]->id + "'";
    other_composition =
        other_composition || std::fabs(found - sought * all_placed / all_wanted) > 1.0;
  }
  const std::string message = std::string("Fix ") + insertion->style + " (id " + insertion->id +
                              "): no room for all particles, placed were " + missing +
                              "; use fewer particles, a larger region, or more 'maxattempt'";
  if (once && other_composition)
    lmp->error->all(FLERR, (message + ": the composition is not that of the mixture").c_str());
  if (lmp->comm->me == 0)
    lmp->error->warning(FLERR, message.c_str());
}

} // namespace ellipsoid_host
