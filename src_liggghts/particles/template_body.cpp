// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "template_body.h"

#include "comm.h"
#include "ellipsoid/ellipsoid_properties.h"
#include "lammps.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ellipsoid_host {

namespace {

/// The bytes of a file. A folder can be opened, but reading it fails: that is told, too.
std::string content_of(const std::string& file, std::string& problem) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  if (stream)
    content << stream.rdbuf();
  if (!stream || (stream.peek(), stream.bad()))
    problem = std::string("it cannot be read: ") + std::strerror(errno);
  else if (content.str().empty())
    problem = "it is empty; lines x y z r are needed";
  return content.str();
}

/// From the first rank to all.
void share(MPI_Comm world, std::string& text) {
  int size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, world);
}

} // namespace

void TemplateBody::read_clump(LAMMPS_NS::LAMMPS* lmp, const std::string& file, double scale) {
  std::string problem, content;
  if (lmp->comm->me == 0)
    content = content_of(file, problem);
  share(lmp->world, problem);
  share(lmp->world, content);
  try {
    if (!problem.empty())
      throw std::invalid_argument(problem);
    ellipsoid::SphereList list = ellipsoid::parse_sphere_list(content);
    for (ellipsoid::Vector3& centre : list.spheres.centres)
      centre *= scale;
    for (double& radius : list.spheres.radii)
      radius *= scale;
    clump_ = ellipsoid::make_clump(list);
  } catch (const std::invalid_argument& what) {
    throw std::invalid_argument("file '" + file + "': " + what.what());
  }
}

void TemplateBody::write_clump(LAMMPS_NS::LAMMPS* lmp, const std::string& file,
                               const std::string& title) const {
  if (lmp->comm->me != 0)
    return;
  ellipsoid::SphereSet set = clump_->spheres;
  for (ellipsoid::Vector3& centre : set.centres)
    centre *= clump_->semiaxes.y;
  for (double& radius : set.radii)
    radius *= clump_->semiaxes.y;
  std::ofstream stream(file);
  stream << ellipsoid::body_frame_list(set, title);
  stream.close();
  if (!stream)
    throw std::invalid_argument("file '" + file + "' cannot be written: " + std::strerror(errno));
}

double TemplateBody::volume(const ellipsoid::Vector3& semiaxes) const {
  if (!clump_)
    return ellipsoid::volume(semiaxes);
  const double s = size(semiaxes);
  return s * s * s * clump_->volume;
}

double TemplateBody::surface_area(const ellipsoid::Vector3& semiaxes) const {
  if (!clump_)
    return ellipsoid::surface_area(semiaxes);
  return size(semiaxes) * size(semiaxes) * clump_->surface;
}

double TemplateBody::bounding_radius(const ellipsoid::Vector3& semiaxes) const {
  return clump_ ? size(semiaxes) * clump_->bounding_radius : ellipsoid::bounding_radius(semiaxes);
}

ellipsoid::Vector3 TemplateBody::principal_moments(const ellipsoid::Vector3& semiaxes,
                                                   double mass) const {
  if (!clump_)
    return ellipsoid::principal_moments(semiaxes, mass);
  const double s = size(semiaxes);
  return (mass * s * s / clump_->volume) * clump_->moments;
}

} // namespace ellipsoid_host
