// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Random pairs of ellipsoids for the kernel's tests. Every seed is fixed.
#pragma once

#include "ellipsoid/ellipsoid_contact.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace contact_test {

using ellipsoid::EllipsoidShape;
using ellipsoid::Quaternion;
using ellipsoid::Vector3;

enum class Family { prolate, oblate, triaxial };

inline std::string name(Family f) {
  return f == Family::prolate ? "prolate" : f == Family::oblate ? "oblate" : "triaxial";
}

struct Body {
  Vector3 semiaxes;
  Quaternion orientation;
  EllipsoidShape shape;
  double smallest_axis() const { return std::min({semiaxes.x, semiaxes.y, semiaxes.z}); }
};

struct Pair {
  Body i, j;
  Vector3 centre_distance;
  double smallest_axis() const { return std::min(i.smallest_axis(), j.smallest_axis()); }
};

class PairGenerator {
 public:
  explicit PairGenerator(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  Vector3 direction() {
    std::normal_distribution<double> gauss;
    return ellipsoid::normalized(Vector3{gauss(random_), gauss(random_), gauss(random_)});
  }
  Quaternion orientation() {
    std::normal_distribution<double> gauss;
    return ellipsoid::normalized(
        Quaternion{gauss(random_), gauss(random_), gauss(random_), gauss(random_)});
  }

  Body body(Family family, double size, double largest_aspect) {
    const double aspect = log_uniform(1.0, largest_aspect);
    const double middle = log_uniform(1.0, aspect);
    Body b;
    if (family == Family::prolate)
      b.semiaxes = {size * aspect, size, size};
    else if (family == Family::oblate)
      b.semiaxes = {size * aspect, size * aspect, size};
    else
      b.semiaxes = {size * aspect, size * middle, size};
    b.orientation = orientation();
    b.shape = ellipsoid::make_shape(b.semiaxes, b.orientation);
    return b;
  }

  /// A pair whose surfaces overlap by `depth` smaller semi-axes (negative: apart) along the normal
  /// of a randomly chosen touching pose.
  Pair pair(Family family, double largest_aspect, double largest_size_ratio, double depth) {
    Pair p;
    p.i = body(family, 1.0, largest_aspect);
    p.j = body(family, log_uniform(1.0, largest_size_ratio), largest_aspect);
    const Vector3 n = direction();
    const Vector3 touching = (1.0 / ellipsoid::support(p.i.shape, n)) * (p.i.shape.a_matrix * n) +
                             (1.0 / ellipsoid::support(p.j.shape, n)) * (p.j.shape.a_matrix * n);
    p.centre_distance = touching - (depth * p.smallest_axis()) * n;
    return p;
  }

 private:
  std::mt19937_64 random_;
};

/// Overlap and normal by brute force, in long double: phi on a dense grid of directions, then
/// descent with derivatives by finite differences. It shares no formula with the kernel but phi.
class BruteForce {
 public:
  explicit BruteForce(const Pair& p) {
    load(p.i, axes_i_, rotation_i_);
    load(p.j, axes_j_, rotation_j_);
    d_[0] = p.centre_distance.x;
    d_[1] = p.centre_distance.y;
    d_[2] = p.centre_distance.z;
  }

  struct Result {
    long double overlap;
    long double normal[3];
  };

  Result solve(int samples) const {
    std::vector<std::pair<double, Vector3>> grid;
    const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
    for (int k = 0; k < samples; ++k) {
      const double z = 1.0 - (2.0 * k + 1.0) / samples, r = std::sqrt(1.0 - z * z);
      const Vector3 n{r * std::cos(k * golden_angle), r * std::sin(k * golden_angle), z};
      const long double v[3] = {n.x, n.y, n.z};
      grid.emplace_back(static_cast<double>(phi(v)), n);
    }
    std::partial_sort(grid.begin(), grid.begin() + starts, grid.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    Result best = refine(grid[0].second);
    for (std::size_t k = 1; k < starts; ++k) {
      const Result r = refine(grid[k].second);
      if (r.overlap < best.overlap)
        best = r;
    }
    return best;
  }

 private:
  static constexpr std::size_t starts = 5;
  long double axes_i_[3], axes_j_[3], rotation_i_[9], rotation_j_[9], d_[3];

  static void load(const Body& b, long double* axes, long double* r) {
    axes[0] = b.semiaxes.x;
    axes[1] = b.semiaxes.y;
    axes[2] = b.semiaxes.z;
    const Quaternion q = b.orientation;
    const long double w = q.w, x = q.x, y = q.y, z = q.z;
    const long double m[9] = {
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
        2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    std::copy(m, m + 9, r);
  }

  /// Farthest point of a turned ellipsoid along n, through its body frame.
  static long double reach(const long double* axes, const long double* r, const long double* n) {
    long double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const long double c = axes[k] * (r[k] * n[0] + r[3 + k] * n[1] + r[6 + k] * n[2]);
      sum += c * c;
    }
    return std::sqrt(sum);
  }

  long double phi(const long double* n) const {
    return reach(axes_i_, rotation_i_, n) + reach(axes_j_, rotation_j_, n) -
           (n[0] * d_[0] + n[1] * d_[1] + n[2] * d_[2]);
  }

  static void normalise(long double* n) {
    const long double s = 1 / std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; ++k)
      n[k] *= s;
  }

  struct Frame {
    long double n[3], u[3], v[3];
    explicit Frame(const long double* normal) {
      std::copy(normal, normal + 3, n);
      const int k = std::fabs(n[0]) < 0.5L ? 0 : 1;
      long double e[3] = {0, 0, 0};
      e[k] = 1;
      u[0] = n[1] * e[2] - n[2] * e[1];
      u[1] = n[2] * e[0] - n[0] * e[2];
      u[2] = n[0] * e[1] - n[1] * e[0];
      normalise(u);
      v[0] = n[1] * u[2] - n[2] * u[1];
      v[1] = n[2] * u[0] - n[0] * u[2];
      v[2] = n[0] * u[1] - n[1] * u[0];
    }
    void at(long double s, long double t, long double* out) const {
      for (int k = 0; k < 3; ++k)
        out[k] = n[k] + s * u[k] + t * v[k];
      normalise(out);
    }
  };

  long double phi(const Frame& f, long double s, long double t) const {
    long double n[3];
    f.at(s, t, n);
    return phi(n);
  }

  Result refine(const Vector3& start) const {
    long double n[3] = {start.x, start.y, start.z};
    normalise(n);
    long double value = phi(n);
    for (int k = 0; k < 200; ++k) {
      const Frame f(n);
      const long double e = 1e-6L;
      const long double pu = phi(f, e, 0), mu = phi(f, -e, 0), pv = phi(f, 0, e),
                        mv = phi(f, 0, -e), pp = phi(f, e, e), mm = phi(f, -e, -e);
      const long double gu = (pu - mu) / (2 * e), gv = (pv - mv) / (2 * e);
      const long double huu = (pu - 2 * value + mu) / (e * e),
                        hvv = (pv - 2 * value + mv) / (e * e);
      const long double huv = (pp + mm - pu - mu - pv - mv + 2 * value) / (2 * e * e);
      long double s = -gu, t = -gv;
      const long double det = huu * hvv - huv * huv;
      if (det > 0 && huu + hvv > 0) {
        s = -(hvv * gu - huv * gv) / det;
        t = -(huu * gv - huv * gu) / det;
      }
      const long double length = std::sqrt(s * s + t * t);
      if (length > 0.1L) {
        s *= 0.1L / length;
        t *= 0.1L / length;
      }
      bool moved = false;
      for (int halving = 0; halving < 50 && !moved; ++halving, s /= 2, t /= 2) {
        const long double trial = phi(f, s, t);
        if (trial < value) {
          f.at(s, t, n);
          value = trial;
          moved = true;
        }
      }
      if (!moved || length < 1e-13L)
        break;
    }
    return {value, {n[0], n[1], n[2]}};
  }
};

} // namespace contact_test
