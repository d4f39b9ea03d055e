// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "multisphere/multisphere_template.h"
#include "surface_mesh.h"

#include <string>

namespace ellipsoid::post {

/// Lines "x y z r" for the host's `fix particletemplate/multisphere ... file NAME`.
std::string host_multisphere_file(const MultisphereTemplate& chain);

/// What stands beside that file in the host's command: a body of `mass` with the principal moments
/// of the solid ellipsoid.
std::string host_multisphere_words(const MultisphereTemplate& chain, const std::string& file,
                                   double mass);

/// A LAMMPS molecule file: one atom per sphere with its diameter, as for `fix rigid/small mol`.
/// @param[in] mass of the body; its centre and moments (the solid ellipsoid's) are written as well,
///            because LAMMPS would count the overlaps twice. 0: none of them
std::string molecule_file(const MultisphereTemplate& chain, double mass);

/// Columns index, x_m, y_m, z_m, radius_m.
std::string spheres_csv(const MultisphereTemplate& chain);

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
