// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "atom_vec_granular_ellipsoid.h"

#include "atom.h"
#include "comm.h"
#include "ellipsoid/ellipsoid_properties.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_check_particles_ellipsoid.h"
#include "fix_clumps_ellipsoid.h"
#include "fix_property_atom.h"
#include "motion/rigid_body.h"
#include "multisphere/clump_template.h"
#include "multisphere/multisphere_template.h"
#include "multisphere_particles.h"
#include "whole_number.h"

#include <cmath>
#include <string>

using namespace LAMMPS_NS;

namespace {

constexpr int smooth_columns = 16;               // without sub-spheres and image flags
constexpr int data_columns = smooth_columns + 2; // without the image flags
constexpr int image_columns = 3;

double number(Error* error, const char* token, const char* column, const char* atom) {
  const std::optional<double> value = ellipsoid_host::whole_number(token);
  if (!value)
    error->one(FLERR, (std::string("Atoms section, atom ") + atom + ": column " + column +
                       " has the value '" + token + "', allowed is a finite number")
                          .c_str());
  return value.value_or(0.0); // the call above ends the program
}

double positive(Error* error, const char* token, const char* column, const char* atom) {
  const double value = number(error, token, column, atom);
  if (value <= 0.0)
    error->one(FLERR, (std::string("Atoms section, atom ") + atom + ": column " + column +
                       " has the value '" + token + "', allowed is a finite number > 0")
                          .c_str());
  return value;
}

ellipsoid::Quaternion unit_quaternion(Error* error, char** tokens, const char* atom) {
  static const char* const names[4] = {"q0", "q1", "q2", "q3"};
  double q[4], norm2 = 0.0;
  for (int k = 0; k < 4; ++k) {
    q[k] = number(error, tokens[k], names[k], atom);
    norm2 += q[k] * q[k];
  }
  if (std::fabs(norm2 - 1.0) > 1e-6)
    error->one(FLERR, (std::string("Atoms section, atom ") + atom +
                       ": the quaternion q0 q1 q2 q3 is not of unit length; normalise it")
                          .c_str());
  return ellipsoid_host::quaternion(q);
}

/// An integer from 0 to `largest`.
int small_integer(Error* error, const char* token, int largest, const char* column,
                  const char* atom) {
  const double value = number(error, token, column, atom);
  if (value != std::floor(value) || value < 0.0 || value > largest)
    error->one(FLERR, (std::string("Atoms section, atom ") + atom + ": column " + column +
                       " has the value '" + token + "', allowed are integers from 0 to " +
                       std::to_string(largest))
                          .c_str());
  return static_cast<int>(value);
}

} // namespace

AtomVecGranularEllipsoid::AtomVecGranularEllipsoid(LAMMPS* lmp) : AtomVecSuperquadric(lmp) {
  size_data_atom = data_columns;
  xcol_data = 3;
}

void AtomVecGranularEllipsoid::init() {
  AtomVecSuperquadric::init();
  FixClumpsEllipsoid::make_sure(lmp);
  FixCheckParticlesEllipsoid::make_sure(lmp);
}

void AtomVecGranularEllipsoid::expect_data_words(int words) {
  const bool smooth = words == smooth_columns || words == smooth_columns + image_columns;
  size_data_atom = smooth ? smooth_columns : data_columns;
}

void AtomVecGranularEllipsoid::read_subspheres(int i, char** values) {
  const char* id = values[0];
  subspheres_[i] = {
      small_integer(error, values[smooth_columns], ellipsoid::largest_set_count, "N", id),
      small_integer(error, values[smooth_columns + 1],
                    ellipsoid::clump_spacing + ellipsoid::largest_clump_number, "spacing", id)};
  check_chain(subspheres_[i], atom->shape[i], id);
}

/// Checked for smooth surfaces, too: N and spacing go to dumps, which other programs read.
void AtomVecGranularEllipsoid::check_chain(const std::array<int, 2>& chain, const double* axes,
                                           const char* id) const {
  const auto [count, spacing] = chain;
  const auto placed = ellipsoid::sphere_spacing_from_number(spacing);
  std::string problem;
  if (count == 0 || !placed || is_planar(*placed)) // smooth, a clump or another set of spheres
    return;
  if (count > ellipsoid::largest_sphere_count)
    problem = "column N has the value '" + std::to_string(count) + "', allowed are 0 to " +
              std::to_string(ellipsoid::largest_sphere_count);
  else if (count % 2 == 0)
    problem = "column N is " + std::to_string(count) + ", allowed are 0 and odd numbers";
  else if (axes[1] != axes[2])
    problem = "column N is " + std::to_string(count) + ", and b and c differ; allowed is 0";
  else if (count > 3 && placed == ellipsoid::SphereSpacing::paper_touching)
    problem = "column spacing is " + std::to_string(spacing) + ", which is for N = 3, and N is " +
              std::to_string(count) + "; use 0, 1 or 2";
  if (!problem.empty())
    error->one(FLERR, (std::string("Atoms section, atom ") + id + ": " + problem).c_str());
}

void AtomVecGranularEllipsoid::finish_data() {
  size_data_atom = data_columns;
  const int mine = subspheres_.empty() ? 0 : 1;
  int any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (any) {
    const auto properties = ellipsoid_host::make_subsphere_properties(modify);
    for (const auto& [i, values] : subspheres_)
      for (std::size_t k = 0; k < values.size(); ++k)
        properties[k]->vector_atom[i] = values[k];
  }
  subspheres_.clear();
}

void AtomVecGranularEllipsoid::data_atom(double* position, tagint image, char** values) {
  const char* id = values[0];
  const double type = positive(error, values[1], "type", id);
  if (type != std::floor(type) || type > atom->ntypes)
    error->one(FLERR, (std::string("Atoms section, atom ") + id + ": type is '" + values[1] +
                       "', allowed are integers from 1 to " + std::to_string(atom->ntypes))
                          .c_str());
  const double tag = positive(error, id, "id", id);
  if (tag != std::floor(tag) || tag > MAXTAGINT)
    error->one(FLERR, (std::string("Atoms section, atom ") + id + ": column id has the value '" +
                       id + "', allowed is an integer > 0")
                          .c_str());
  static const char* const place_names[3] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) // the host has read these as far as they are numbers
    number(error, values[2 + k], place_names[k], id);
  create_atom(static_cast<int>(type), position);
  const int i = atom->nlocal - 1;
  atom->tag[i] = static_cast<int>(tag);
  atom->image[i] = image;
  static const char* const axis_names[3] = {"a", "b", "c"};
  static const char* const moment_names[3] = {"I1", "I2", "I3"};
  for (int k = 0; k < 3; ++k) {
    atom->shape[i][k] = positive(error, values[5 + k], axis_names[k], id);
    atom->inertia[i][k] = positive(error, values[13 + k], moment_names[k], id);
  }
  ellipsoid_host::store(unit_quaternion(error, values + 8, id), atom->quaternion[i]);
  atom->rmass[i] = positive(error, values[12], "mass", id);
  const ellipsoid::Vector3 axes = ellipsoid_host::vector(atom->shape[i]);
  atom->volume[i] = ellipsoid::volume(axes);
  atom->area[i] = ellipsoid::surface_area(axes);
  atom->radius[i] = ellipsoid::bounding_radius(axes);
  atom->density[i] = atom->rmass[i] / atom->volume[i];
  if (size_data_atom == data_columns)
    read_subspheres(i, values);
  if (subspheres_.count(i) > 0 && subspheres_[i][1] > ellipsoid::clump_spacing)
    atom->radius[i] = norm(axes); // holds any clump; its own is found when the run begins
}

void AtomVecGranularEllipsoid::data_vel(int i, char** values) {
  AtomVecSuperquadric::data_vel(i, values);
  ellipsoid_host::store(
      ellipsoid::angular_momentum(ellipsoid_host::vector(atom->omega[i]),
                                  ellipsoid_host::vector(atom->inertia[i]),
                                  ellipsoid_host::quaternion(atom->quaternion[i])),
      atom->angmom[i]);
}

void AtomVecGranularEllipsoid::pack_data(double** buffer) { pack_data(buffer, 0); }

void AtomVecGranularEllipsoid::pack_data(double** buffer, int tag_offset) {
  const auto properties = ellipsoid_host::subsphere_properties(modify);
  for (int i = 0; i < atom->nlocal; ++i) {
    double* row = buffer[i];
    row[0] = ubuf(atom->tag[i] + tag_offset).d;
    row[1] = ubuf(atom->type[i]).d;
    for (int k = 0; k < 3; ++k) {
      row[2 + k] = atom->x[i][k];
      row[5 + k] = atom->shape[i][k];
      row[13 + k] = atom->inertia[i][k];
    }
    for (int k = 0; k < 4; ++k)
      row[8 + k] = atom->quaternion[i][k];
    row[12] = atom->rmass[i];
    for (std::size_t k = 0; k < properties.size(); ++k)
      row[smooth_columns + k] = properties[k] ? properties[k]->vector_atom[i] : 0.0;
    row[18] = ubuf((atom->image[i] & IMGMASK) - IMGMAX).d;
    row[19] = ubuf((atom->image[i] >> IMGBITS & IMGMASK) - IMGMAX).d;
    row[20] = ubuf((atom->image[i] >> IMG2BITS) - IMGMAX).d;
  }
}

void AtomVecGranularEllipsoid::write_data(FILE* file, int count, double** buffer) {
  const bool smooth = !ellipsoid_host::subsphere_properties(modify)[0];
  const int columns = smooth ? smooth_columns : data_columns;
  for (int i = 0; i < count; ++i) {
    const double* row = buffer[i];
    std::fprintf(file, "%d %d", static_cast<int>(ubuf(row[0]).i), static_cast<int>(ubuf(row[1]).i));
    for (int k = 2; k < columns; ++k)
      std::fprintf(file, " %-1.17g", row[k]);
    for (int k = data_columns; k < data_columns + image_columns; ++k)
      std::fprintf(file, " %d", static_cast<int>(ubuf(row[k]).i));
    std::fprintf(file, "\n");
  }
}
