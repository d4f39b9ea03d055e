// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Finds the contacts of one particle with a wall: a class per kind of wall, for smooth ellipsoids
// or for bodies of spheres. One of them is chosen when the wall is defined.
#pragma once

#include "atom.h"
#include "ellipsoid_host.h"
#include "lammps.h"
#include "multisphere_particles.h"
#include "pointers.h"
#include "primitive_wall.h"
#include "wall/cylinder_contact.h"
#include "wall/mesh_contact.h"
#include "wall/plane_contact.h"
#include "wall_meshes.h"

#include <cmath>
#include <vector>

namespace ellipsoid_host {

class WallContactFinder {
 public:
  virtual ~WallContactFinder() = default;
  /// To be called once per time step, on all ranks.
  virtual void begin_step() = 0;
  /// @param[in] particle owned, near the wall
  /// @param[out] contacts cleared first
  virtual void find(int particle, std::vector<ellipsoid::WallContact>& contacts) = 0;
};

class SmoothEllipsoids : private LAMMPS_NS::Pointers {
 public:
  explicit SmoothEllipsoids(LAMMPS_NS::LAMMPS* lmp) : Pointers(lmp) {}
  void begin_step() {}
  ellipsoid::EllipsoidBody body(int i) const { return {semiaxes(i), orientation(i)}; }
  bool may_touch(int i, const ellipsoid::PlaneWall& plane) const {
    return may_touch_plane(semiaxes(i), orientation(i), plane.normal,
                           dot(plane.normal, plane.point));
  }

 private:
  ellipsoid::Vector3 semiaxes(int i) const { return vector(atom->shape[i]); }
  ellipsoid::Quaternion orientation(int i) const { return quaternion(atom->quaternion[i]); }
};

class MultisphereBodies {
 public:
  explicit MultisphereBodies(LAMMPS_NS::LAMMPS* lmp) : particles_(lmp) {}
  void begin_step() { particles_.find_properties(); }
  ellipsoid::MultispherePose body(int i) { return particles_.make_pose(i); }
  bool may_touch(int, const ellipsoid::PlaneWall&) const { return true; }

 private:
  MultisphereParticles particles_;
};

template <class Bodies> class PlaneContactFinder : public WallContactFinder {
 public:
  PlaneContactFinder(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PrimitiveWall& wall)
      : bodies_(lmp), atom_(*lmp->atom), wall_(wall) {}
  void begin_step() override { bodies_.begin_step(); }
  void find(int i, std::vector<ellipsoid::WallContact>& contacts) override {
    contacts.clear();
    double to_wall[3];
    const double distance = wall_.resolveContact(atom_.x[i], 0.0, to_wall);
    if (!(distance <= atom_.radius[i] && distance > 0.0))
      return;
    const ellipsoid::PlaneWall plane{vector(to_wall), (1.0 / distance) * vector(to_wall)};
    if (bodies_.may_touch(i, plane))
      find_plane_contacts(bodies_.body(i), plane, contacts);
  }

 private:
  Bodies bodies_;
  LAMMPS_NS::Atom& atom_;
  LAMMPS_NS::PrimitiveWall& wall_;
};

template <class Bodies> class CylinderContactFinder : public WallContactFinder {
 public:
  /// @param[in] axis 0, 1, 2 for x, y, z
  /// @param[in] centre in space (length)
  CylinderContactFinder(LAMMPS_NS::LAMMPS* lmp, int axis, double radius,
                        const ellipsoid::Vector3& centre)
      : bodies_(lmp), atom_(*lmp->atom), centre_(centre) {
    cylinder_.axis = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    cylinder_.radius = radius;
  }
  void begin_step() override { bodies_.begin_step(); }
  void find(int i, std::vector<ellipsoid::WallContact>& contacts) override {
    contacts.clear();
    cylinder_.centre = centre_ - vector(atom_.x[i]);
    const ellipsoid::Vector3 to_axis =
        cylinder_.centre - dot(cylinder_.centre, cylinder_.axis) * cylinder_.axis;
    if (!(std::fabs(norm(to_axis) - cylinder_.radius) > atom_.radius[i]))
      find_cylinder_contacts(bodies_.body(i), cylinder_, contacts);
  }

 private:
  Bodies bodies_;
  LAMMPS_NS::Atom& atom_;
  ellipsoid::Vector3 centre_;
  ellipsoid::Cylinder cylinder_;
};

template <class Bodies> class MeshContactFinder : public WallContactFinder {
 public:
  /// @param[in] meshes are up to date, and stand at the particle that find() is for
  MeshContactFinder(LAMMPS_NS::LAMMPS* lmp, WallMeshes& meshes) : bodies_(lmp), meshes_(meshes) {}
  void begin_step() override { bodies_.begin_step(); }
  void find(int i, std::vector<ellipsoid::WallContact>& contacts) override {
    contacts.clear();
    if (!meshes_.select([&] { return bodies_.body(i); }))
      return;
    find_mesh_contacts(
        bodies_.body(i), meshes_.triangles(),
        [this](int first, int second) { return meshes_.same_surface(first, second); }, found_);
    contacts.assign(found_.begin(), found_.end());
  }

 private:
  Bodies bodies_;
  WallMeshes& meshes_;
  std::vector<ellipsoid::TriangleContact> found_;
};

} // namespace ellipsoid_host
