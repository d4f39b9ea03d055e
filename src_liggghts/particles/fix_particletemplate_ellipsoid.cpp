// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_particletemplate_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid/ellipsoid_properties.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_clumps_ellipsoid.h"
#include "force.h"
#include "host_pair.h"
#include "host_variants.h"
#include "memory.h"
#include "modify.h"
#include "multisphere/ellipsoid_spheres.h"
#include "multisphere_particles.h"
#include "random_park.h"
#include "whole_number.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;
using ellipsoid_host::store;

namespace {

constexpr long smallest_seed = 10007;     // the host wants primes above 10000
constexpr long largest_seed = 2000000011; // and adds a little for each rank

/// The host's base class reads keywords of its own and wants a density: it is given what it needs
/// (id, group, style, seed and a density that is never used).
class BaseArguments {
 public:
  BaseArguments(LAMMPS* lmp, int narg, char** arg) : words_(arg, arg + std::min(narg, 4)) {
    static char density[] = "density", constant[] = "constant", one[] = "1.0";
    check_seed(lmp->error, arg[0], narg >= 4 ? arg[3] : "");
    words_.insert(words_.end(), {density, constant, one});
  }
  int count() { return static_cast<int>(words_.size()); }
  char** words() { return words_.data(); }

 private:
  std::vector<char*> words_;

  /// The host's generator takes primes only, and its own message does not say whose seed it was.
  static void check_seed(Error* error, const char* id, const char* token) {
    const std::optional<long> seed = ellipsoid_host::whole_integer(token);
    if (seed && *seed >= smallest_seed && *seed <= largest_seed && ellipsoid_host::is_prime(*seed))
      return;
    error->all(FLERR,
               (std::string("Fix particletemplate/ellipsoid (id ") + id + "): the seed is '" +
                token + "', allowed is a prime number from " + std::to_string(smallest_seed) +
                " to " + std::to_string(largest_seed) + ", for example 15485863")
                   .c_str());
  }
};

} // namespace

FixParticletemplateEllipsoid::FixParticletemplateEllipsoid(LAMMPS* lmp, int narg, char** arg)
    : ellipsoid_host::HostTemplate(lmp, BaseArguments(lmp, narg, arg).count(),
                                   BaseArguments(lmp, narg, arg).words()) {
  if (!atom->superquadric_flag)
    error->fix_error(FLERR, this, "needs particles with shape: use atom_style granular/ellipsoid");
  delete pti;
  pti = new ParticleToInsertEllipsoid(lmp);
  parse(narg, arg);
}

FixParticletemplateEllipsoid::~FixParticletemplateEllipsoid() {
  delete pti;
  if (pti_list)
    delete_ptilist();
}

/// What tells multi-sphere particles apart is stored per atom.
void FixParticletemplateEllipsoid::post_create() {
  check_surface();
  if (stores_subspheres_)
    ellipsoid_host::make_subsphere_properties(modify);
  if (!body_.clump())
    return;
  const double size = semiaxes_.y / body_.clump()->semiaxes.y; // coarse graining
  clump_number_ = FixClumpsEllipsoid::find_or_make(modify)->add(
      id, *body_.clump(), (1.0 / (mass_ * size * size)) * principal_moments_);
}

/// Whether the pair style, where it is given already, has a surface for these particles: else the
/// run would say so of the first one that is inserted.
void FixParticletemplateEllipsoid::check_surface() {
  if (ellipsoid_host::has_surface(*force, "multisphere") && subspheres_ == 0)
    error->fix_error(
        FLERR, this,
        "it is smooth (subspheres 0), and pair_style gran/ellipsoid has 'surface "
        "multisphere'; give 'subspheres' or 'clump', or take 'surface smooth' for all");
  if (ellipsoid_host::has_surface(*force, "smooth") && body_.clump())
    error->fix_error(FLERR, this,
                     "keyword 'clump': clumps have no smooth surface; use 'surface multisphere' of "
                     "pair_style gran/ellipsoid");
}

/// The value of fix property/atom `spacing` for the particles of this template.
int FixParticletemplateEllipsoid::spacing_number() const {
  return body_.clump() ? ellipsoid::clump_spacing + clump_number_ : static_cast<int>(spacing_);
}

void FixParticletemplateEllipsoid::parse(int narg, char** arg) {
  ellipsoid_host::ArgumentReader reader(error, this, narg, arg, 4);
  bool has_semiaxes = false, has_moments = false;
  while (!reader.done()) {
    const std::string keyword = reader.keyword();
    if (keyword == "atom_type") {
      atom_type = reader.integer(keyword, 1, atom->ntypes);
    } else if (keyword == "semiaxes") {
      for (double* axis : {&semiaxes_.x, &semiaxes_.y, &semiaxes_.z})
        *axis = reader.positive(keyword);
      has_semiaxes = true;
    } else if (keyword == "vary") {
      variations_.add(reader);
    } else if (keyword == "density") {
      density_ = reader.positive(keyword);
    } else if (keyword == "mass") {
      mass_ = reader.positive(keyword);
    } else if (keyword == "inertia") {
      for (double* moment : {&principal_moments_.x, &principal_moments_.y, &principal_moments_.z})
        *moment = reader.positive(keyword);
      has_moments = true;
    } else if (keyword == "orientation") {
      planar_ = reader.choice(keyword, {"insert", "planar"}) == 1;
    } else if (keyword == "volume_limit") {
      vol_limit = reader.positive(keyword);
    } else if (!parse_spheres(keyword, reader)) {
      reader.complain(
          "unknown keyword '" + keyword +
          "', allowed are 'atom_type', 'semiaxes', 'vary', 'density', 'mass', 'inertia', "
          "'orientation', 'subspheres', 'spacing', 'clump', 'clump_scale', 'write_clump', "
          "'volume_limit'");
    }
  }
  complete(has_semiaxes, has_moments);
}

/// Checks what the keywords are together, and derives what they do not give.
void FixParticletemplateEllipsoid::complete(bool has_semiaxes, bool has_moments) {
  if (!clump_file_.empty())
    make_clump(has_semiaxes, has_moments);
  check_combination(has_semiaxes, has_moments);
  derive_sizes_and_masses(has_moments);
  check_moments();
  if (subspheres_ > 0 && !body_.clump())
    check_spheres();
}

/// Keywords of multi-sphere particles. @return whether it is one of them
bool FixParticletemplateEllipsoid::parse_spheres(const std::string& keyword,
                                                 ellipsoid_host::ArgumentReader& reader) {
  if (keyword == "subspheres") {
    subspheres_ = reader.integer(keyword, 0, ellipsoid::largest_set_count);
    stores_subspheres_ = true;
  } else if (keyword == "spacing") {
    const std::string word = reader.word(keyword);
    try {
      spacing_ = ellipsoid::sphere_spacing_from_word(word);
      has_spacing_ = true;
    } catch (const std::invalid_argument& problem) {
      reader.complain("keyword 'spacing': " + std::string(problem.what()));
    }
  } else if (keyword == "clump") {
    if (!clump_file_.empty())
      reader.complain(
          "keyword 'clump' is given twice; a template is of one clump: use two templates");
    clump_file_ = reader.word(keyword);
  } else if (keyword == "clump_scale") {
    clump_scale_ = reader.positive(keyword);
  } else if (keyword == "write_clump") {
    written_file_ = reader.word(keyword);
  } else {
    return false;
  }
  return true;
}

void FixParticletemplateEllipsoid::check_combination(bool has_semiaxes, bool has_moments) {
  if (clump_file_.empty() && !has_semiaxes)
    error->fix_error(FLERR, this,
                     "keyword 'semiaxes' is missing; add 'semiaxes a b c', or 'clump FILE'");
  if (clump_file_.empty() && (clump_scale_ || !written_file_.empty()))
    error->fix_error(
        FLERR, this,
        "keywords 'clump_scale' and 'write_clump' are for clumps; add 'clump FILE', or "
        "leave them out");
  if ((density_ > 0.0) == (mass_ > 0.0))
    error->fix_error(
        FLERR, this,
        "exactly one of the keywords 'density' and 'mass' is needed; give one of them");
  if (!variations_.all().empty() && (mass_ > 0.0 || has_moments))
    error->fix_error(
        FLERR, this,
        "keyword 'vary' does not go with 'mass' or 'inertia', which belong to one size; "
        "use 'density'");
}

void FixParticletemplateEllipsoid::derive_sizes_and_masses(bool has_moments) {
  semiaxes_ *= ellipsoid_host::coarse_graining(*force, atom_type);
  volume_expect = variations_.mean_volume(body_.volume(semiaxes_));
  if (density_ > 0.0)
    mass_ = density_ * body_.volume(semiaxes_);
  else
    density_ = mass_ / body_.volume(semiaxes_);
  mass_expect = density_ * volume_expect;
  check_volume();
  using ellipsoid::SizeDistribution;
  const auto smallest =
      variations_.varied(semiaxes_, [](const SizeDistribution& d) { return d.smallest(); });
  const auto largest =
      variations_.varied(semiaxes_, [](const SizeDistribution& d) { return d.largest(); });
  smallest_bounding_radius_ = body_.bounding_radius(smallest);
  largest_bounding_radius_ = body_.bounding_radius(largest);
  if (!has_moments)
    principal_moments_ = body_.principal_moments(semiaxes_, mass_);
}

/// The host would say so where the first particles are inserted.
void FixParticletemplateEllipsoid::check_volume() {
  if (volume_expect >= vol_limit)
    return;
  std::ostringstream text;
  text << "the volume of a particle is " << volume_expect << ", keyword 'volume_limit' allows "
       << vol_limit
       << " and more; correct the unit of the lengths, or give a smaller 'volume_limit'";
  error->fix_error(FLERR, this, text.str().c_str());
}

void FixParticletemplateEllipsoid::make_clump(bool has_semiaxes, bool has_moments) {
  const auto complain = [this](const std::string& what) {
    error->fix_error(FLERR, this, ("keyword 'clump': " + what).c_str());
  };
  if (has_semiaxes || stores_subspheres_ || has_spacing_)
    complain("it has its spheres from the file; leave 'semiaxes', 'subspheres' and 'spacing' out");
  if (!variations_.keep_shape())
    complain("a clump keeps its shape; use 'vary all'");
  try {
    body_.read_clump(lmp, clump_file_, clump_scale_.value_or(1.0));
    if (body_.clump()->equal_spheres > 0 && comm->me == 0)
      error->warning(FLERR, ("Fix particletemplate/ellipsoid (id " + std::string(id) + "): file '" +
                             clump_file_ + "': " + std::to_string(body_.clump()->equal_spheres) +
                             " spheres equal an earlier one and are left out")
                                .c_str());
    if (!has_moments && !body_.clump()->is_principal)
      complain("the file says that its frame is the body's, and the centre of mass and the "
               "principal axes of its spheres are others; give 'inertia', or leave the comment '" +
               std::string(ellipsoid::body_frame_mark) + "' out");
    if (!written_file_.empty())
      body_.write_clump(lmp, written_file_,
                        "clump of fix particletemplate/ellipsoid '" + std::string(id) + "'");
  } catch (const std::invalid_argument& problem) {
    complain(problem.what());
  }
  semiaxes_ = body_.clump()->semiaxes;
  subspheres_ = body_.clump()->spheres.count();
  stores_subspheres_ = true;
}

void FixParticletemplateEllipsoid::check_moments() {
  const ellipsoid::Vector3& m = principal_moments_;
  if (m.x > m.y + m.z || m.y > m.x + m.z || m.z > m.x + m.y)
    error->fix_error(
        FLERR, this,
        "keyword 'inertia': one moment is larger than the sum of the two others, which "
        "no rigid body has; correct the values");
}

std::string FixParticletemplateEllipsoid::sphere_chain() const {
  if (body_.clump())
    return "clump " + std::to_string(clump_number_);
  return subspheres_ == 0
             ? "no subspheres"
             : "subspheres " + std::to_string(subspheres_) + " spacing " + word_of(spacing_);
}

void FixParticletemplateEllipsoid::check_spheres() {
  try {
    variations_.check_spheres(semiaxes_, subspheres_, spacing_);
  } catch (const std::invalid_argument& problem) {
    error->fix_error(FLERR, this, ("keyword 'subspheres': " + std::string(problem.what())).c_str());
  }
}

void FixParticletemplateEllipsoid::fill(ParticleToInsertEllipsoid& p,
                                        const std::function<double()>& uniform) const {
  const ellipsoid::Vector3 axes = variations_.varied(
      semiaxes_, [&uniform](const ellipsoid::SizeDistribution& d) { return d.draw(uniform()); });
  const double volume = body_.volume(axes);
  const bool one_size = variations_.all().empty(); // its mass and moments may be given
  p.atom_type = atom_type;
  p.radius_ins[0] = p.r_bound_ins = body_.bounding_radius(axes);
  ellipsoid_host::set_distance_from_borders(p);
  p.density_ins = density_;
  p.volume_ins = volume;
  p.area_ins = body_.surface_area(axes);
  p.mass_ins = one_size ? mass_ : density_ * volume;
  store(axes, p.shape_ins);
  store(one_size ? principal_moments_ : body_.principal_moments(axes, p.mass_ins), p.inertia_ins);
  p.blockiness_ins[0] = p.blockiness_ins[1] = 2.0;
  store(ellipsoid::Vector3{}, p.x_ins[0]);
  store(ellipsoid::Vector3{}, p.v_ins);
  store(ellipsoid::Vector3{}, p.omega_ins);
  p.groupbit = groupbit;
  p.source = const_cast<FixParticletemplateEllipsoid*>(this);
  p.subspheres = subspheres_;
  p.spacing = spacing_number();
}

void FixParticletemplateEllipsoid::randomize(ParticleToInsertEllipsoid& p) {
  fill(p, [this] { return random_insertion->uniform(); });
  p.has_orientation = planar_;
  if (planar_) {
    const double half_angle = M_PI * (random_insertion->uniform() - 0.5);
    p.orientation = {std::cos(half_angle), 0.0, 0.0, std::sin(half_angle)};
  }
}

void FixParticletemplateEllipsoid::randomize_single() {
  randomize(static_cast<ParticleToInsertEllipsoid&>(*pti));
}

void FixParticletemplateEllipsoid::init_ptilist(int n_random_max, const bool,
                                                FixPropertyAtom* const) {
  if (pti_list)
    error->fix_error(FLERR, this,
                     "is used by two insertions at once; define one template for each");
  n_pti_max = n_random_max;
  pti_list = static_cast<ParticleToInsert**>(
      memory->smalloc(static_cast<bigint>(sizeof(ParticleToInsert*)) * n_pti_max, "pti_list"));
  for (int i = 0; i < n_pti_max; ++i)
    pti_list[i] = new ParticleToInsertEllipsoid(lmp);
}

void FixParticletemplateEllipsoid::randomize_ptilist(int n_random, int distribution_groupbit,
                                                     int distorder) {
  for (int i = 0; i < n_random; ++i) {
    randomize(static_cast<ParticleToInsertEllipsoid&>(*pti_list[i]));
    pti_list[i]->groupbit = groupbit | distribution_groupbit;
    ellipsoid_host::set_order(*pti_list[i], distorder);
  }
}

void FixParticletemplateEllipsoid::direct_set_ptlist(const int, const void* const, const int,
                                                     const int) {
  error->fix_error(FLERR, this,
                   "cannot be filled from a file of particles; use fix insert/pack, insert/stream, "
                   "insert/rate/region or insert/drop");
}

unsigned int FixParticletemplateEllipsoid::generate_hash() {
  unsigned int hash = 0, start = static_cast<unsigned int>(seed_orig) * 420001U;
  add_hash_value(atom_type, start, hash);
  for (const double value : {semiaxes_.x, semiaxes_.y, semiaxes_.z, mass_, principal_moments_.x,
                             principal_moments_.y, principal_moments_.z})
    add_hash_value(value, start, hash);
  for (const int value : {static_cast<int>(planar_), subspheres_, spacing_number()})
    add_hash_value(value, start, hash);
  for (const auto& variation : variations_.all()) {
    for (const bool axis : variation.axes)
      add_hash_value(static_cast<int>(axis), start, hash);
    for (const double value :
         {variation.factor.smallest(), variation.factor.largest(), variation.factor.moment(1)})
      add_hash_value(value, start, hash);
  }
  return hash;
}
