// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "version_text.h"

#include "math/package_version.h"

#ifdef ELLIPSOID_HAS_CAIRO
#include <cairo.h>
#endif
#ifdef ELLIPSOID_HAS_VTK
#include <vtkVersion.h>
#endif

namespace ellipsoid::post {

std::string version_text() {
  std::string cairo = "none", vtk = "none";
#ifdef ELLIPSOID_HAS_CAIRO
  cairo = cairo_version_string();
#endif
#ifdef ELLIPSOID_HAS_VTK
  vtk = VTK_VERSION;
#endif
  return std::string("liggghts-ellipsoid ") + package_version + "\ncompiler  " + compiler_name() +
         "\ncairo     " + cairo + "\nVTK       " + vtk;
}

} // namespace ellipsoid::post
