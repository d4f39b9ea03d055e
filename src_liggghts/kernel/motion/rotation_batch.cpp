// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "motion/rotation_batch.h"

#include "vectorised/batch_columns.h"
#include "vectorised/vector_versions.h"

namespace ellipsoid {

namespace {

using C = RotationBatch::Columns;

/// A body of the batch: on the way its momentum stands where its angular velocity was.
struct Body {
  C& c;
  int k;

  double& value(int column) const { return c.values[column][k]; }
  Quaternion orientation() const {
    return {value(C::qw), value(C::qx), value(C::qy), value(C::qz)};
  }
  Vector3 vector(int column) const { return InSpace{k}.vector(c.values, column); }
  FreeRotation rotation() const { return {orientation(), vector(C::wx)}; }
  Vector3 rate() const { return vector(C::ix); }
  void put(const Quaternion& q, const Vector3& w) const {
    value(C::qw) = q.w;
    value(C::qx) = q.x;
    value(C::qy) = q.y;
    value(C::qz) = q.z;
    InSpace{k}.put(c.values, C::wx, w);
  }

  void begin() const {
    const Quaternion q = orientation();
    FreeRotation r{q, ellipsoid::rotation(q).to_body(vector(C::mx))};
    r.turn_zy(rate(), c.time_step);
    put(r.q, r.m);
  }
  void go_on() const {
    FreeRotation r = rotation();
    r.turn_xyz(rate(), c.time_step);
    put(r.q, r.m);
  }
  void finish() const {
    FreeRotation r = rotation();
    r.q = normalized(r.q);
    put(r.q, r.omega(rate()));
  }
};

/// In three loops (see batch_columns.h).
inline void rotate_loop(C& c, int size) {
  for_items(0, size, [&c](int k) { Body{c, k}.begin(); });
  for_items(0, size, [&c](int k) { Body{c, k}.go_on(); });
  for_items(0, size, [&c](int k) { Body{c, k}.finish(); });
}

} // namespace

void RotationBatch::solve(double time_step) {
  columns_.time_step = time_step;
  WidestVersion<rotate_loop>::run(columns_, size());
}

} // namespace ellipsoid
