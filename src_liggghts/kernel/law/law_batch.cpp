// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "law/law_batch.h"

#include "vectorised/vector_versions.h"

#include <limits>

namespace ellipsoid {

namespace {

using Columns = ContactLawBatch::Columns;
using C = Columns;

/// What the loops over the contacts hand on (see batch_columns.h).
struct Work {
  enum Value { slip_x, slip_y, slip_z, root, mass, value_count };
  alignas(64) double of[value_count][ContactLawBatch::column_length];
};

/// One contact.
template <class Place> struct ContactAtHand {
  using Vector = typename Place::Vector;
  Columns& c;
  Work& w;
  Place at;

  double in(int column) const { return c.in[column][at.k]; }
  Vector vector_in(int column) const { return at.vector(c.in, column); }

  /// Normal force and tangential velocity.
  void press() const {
    const Vector normal = vector_in(C::nx);
    const Vector velocity =
        vector_in(C::vx) + (cross(at.axial_vector(c.in, C::wix), vector_in(C::lix)) -
                            cross(at.axial_vector(c.in, C::wjx), vector_in(C::ljx)));
    const double normal_velocity = dot(velocity, normal);
    at.put(w.of, Work::slip_x, velocity - normal_velocity * normal);

    const double overlap = in(C::overlap), root = std::sqrt(in(C::radius)*overlap);
    const double elastic = normal_stiffness(in(C::modulus), root) * overlap;
    const double mass = PairMasses{in(C::mass_i), in(C::mass_j)}.effective();
    const double pressing = elastic - in(C::normal_damping)*mass * normal_velocity; // eq. 23
    const double smallest = c.pass.no_attraction ? 0.0 : -std::numeric_limits<double>::infinity();
    c.out[C::normal_force][at.k] = pressing < smallest ? smallest : pressing;
    w.of[Work::root][at.k] = root;
    w.of[Work::mass][at.k] = mass;
  }

  /// advance_spring() without branches: both sides of each are computed, one is taken.
  void advance_spring() const {
    const Vector spring = vector_in(C::sx), normal = vector_in(C::nx);
    const Vector in_plane = spring - dot(spring, normal) * normal;
    const double squared_length = dot(spring, spring), remaining = dot(in_plane, in_plane);
    const double stretch = std::sqrt(squared_length / (remaining > 0.0 ? remaining : 1.0));
    at.put(c.out, C::new_sx,
           (remaining > 0.0 ? stretch : 1.0) * in_plane +
               c.pass.time_step * at.vector(w.of, Work::slip_x)); // eq. 18
  }
  void keep_spring() const { at.put(c.out, C::new_sx, vector_in(C::sx)); }

  /// tangential_force() along the displacement, without branches, and what the contact does.
  void rub() const {
    const double normal_force = c.out[C::normal_force][at.k];
    const double limit = in(C::friction)*std::fabs(normal_force);
    const double stiffness = tangential_stiffness(in(C::shear_modulus), w.of[Work::root][at.k]);
    const double damping = in(C::tangential_damping)*w.of[Work::mass][at.k];
    const Vector spring = at.vector(c.out, C::new_sx);
    const Vector viscous = damping * at.vector(w.of, Work::slip_x);
    const Vector trial = -stiffness * spring - viscous;
    const double magnitude = norm(trial);
    const bool slips = magnitude > limit;
    const Vector friction = (slips ? limit / magnitude : 1.0) * trial; // eq. 24
    at.put(c.out, C::new_sx,
           chosen(slips & (stiffness > 0.0), (-1.0 / stiffness) * (friction + viscous), spring));

    const Vector force = normal_force * vector_in(C::nx) + friction;
    at.put(c.out, C::fx, force);
    at.put(c.out, C::tix, cross(vector_in(C::lix), force));
    at.put(c.out, C::tjx, cross(force, vector_in(C::ljx)));
  }
};

template <class Place> inline void apply_laws(Columns& c, int size) {
  Work w;
  const auto contact = [&c, &w](int k) { return ContactAtHand<Place>{c, w, {k}}; };
  for_items(0, size, [&](int k) { contact(k).press(); });
  if (c.pass.advances_springs)
    for_items(0, size, [&](int k) { contact(k).advance_spring(); });
  else
    for_items(0, size, [&](int k) { contact(k).keep_spring(); });
  for_items(0, size, [&](int k) { contact(k).rub(); });
}

/// Whether the bodies are bodies in the plane that move in it.
inline bool in_plane(const Columns& c, int size) {
  return all_zero(c.in, {C::nz, C::liz, C::ljz, C::vz, C::wix, C::wiy, C::wjx, C::wjy, C::sz},
                  size);
}

inline void law_loop(Columns& c, int size) {
  c.are_in_plane = in_plane(c, size);
  if (c.are_in_plane)
    apply_laws<InPlane>(c, size);
  else
    apply_laws<InSpace>(c, size);
}

ELLIPSOID_VECTOR_VERSIONS(law, Columns)

struct Frames {
  const ContactBatch::Columns& from;
  Columns& to;
};

/// Normals of the law point from j to i.
inline void copy_loop(Frames& frames, int size) {
  using From = ContactBatch::Columns;
  const auto& out = frames.from.out;
  const auto& in = frames.from.in;
  auto& to = frames.to.in;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    for (int l = 0; l < 3; ++l) {
      to[C::nx + l][k] = -out[From::nx + l][k];
      to[C::lix + l][k] = out[From::px + l][k];
      to[C::ljx + l][k] = out[From::px + l][k] - in[From::dx + l][k];
    }
    const double overlap = out[From::overlap][k];
    to[C::overlap][k] = overlap > 0.0 ? overlap : 0.0;
    to[C::radius][k] = out[From::reduced_radius][k];
    to[C::radius_i][k] = out[From::radius_i][k];
    to[C::radius_j][k] = out[From::radius_j][k];
  }
}

ELLIPSOID_VECTOR_VERSIONS(copy, Frames)

} // namespace

void ContactLawBatch::set_frames(const ContactBatch& pairs) {
  resize(pairs.size());
  Frames frames{pairs.columns(), columns_};
  copy(frames, size());
}

void ContactLawBatch::solve(const LawPass& pass) {
  columns_.pass = pass;
  law(columns_, size());
}

} // namespace ellipsoid
