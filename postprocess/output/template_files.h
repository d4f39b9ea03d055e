// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "multisphere/clump.h"
#include "multisphere/multisphere_template.h"
#include "surface_mesh.h"

#include <string>

namespace ellipsoid::post {

/// A body of spheres as files hold it.
struct SphereBody {
  std::string title;
  SphereSet spheres;        ///< about the centre of mass (length)
  SymmetricMatrix3 inertia; ///< of mass 1 about it (length^2)
};

/// A chain; moments are those of the solid ellipsoid.
SphereBody body_of(const MultisphereTemplate& chain);

/// Lines "x y z r" for the host's `fix particletemplate/multisphere ... file NAME`.
std::string host_multisphere_file(const SphereSet& set);

/// What stands beside that file in the host's command: a body of `mass`.
std::string host_multisphere_words(const SphereBody& body, const std::string& file, double mass);

/// A LAMMPS molecule file: one atom per sphere with its diameter, as for `fix rigid/small mol`.
/// @param[in] mass of the body; its centre and moments are written as well, because LAMMPS would
///            count the overlaps twice. 0: none of them
std::string molecule_file(const SphereBody& body, double mass);

/// Columns index, x_m, y_m, z_m, radius_m.
std::string spheres_csv(const SphereSet& set);

/// How finely surfaces are divided.
struct MeshFineness {
  int meridians = 32; ///< corners of a circle about the body's x axis
  int arcs = 24;      ///< chords of the outline per half circle
};

/// The outer surface of the union of spheres as triangles: the outline turned about the x axis.
SurfaceMesh outline_of_revolution(const MultisphereTemplate& chain,
                                  const MeshFineness& fineness = {});

/// The surface of an ellipsoid about the origin, axes along x, y, z.
SurfaceMesh ellipsoid_surface(const Vector3& semiaxes, const MeshFineness& fineness = {});

} // namespace ellipsoid::post
