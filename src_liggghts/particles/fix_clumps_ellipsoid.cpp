// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fix_clumps_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "host_pair.h"
#include "modify.h"
#include "multisphere_particles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

using namespace LAMMPS_NS;
using ellipsoid::clump_spacing;
using ellipsoid_host::vector;

namespace {

constexpr double same_moments = 1e-5; // relative; data files may have six digits

/// Numbers and words in a row, for restart files.
class Row {
 public:
  void put(double value) { values_.push_back(value); }
  void put(const ellipsoid::Vector3& v) { values_.insert(values_.end(), {v.x, v.y, v.z}); }
  void put(const std::string& word) {
    put(static_cast<double>(word.size()));
    for (const char c : word)
      put(static_cast<double>(c));
  }
  const std::vector<double>& values() const { return values_; }

 private:
  std::vector<double> values_;
};

class RowReader {
 public:
  explicit RowReader(const char* bytes) : bytes_(bytes) {}
  double number() {
    double value;
    std::memcpy(&value, bytes_, sizeof value);
    bytes_ += sizeof value;
    return value;
  }
  ellipsoid::Vector3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  std::string word() {
    std::string found(static_cast<std::size_t>(number()), ' ');
    for (char& c : found)
      c = static_cast<char>(number());
    return found;
  }

 private:
  const char* bytes_;
};

} // namespace

FixClumpsEllipsoid* FixClumpsEllipsoid::find(Modify* modify) {
  const int index = modify->find_fix("clumps_ellipsoid");
  return index < 0 ? nullptr : dynamic_cast<FixClumpsEllipsoid*>(modify->fix[index]);
}

FixClumpsEllipsoid* FixClumpsEllipsoid::find_or_make(Modify* modify) {
  if (!find(modify)) {
    static char id[] = "clumps_ellipsoid", all[] = "all", style[] = "clumps/ellipsoid";
    char* arguments[] = {id, all, style};
    modify->add_fix(3, arguments);
  }
  return find(modify);
}

void FixClumpsEllipsoid::make_sure(LAMMPS* lmp) {
  const auto properties = ellipsoid_host::subsphere_properties(lmp->modify);
  if (!properties[1] || find(lmp->modify))
    return;
  const double *begin = properties[1]->vector_atom, *end = begin + lmp->atom->nlocal;
  int mine = std::any_of(begin, end, [](double spacing) { return spacing > clump_spacing; });
  int any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp->world);
  if (any)
    find_or_make(lmp->modify);
}

FixClumpsEllipsoid::FixClumpsEllipsoid(LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg) {
  if (narg > 3)
    error->fix_error(FLERR, this, "takes no arguments after its style; remove them");
  restart_global = 1;
}

int FixClumpsEllipsoid::setmask() { return FixConst::PRE_EXCHANGE; }

int FixClumpsEllipsoid::add(const std::string& name, const ellipsoid::ClumpTemplate& clump,
                            const ellipsoid::Vector3& moments_per_mass) {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const Entry& known = entries_[k];
    if (known.name != name)
      continue;
    if (!are_same(known.clump, clump) ||
        norm(known.moments_per_mass - moments_per_mass) > same_moments * norm(moments_per_mass))
      error->all(FLERR, ("Fix particletemplate/ellipsoid (id " + name +
                         "): another clump of this name is there, from the restart file or an "
                         "earlier template, with other spheres or moments; give the template "
                         "another id, or the clump of before")
                            .c_str());
    return static_cast<int>(k) + 1;
  }
  entries_.push_back(
      {name, clump, moments_per_mass, std::make_unique<ellipsoid::MultisphereBody>(clump.spheres)});
  return static_cast<int>(entries_.size());
}

const FixClumpsEllipsoid::Entry& FixClumpsEllipsoid::entry(int spacing) const {
  const int number = spacing - clump_spacing;
  if (number < 1 || number > static_cast<int>(entries_.size()))
    throw std::invalid_argument("clump " + std::to_string(number) + " (spacing " +
                                std::to_string(spacing) + ") is not known, there are " +
                                std::to_string(entries_.size()) +
                                "; give the templates with keyword 'clump' first, in the order in "
                                "which they were numbered");
  return entries_[static_cast<std::size_t>(number - 1)];
}

const ellipsoid::ClumpTemplate& FixClumpsEllipsoid::clump(int spacing) const {
  return entry(spacing).clump;
}

const ellipsoid::MultisphereBody* FixClumpsEllipsoid::body(int spacing, int count,
                                                           const double* semiaxes) const {
  const Entry& found = entry(spacing);
  if (found.clump.spheres.count() != count)
    throw std::invalid_argument("clump '" + found.name + "' has " +
                                std::to_string(found.clump.spheres.count()) +
                                " spheres, the particle has subspheres " + std::to_string(count) +
                                "; give the templates in the order in which they were numbered");
  if (!has_shape_of(found.clump, vector(semiaxes)))
    throw std::invalid_argument(
        "the semi-axes are not those of clump '" + found.name +
        "' in any size; 'set ... shape' does not change a clump, and templates have to be given in "
        "the order in which they were numbered");
  return found.body.get();
}

void FixClumpsEllipsoid::init() {
  if (!entries_.empty() && ellipsoid_host::has_surface(*force, "smooth"))
    error->all(FLERR, "pair_style gran/ellipsoid: clumps have no smooth surface; use 'surface "
                      "multisphere'");
  settle();
}

/// Bounding sphere, volume and density are those of the clump, also where a data file does not say
/// them; moments that an ellipsoid would have are refused.
void FixClumpsEllipsoid::settle() {
  const auto properties = ellipsoid_host::subsphere_properties(modify);
  if (!properties[0] || !properties[1])
    return;
  for (int i = 0; i < atom->nlocal; ++i) {
    const int spacing = static_cast<int>(std::lround(properties[1]->vector_atom[i]));
    if (spacing > clump_spacing)
      settle(i, static_cast<int>(std::lround(properties[0]->vector_atom[i])), spacing);
  }
}

void FixClumpsEllipsoid::settle(int i, int count, int spacing) {
  try {
    body(spacing, count, atom->shape[i]);
    const Entry& found = entry(spacing);
    const double size = atom->shape[i][1] / found.clump.semiaxes.y;
    const ellipsoid::Vector3 moments = atom->rmass[i] * size * size * found.moments_per_mass;
    if (norm(vector(atom->inertia[i]) - moments) > same_moments * norm(moments))
      throw std::invalid_argument("the moments are not those of clump '" + found.name +
                                  "'; 'set ... density' and 'set ... shape' make those of an "
                                  "ellipsoid, clumps are made by their template");
    atom->radius[i] = size * found.clump.bounding_radius;
    atom->volume[i] = size * size * size * found.clump.volume;
    atom->area[i] = size * size * found.clump.surface;
    atom->density[i] = atom->rmass[i] / atom->volume[i];
  } catch (const std::invalid_argument& problem) {
    error->one(FLERR, ("atom " + std::to_string(atom->tag[i]) + ": " + problem.what()).c_str());
  }
}

void FixClumpsEllipsoid::write_restart(FILE* file) {
  if (comm->me != 0)
    return;
  Row row;
  row.put(static_cast<double>(entries_.size()));
  for (const Entry& entry : entries_) {
    const ellipsoid::ClumpTemplate& clump = entry.clump;
    row.put(entry.name);
    for (const ellipsoid::Vector3& v : {clump.semiaxes, clump.moments, entry.moments_per_mass})
      row.put(v);
    for (const double value : {clump.bounding_radius, clump.volume, clump.surface,
                               static_cast<double>(clump.spheres.count())})
      row.put(value);
    for (std::size_t k = 0; k < clump.spheres.centres.size(); ++k) {
      row.put(clump.spheres.centres[k]);
      row.put(clump.spheres.radii[k]);
    }
  }
  const int size = static_cast<int>(row.values().size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, file);
  fwrite(row.values().data(), 1, static_cast<std::size_t>(size), file);
}

void FixClumpsEllipsoid::restart(ELLIPSOID_RESTART_PARAMETERS) {
  RowReader row(buffer);
  entries_.clear();
  const int count = static_cast<int>(row.number());
  for (int n = 0; n < count; ++n) {
    Entry entry;
    ellipsoid::ClumpTemplate& clump = entry.clump;
    entry.name = row.word();
    for (ellipsoid::Vector3* v : {&clump.semiaxes, &clump.moments, &entry.moments_per_mass})
      *v = row.vector();
    for (double* value : {&clump.bounding_radius, &clump.volume, &clump.surface})
      *value = row.number();
    const int spheres = static_cast<int>(row.number());
    for (int k = 0; k < spheres; ++k) {
      clump.spheres.centres.push_back(row.vector());
      clump.spheres.radii.push_back(row.number());
    }
    entry.body = std::make_unique<ellipsoid::MultisphereBody>(clump.spheres);
    entries_.push_back(std::move(entry));
  }
}
