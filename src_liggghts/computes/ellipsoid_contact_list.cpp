// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid_contact_list.h"

#include "atom.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "update.h"

#include <string>
#include <utility>

using namespace LAMMPS_NS;
using ellipsoid::Vector3;

enum class EllipsoidContactList::Property : int {
  id,
  pos,
  contact_point,
  normal,
  delta,
  force,
  force_normal,
  force_tangential,
  normal_force_magnitude,
  tangential_force_magnitude,
  reduced_radius,
  contact_area,
  spheres
};

EllipsoidContactList::EllipsoidContactList(ELLIPSOID_COMPUTE_PARAMETERS, ContactPartner partner)
    : HostCompute(ELLIPSOID_COMPUTE_ARGUMENTS), partner_(partner) {
  const std::vector<std::string> words{"id",     "pos",   "contactPoint",  "normal",
                                       "delta",  "force", "force_normal",  "force_tangential",
                                       "fn",     "ft",    "reducedRadius", "contactArea",
                                       "spheres"};
  const ellipsoid_host::CommandName name{"Compute", style, id};
  ellipsoid_host::ArgumentReader reader(error, name, narg, arg, iarg);
  while (!reader.done())
    properties_.push_back(static_cast<Property>(reader.choice("property", words)));
  if (properties_.empty())
    properties_ = {Property::id,          Property::contact_point, Property::normal,
                   Property::delta,       Property::force,         Property::reduced_radius,
                   Property::contact_area};
  local_flag = 1;
  size_local_rows = 0;
  size_local_cols = 0;
  for (const Property property : properties_)
    size_local_cols += width(property);
}

int EllipsoidContactList::width(Property property) const {
  switch (property) {
  case Property::id:
    return partner_ == ContactPartner::wall ? 3 : 2;
  case Property::pos:
    return partner_ == ContactPartner::wall ? 3 : 6;
  case Property::spheres:
    return 2;
  case Property::contact_point:
  case Property::normal:
  case Property::force:
  case Property::force_normal:
  case Property::force_tangential:
    return 3;
  default:
    return 1;
  }
}

void EllipsoidContactList::set_callers(const std::vector<EllipsoidContactCaller*>& callers) {
  if (!atom->tag_enable)
    error->compute_error(FLERR, this, "needs particles with ids; remove 'atom_modify id no'");
  callers_ = callers;
  for (EllipsoidContactCaller* caller : callers_)
    caller->keep_records();
}

void EllipsoidContactList::compute_local() {
  invoked_local = update->ntimestep;
  values_.clear();
  for (std::size_t k = 0; k < callers_.size(); ++k)
    for (ContactRecord record : callers_[k]->records_of(*this, *update, *error))
      if (arrange(record))
        append(record, static_cast<int>(k));
  const std::size_t columns = static_cast<std::size_t>(size_local_cols);
  rows_.resize(values_.size() / columns);
  for (std::size_t row = 0; row < rows_.size(); ++row)
    rows_[row] = &values_[row * columns];
  size_local_rows = static_cast<int>(rows_.size());
  array_local = rows_.data();
}

bool EllipsoidContactList::arrange(ContactRecord& r) const {
  if (!(r.group_mask & groupbit))
    return false;
  if (partner_ == ContactPartner::wall)
    return true;
  if (!r.counts())
    return false;
  if (r.particle_i <= r.particle_j)
    return true;
  std::swap(r.particle_i, r.particle_j);
  std::swap(r.position_i, r.position_j);
  std::swap(r.sphere_i, r.sphere_j);
  r.normal = -r.normal;
  r.force = -r.force;
  return true;
}

void EllipsoidContactList::append(const ContactRecord& record, int caller) {
  for (const Property property : properties_)
    append(record, caller, property);
}

void EllipsoidContactList::append(const Vector3& v) {
  values_.insert(values_.end(), {v.x, v.y, v.z});
}

void EllipsoidContactList::append(const ContactRecord& r, int caller, Property property) {
  const double along = dot(r.force, r.normal); // negative where the contact pushes
  const auto numbers = [this](std::initializer_list<int> list) {
    for (const int number : list)
      values_.push_back(number);
  };
  switch (property) {
  case Property::id:
    if (partner_ == ContactPartner::wall)
      return numbers({r.particle_i, caller + 1, r.particle_j});
    return numbers({r.particle_i, r.particle_j});
  case Property::pos:
    append(r.position_i);
    if (partner_ == ContactPartner::particle)
      append(r.position_j);
    return;
  case Property::contact_point:
    return append(r.point);
  case Property::normal:
    return append(r.normal);
  case Property::delta:
    return values_.push_back(r.overlap);
  case Property::force:
    return append(r.force);
  case Property::force_normal:
    return append(along * r.normal);
  case Property::force_tangential:
    return append(r.force - along * r.normal);
  case Property::normal_force_magnitude:
    return values_.push_back(-along);
  case Property::tangential_force_magnitude:
    return values_.push_back(norm(r.force - along * r.normal));
  case Property::reduced_radius:
    return values_.push_back(r.reduced_radius);
  case Property::contact_area:
    return values_.push_back(r.area);
  case Property::spheres:
    return numbers({r.sphere_i, r.sphere_j});
  }
}

double EllipsoidContactList::memory_usage() {
  return static_cast<double>(values_.capacity() * sizeof(double) +
                             rows_.capacity() * sizeof(double*));
}
