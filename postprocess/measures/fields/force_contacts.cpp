// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "force_contacts.h"

#include "listed_particles.h"
#include "particle_columns.h"

namespace ellipsoid::post {
std::vector<ForceContact> force_contacts(const Frame& list, const ForceColumns& columns,
                                         const ParticleSet& set) {
  const ListedParticles particles(list, set);
  const ListedVectors points(list, columns.points, "point of contact"),
      forces(list, columns.forces, "force"), normals(list, columns.normals, "normal");
  std::vector<ForceContact> contacts;
  contacts.reserve(list.rows);
  for (std::size_t row = 0; row < list.rows; ++row) {
    ForceContact contact;
    contact.i = particles.at(columns.ids.front(), row);
    if (columns.ids.size() > 1)
      contact.j = particles.at(columns.ids[1], row);
    contact.point = points.at(row);
    contact.force = forces.at(row).value_or(Vector3{});
    contact.normal = normals.at(row);
    if (contact.normal && !(norm(*contact.normal) > 0.0))
      throw bad_value(list, row, "a normal", "one of length 0");
    if (contact.normal)
      contact.normal = normalized(*contact.normal);
    contacts.push_back(contact);
  }
  return contacts;
}

bool forces_pull(const std::vector<ForceContact>& contacts, const ParticleSet& set,
                 const PeriodicCell& cell) {
  double push = 0.0;
  for (const ForceContact& contact : contacts) {
    const Vector3& centre = set.particles[contact.i].centre;
    if (contact.point)
      push += dot(contact.force, -cell.nearest(*contact.point - centre));
    else if (contact.j)
      push += dot(contact.force, -cell.nearest(set.particles[*contact.j].centre - centre));
  }
  return push < 0.0;
}

} // namespace ellipsoid::post
