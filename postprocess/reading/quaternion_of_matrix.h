// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "math/vector3.h"

namespace ellipsoid::post {

/// Unit quaternion of a rotation matrix (Shepperd 1978): the largest component first, so that
/// nothing cancels. The sign is that with w >= 0.
inline Quaternion quaternion_of(const Rotation3& r) {
  const Vector3 &a = r.column_x, &b = r.column_y, &c = r.column_z;
  const double trace = a.x + b.y + c.z;
  Quaternion q;
  if (trace >= a.x && trace >= b.y && trace >= c.z)
    q = {1.0 + trace, b.z - c.y, c.x - a.z, a.y - b.x};
  else if (a.x >= b.y && a.x >= c.z)
    q = {b.z - c.y, 1.0 + a.x - b.y - c.z, a.y + b.x, c.x + a.z};
  else if (b.y >= c.z)
    q = {c.x - a.z, a.y + b.x, 1.0 + b.y - a.x - c.z, b.z + c.y};
  else
    q = {a.y - b.x, c.x + a.z, b.z + c.y, 1.0 + c.z - a.x - b.y};
  q = normalized(q);
  return q.w < 0.0 ? Quaternion{-q.w, -q.x, -q.y, -q.z} : q;
}

} // namespace ellipsoid::post
