// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "fields.h"

#include "body_properties.h"
#include "input_error.h"

#include <Eigen/Dense>

namespace ellipsoid::post {
namespace {

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Vector3d eigen(const Vector3& v) { return {v.x, v.y, v.z}; }
Eigen::Map<const Eigen::Vector3d> vector_at(const FieldSums& sums, std::size_t part) {
  return Eigen::Map<const Eigen::Vector3d>(sums.data() + part);
}
Eigen::Map<const Matrix> matrix_at(const FieldSums& sums, std::size_t part) {
  return Eigen::Map<const Matrix>(sums.data() + part);
}
void put(FieldSums& sums, std::size_t part, const Eigen::Vector3d& v) {
  Eigen::Map<Eigen::Vector3d>(sums.data() + part) = v;
}
void put(FieldSums& sums, std::size_t part, const Matrix& m) {
  Eigen::Map<Matrix>(sums.data() + part) = m;
}
Matrix matrix_of(const SymmetricMatrix3& m) {
  Matrix result;
  result << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return result;
}
Tensor3 tensor_of(const Matrix& m) {
  Tensor3 t;
  Eigen::Map<Matrix>(t.data()) = m;
  return t;
}
Vector3 vector_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

double mass_of(const ParticleSet& set, const Particle& p, double volume,
               const FieldOptions& options) {
  if (options.density)
    return *options.density * volume;
  set.has_masses.require_readable();
  if (!(p.mass > 0.0))
    throw InputError("fields need a column \"mass\" with masses > 0, or --density");
  return p.mass;
}

FieldSums source_of(const ParticleSet& set, const Particle& p, const FieldOptions& options,
                    const Matrix& normals) {
  FieldSums source{};
  const double volume = body_volume(set, p), mass = mass_of(set, p, volume, options);
  const Eigen::Vector3d v = eigen(p.velocity), omega = eigen(p.angular_velocity);
  const Matrix inertia = matrix_of(body_inertia(set, p, mass));
  const Eigen::Vector3d spin = inertia * omega;
  source[field_number] = 1.0;
  source[field_mass] = mass;
  source[field_solid] = volume;
  source[field_spin_energy] = omega.dot(spin);
  put(source, field_momentum, Eigen::Vector3d(mass * v));
  put(source, field_spin, spin);
  put(source, field_momentum_flux, Matrix(mass * v * v.transpose()));
  put(source, field_inertia, inertia);
  put(source, field_spin_flux, Matrix(spin * v.transpose()));
  put(source, field_fabric, Matrix(volume * normals));
  return source;
}

/// Sum of n n over the contacts of each particle.
std::vector<Matrix> normal_dyads(std::size_t count, const std::vector<ForceContact>& contacts) {
  std::vector<Matrix> dyads(count, Matrix::Zero());
  for (const ForceContact& contact : contacts) {
    if (!contact.normal)
      continue;
    const Eigen::Vector3d n = eigen(*contact.normal);
    dyads[contact.i] += n * n.transpose();
    if (contact.j)
      dyads[*contact.j] += n * n.transpose();
  }
  return dyads;
}

/// One particle's part of a contact: f b and tau b along the way b from the contact to its centre
/// (stress: Goldhirsch 2010, with the branch vector of Weinhart et al. 2012).
void add_part(FieldTargets& targets, const Vector3& centre, const Vector3& to_contact,
              const Vector3& force) {
  const Eigen::Vector3d b = eigen(-to_contact), f = eigen(force);
  const Eigen::Vector3d torque = eigen(cross(to_contact, force));
  FieldSums source{};
  put(source, field_contact_stress, Matrix(f * b.transpose()));
  put(source, field_couple_stress, Matrix(torque * b.transpose()));
  targets.add_along(centre, centre + to_contact, source, contact_range);
}

void add_contact(FieldTargets& targets, const ParticleSet& set, const ForceContact& contact,
                 const PeriodicCell& cell) {
  const Vector3& centre = set.particles[contact.i].centre;
  if (!contact.j) {
    if (!contact.point)
      throw InputError("contacts with walls need --wall-point-columns");
    const Vector3 way = cell.nearest(*contact.point - centre);
    add_part(targets, centre, way, contact.force);
    FieldSums source{};
    put(source, field_boundary_force,
        eigen(-contact.force)); // boundary term of Weinhart et al. 2012
    targets.add_at(centre + way, source, boundary_range);
    return;
  }
  const Vector3& other = set.particles[*contact.j].centre;
  if (!contact.point) {
    const Vector3 half = 0.5 * cell.nearest(other - centre);
    add_part(targets, centre, half, contact.force);
    add_part(targets, other, -half, -contact.force);
    return;
  }
  add_part(targets, centre, cell.nearest(*contact.point - centre), contact.force);
  add_part(targets, other, cell.nearest(*contact.point - other), -contact.force);
}

} // namespace

void add_frame(FieldTargets& targets, const ParticleSet& set,
               const std::vector<ForceContact>& contacts, const PeriodicCell& cell,
               const FieldOptions& options) {
  if (set.has_velocities && set.asymmetric_bodies > 0)
    throw InputError("fields of motion need the mass centres of bodies, which are not known from "
                     "the spheres of bodies without symmetry");
  const std::vector<Matrix> dyads = normal_dyads(set.particles.size(), contacts);
  for (std::size_t i = 0; i < set.particles.size(); ++i)
    targets.add_at(set.particles[i].centre, source_of(set, set.particles[i], options, dyads[i]),
                   particle_range);
  for (const ForceContact& contact : contacts)
    add_contact(targets, set, contact, cell);
}

Fields fields_of(const FieldSums& sums) {
  Fields f;
  f.number_density = sums[field_number];
  f.density = sums[field_mass];
  f.solid_fraction = sums[field_solid];
  f.momentum = vector_of(vector_at(sums, field_momentum));
  f.fabric = tensor_of(matrix_at(sums, field_fabric));
  f.contact_stress = f.stress = tensor_of(matrix_at(sums, field_contact_stress));
  f.couple_stress = tensor_of(matrix_at(sums, field_couple_stress));
  f.boundary_force = vector_of(vector_at(sums, field_boundary_force));
  if (!(f.density > 0.0))
    return f;
  const Eigen::Vector3d velocity = vector_at(sums, field_momentum) / f.density;
  const Eigen::Vector3d spin = vector_at(sums, field_spin);
  const Matrix inertia = matrix_at(sums, field_inertia);
  const Eigen::Vector3d omega = inertia.ldlt().solve(spin);
  // sum m v' v' = sum m v v - rho V V, because sum m v' = 0
  const Matrix kinetic =
      matrix_at(sums, field_momentum_flux) - f.density * velocity * velocity.transpose();
  f.velocity = vector_of(velocity);
  f.angular_velocity = vector_of(omega);
  f.temperature = kinetic.trace() / (3.0 * f.density);
  f.rotational_temperature = (sums[field_spin_energy] - omega.dot(spin)) / (3.0 * f.density);
  f.kinetic_stress = tensor_of(kinetic);
  f.stress = tensor_of(matrix_at(sums, field_contact_stress) + kinetic);
  f.couple_stress = tensor_of(matrix_at(sums, field_couple_stress) +
                              matrix_at(sums, field_spin_flux) - spin * velocity.transpose());
  return f;
}

FieldSums turned(const FieldSums& sums, const Rotation3& axes) {
  Matrix r; // rows: the new axes
  r << eigen(axes.column_x).transpose(), eigen(axes.column_y).transpose(),
      eigen(axes.column_z).transpose();
  FieldSums result = sums;
  for (const std::size_t part : {field_momentum, field_spin, field_boundary_force})
    put(result, part, Eigen::Vector3d(r * vector_at(sums, part)));
  for (const std::size_t part : {field_momentum_flux, field_inertia, field_spin_flux, field_fabric,
                                 field_contact_stress, field_couple_stress})
    put(result, part, Matrix(r * matrix_at(sums, part) * r.transpose()));
  return result;
}

} // namespace ellipsoid::post
