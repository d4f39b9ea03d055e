// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "body_files.h"

#include "table.h"

#include <fmt/format.h>

namespace ellipsoid::post {

void write_if_named(const std::string& path, const std::string& text) {
  if (!path.empty())
    write_text(path, text);
}

void write_body_files(const BodyFiles& files, const SphereBody& body, const SphereSet& spheres) {
  write_if_named(files.multisphere, host_multisphere_file(body.spheres));
  if (!files.multisphere.empty() && files.mass > 0.0)
    fmt::print(stderr, "of fix particletemplate/multisphere: {}\n",
               host_multisphere_words(body, files.multisphere, files.mass));
  write_if_named(files.molecule, molecule_file(body, files.mass));
  write_if_named(files.spheres, spheres_csv(spheres));
}

} // namespace ellipsoid::post
