// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_reader.h"

#include "text_dump.h"

#ifdef ELLIPSOID_HAS_VTK
#include "vtk_dump.h"
#endif

namespace ellipsoid::post {

bool is_vtk_name(const std::string& path) {
  for (const std::string ending : {".vtk", ".vtu", ".vtp", ".pvtu"})
    if (path.size() > ending.size() &&
        path.compare(path.size() - ending.size(), ending.size(), ending) == 0)
      return true;
  return false;
}

std::unique_ptr<FrameReader> open_frames(const std::string& path) {
  if (!is_vtk_name(path))
    return std::make_unique<TextDumpReader>(path);
#ifdef ELLIPSOID_HAS_VTK
  return std::make_unique<VtkDumpReader>(path);
#else
  throw InputError(path + ": this build reads no VTK files (-DELLIPSOID_VTK=OFF); use a text "
                          "dump, `dump custom`");
#endif
}

} // namespace ellipsoid::post
