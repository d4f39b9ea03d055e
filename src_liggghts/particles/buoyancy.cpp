// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "buoyancy.h"

#include "atom.h"
#include "ellipsoid/immersed_ellipsoid.h"
#include "ellipsoid_host.h"
#include "error.h"
#include "fix_property_atom.h"
#include "lammps.h"
#include "multisphere/clump_template.h"
#include "multisphere_particles.h"
#include "spin.h"

using ellipsoid::Vector3;

namespace ellipsoid_host {

bool add_buoyancy(LAMMPS_NS::LAMMPS* lmp, int i, int dim, double level, double down, double weight,
                  double* total) {
  if (!are_ellipsoids(lmp))
    return false;
  LAMMPS_NS::Atom& atom = *lmp->atom;
  const LAMMPS_NS::FixPropertyAtom* spacing = subsphere_properties(lmp->modify)[1];
  if (spacing && spacing->vector_atom[i] > ellipsoid::clump_spacing)
    lmp->error->one(FLERR,
                    "fix buoyancy knows ellipsoids and no clumps; leave them out of its group");
  const Vector3 up{dim == 0 ? -down : 0.0, dim == 1 ? -down : 0.0, dim == 2 ? -down : 0.0};
  const ellipsoid::ImmersedPart part = ellipsoid::immersed_part(
      vector(atom.shape[i]), quaternion(atom.quaternion[i]), up, down * (atom.x[i][dim] - level));
  const Vector3 force = weight * part.volume * up;
  store(vector(atom.f[i]) + force, atom.f[i]);
  store(vector(atom.torque[i]) + cross(part.centroid, force), atom.torque[i]);
  total[dim] += -down * weight * part.volume;
  return true;
}

} // namespace ellipsoid_host
