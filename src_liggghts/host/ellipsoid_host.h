// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// What several adapters need of the host: values moved between its arrays and the kernel's plain
// types, contact forces added to its force records, arguments read strictly.
#pragma once

#include "error.h"
#include "fix.h"
#include "global_properties.h"
#include "host_contact.h"
#include "math/vector3.h"
#include "property_registry.h"

#include <string>
#include <vector>

namespace ellipsoid_host {

inline ellipsoid::Vector3 vector(const double* v) { return {v[0], v[1], v[2]}; }
inline ellipsoid::Quaternion quaternion(const double* q) { return {q[0], q[1], q[2], q[3]}; }
inline void store(const ellipsoid::Vector3& from, double* to) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}
inline void store(const ellipsoid::Quaternion& from, double* to) {
  to[0] = from.w;
  to[1] = from.x;
  to[2] = from.y;
  to[3] = from.z;
}

/// R of the contact geometry, Markauskas et al. 2010, eq. (19), or eq. (20) for plain spheres
/// (length).
inline double reduced_radius(const LIGGGHTS::ContactModels::SurfacesIntersectData& s) {
  if (s.is_non_spherical)
    return s.reff;
  return s.is_wall ? s.radi : s.radi * s.radj / (s.radi + s.radj);
}

/// How a force at the contact turns plain spheres: a normal force does not.
enum class TorqueArm { none_on_spheres, along_normal_on_spheres };

/// Adds a force on i (and its reaction on j) that acts at the contact point.
inline void add_contact_force(const LIGGGHTS::ContactModels::SurfacesIntersectData& s, double** x,
                              const ellipsoid::Vector3& force, TorqueArm arm,
                              LIGGGHTS::ContactModels::ForceData& i_forces,
                              LIGGGHTS::ContactModels::ForceData& j_forces) {
  using namespace ellipsoid;
  const double share = s.is_wall ? s.area_ratio : 1.0;
  const auto add = [share](LIGGGHTS::ContactModels::ForceData& to, const Vector3& f,
                           const Vector3& lever) {
    const Vector3 torque = cross(lever, f);
    to.delta_F[0] += share * f.x;
    to.delta_F[1] += share * f.y;
    to.delta_F[2] += share * f.z;
    to.delta_torque[0] += share * torque.x;
    to.delta_torque[1] += share * torque.y;
    to.delta_torque[2] += share * torque.z;
  };
  const Vector3 normal = vector(s.en), point = vector(s.contact_point);
  const bool turns = arm == TorqueArm::along_normal_on_spheres;
  const auto lever = [&](int particle, double radial) {
    if (s.is_non_spherical)
      return point - vector(x[particle]);
    return turns ? radial * normal : Vector3{};
  };
  add(i_forces, force, lever(s.i, -s.cri));
  if (!s.is_wall)
    add(j_forces, -force, lever(s.j, s.crj));
}

/// Per type pair, 1/time, finite and >= 0: property/global viscousDampingNormal.
MatrixProperty* viscous_damping_normal(PropertyRegistry& registry, const char* caller, bool sanity);
/// Per type pair, 1/time, finite and >= 0: property/global viscousDampingTangential.
MatrixProperty* viscous_damping_tangential(PropertyRegistry& registry, const char* caller,
                                           bool sanity);

/// Per type pair, force/length, finite and > 0: property/global springStiffnessNormal.
MatrixProperty* spring_stiffness_normal(PropertyRegistry& registry, const char* caller,
                                        bool sanity);
/// Per type pair, force/length, finite and >= 0: property/global springStiffnessTangential.
MatrixProperty* spring_stiffness_tangential(PropertyRegistry& registry, const char* caller,
                                            bool sanity);

/// "Fix" or "Compute", style and id of a command, as messages name it.
struct CommandName {
  const char* kind;
  std::string style, id;
};

/// Reads the arguments of a command one after the other and checks each: every complaint is one
/// line that says the keyword, the given value, the allowed range and the remedy.
class ArgumentReader {
 public:
  /// @param[in] first index of the first argument to read
  ArgumentReader(LAMMPS_NS::Error* error, LAMMPS_NS::Fix* fix, int count, char** arguments,
                 int first)
      : ArgumentReader(error, CommandName{"Fix", fix->style, fix->id}, count, arguments, first) {}
  /// For arguments that are read before the fix exists.
  ArgumentReader(LAMMPS_NS::Error* error, const std::string& style, const std::string& id,
                 int count, char** arguments, int first)
      : ArgumentReader(error, CommandName{"Fix", style, id}, count, arguments, first) {}
  ArgumentReader(LAMMPS_NS::Error* error, const CommandName& name, int count, char** arguments,
                 int first)
      : error_(error), title_(name.kind + (" " + name.style) + " (id " + name.id + "): "),
        count_(count), arguments_(arguments), index_(first) {}

  bool done() const { return index_ >= count_; }
  /// The next argument as a keyword.
  std::string keyword();
  /// The next argument as a value of `keyword`; complains when there is none.
  std::string word(const std::string& keyword);
  /// A whole-token finite number within (or at) the bounds.
  double number(const std::string& keyword, double smallest, double largest);
  /// A finite number > 0.
  double positive(const std::string& keyword);
  /// A whole-token integer within the bounds.
  int integer(const std::string& keyword, int smallest, int largest);
  /// One of the listed words; returns its index.
  int choice(const std::string& keyword, const std::vector<std::string>& options);
  bool yes_no(const std::string& keyword) { return choice(keyword, {"no", "yes"}) == 1; }
  /// Stops with one line.
  [[noreturn]] void complain(const std::string& message) const;

 private:
  LAMMPS_NS::Error* error_;
  std::string title_;
  int count_;
  char** arguments_;
  int index_;
};

} // namespace ellipsoid_host
