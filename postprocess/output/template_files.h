// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "multisphere_template.h"
#include "surface_mesh.h"

#include <string>

namespace ellipsoid::post {

/// Lines "x y z r" for the host's `fix particletemplate/multisphere ... file NAME`.
std::string host_multisphere_file(const MultisphereTemplate& chain);

/// A LAMMPS molecule file: one atom per sphere with its diameter, as for `fix rigid/small mol`.
std::string molecule_file(const MultisphereTemplate& chain);

/// Columns index, x_m, y_m, z_m, radius_m.
std::string spheres_csv(const MultisphereTemplate& chain);

/// The outer surface of the union of spheres as triangles: the outline turned about the x axis.
SurfaceMesh outline_of_revolution(const MultisphereTemplate& chain);

/// The surface of an ellipsoid about the origin, axes along x, y, z.
SurfaceMesh ellipsoid_surface(const Vector3& semiaxes);

} // namespace ellipsoid::post
