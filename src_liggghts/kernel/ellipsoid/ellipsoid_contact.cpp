// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "ellipsoid/ellipsoid_contact.h"

#include "ellipsoid/ellipsoid_overlap.h"
#include "ellipsoid/perram_wertheim.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ellipsoid {

namespace {

/// Symmetric 2x2 matrix in a tangent plane.
struct TangentMatrix {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  double trace() const { return xx + yy; }
  double determinant() const { return xx * yy - xy * xy; }
};

/// Curvatures W^-1 of one body at the surface point with this normal, in the tangent frame.
TangentMatrix curvatures(const EllipsoidShape& shape, const Vector3& normal,
                         const TangentFrame& t) {
  const double s = support(shape, normal);
  const Vector3 point = (1.0 / s) * (shape.a_matrix * normal);
  const double p1 = dot(t.first, point), p2 = dot(t.second, point);
  const Vector3 a_first = shape.a_matrix * t.first, a_second = shape.a_matrix * t.second;
  const TangentMatrix w{(dot(t.first, a_first) - p1 * p1) / s,
                        (dot(t.first, a_second) - p1 * p2) / s,
                        (dot(t.second, a_second) - p2 * p2) / s};
  const double root = s * s / shape.axes_product, inverse = root * root; // 1 / det W
  return {inverse * w.yy, -inverse * w.xy, inverse * w.xx};
}

/// Half the eigenvalues: the gap is half the quadratic form of the curvatures.
RelativeCurvature principal(const TangentMatrix& c) {
  const double mean = 0.5 * c.trace();
  const double larger = mean + std::hypot(0.5 * (c.xx - c.yy), c.xy);
  return {0.5 * c.determinant() / larger, 0.5 * larger};
}

/// A step in the tangent plane.
struct TangentStep {
  Vector3 shift;                // of the normal (rad)
  double length = 0.0;          // of the shift (rad)
  double slope = 0.0;           // derivative of phi along the step (length)
  double predicted_error = 0.;  // of the normal after the step, if the step is a Newton step (rad)
  bool newton = false;          // the Hessian was positive definite and the step not shortened
  bool at_flat_minimum = false; // no slope, and no direction in which phi falls
};

/// The two eigenvalues of the Hessian of phi, and what they say of phi.
struct Convexity {
  double smallest, largest, scale; // scale: the larger magnitude (length)

  explicit Convexity(const OverlapHessian<SymmetricMatrix3>& h) {
    const double mean = 0.5 * h.trace;
    const double radius = std::sqrt(std::max(0.0, mean * mean - h.determinant));
    smallest = mean - radius;
    largest = mean + radius;
    scale = std::fabs(mean) + radius;
  }
  bool is_convex() const { return smallest > tolerance::convexity * scale; }
  /// Flat in one direction at least: rings of equal phi, as coaxial bodies of revolution have.
  bool is_flat() const { return !is_convex() && smallest >= -tolerance::convexity * scale; }
  /// Makes the Hessian safely positive definite; 0 where it already is.
  double shift() const { return is_convex() ? 0.0 : std::fabs(smallest) - smallest + 0.1 * scale; }
};

/// The way down from a point without slope that is no minimum: along the most negative curvature.
/// @param[in] radii W_i + W_j
Vector3 way_off_saddle(const OverlapFunction<Vector3>& f, const SymmetricMatrix3& radii,
                       const Convexity& convexity) {
  const Vector3 tangent = TangentFrame(f.normal).first;
  // (H - largest I) leaves nothing of the other eigenvector
  const Vector3 v = radii * tangent - (f.value + convexity.largest) * tangent;
  const Vector3 across = v - dot(v, f.normal) * f.normal;
  const double length = norm(across);
  return length > tolerance::convexity * convexity.scale ? (1.0 / length) * across : tangent;
}

/// Newton step of phi on the sphere; a shifted (still descending) one where phi is not convex.
TangentStep newton_step(const OverlapFunction<Vector3>& f, const SymmetricMatrix3& radii) {
  const Convexity convexity{OverlapHessian(radii, f.value)};
  const double shift = convexity.shift();
  const OverlapHessian h(radii, f.value - shift);
  TangentStep step;
  step.shift = h.newton_shift(f);
  if (!convexity.is_convex() && norm(f.tangential_gradient()) <= f.noise()) {
    step.at_flat_minimum = convexity.is_flat();
    if (!step.at_flat_minimum)
      step.shift = tolerance::largest_step * way_off_saddle(f, radii, convexity);
  }
  step.length = norm(step.shift);
  step.newton = shift == 0.0 && step.length <= tolerance::largest_step;
  if (step.length > tolerance::largest_step) {
    step.shift *= tolerance::largest_step / step.length;
    step.length = tolerance::largest_step;
  }
  step.slope = dot(f.tangential_gradient(), step.shift);
  step.predicted_error = h.trace * h.trace * h.inverse_determinant * f.radius_change_rate() *
                         step.length * step.length;
  return step;
}

/// Walks along the step, halving it until phi falls enough. Returns false at a dead end
/// (then rounding hides any decrease: f is as good as it gets).
bool line_search(const EllipsoidShape& i, const EllipsoidShape& j, const Vector3& centre_distance,
                 const TangentStep& step, OverlapFunction<Vector3>& f) {
  double share = 1.0;
  for (int halving = 0; halving < tolerance::halving_limit; ++halving, share *= 0.5) {
    const Vector3 n = normalized(f.normal + share * step.shift);
    const OverlapFunction trial(i.a_matrix, j.a_matrix, centre_distance, n);
    if (trial.value <= f.value + tolerance::sufficient_decrease * share * step.slope + f.noise()) {
      f = trial;
      return true;
    }
  }
  return false;
}

/// @param[in] det_sum det(W_i + W_j) at the contact (length^2)
ContactGeometry assemble(const EllipsoidShape& i, const EllipsoidShape& j,
                         const Vector3& centre_distance, const OverlapFunction<Vector3>& f,
                         double det_sum, ContactStatus status, int iterations) {
  ContactGeometry c;
  c.status = status;
  c.normal = f.normal;
  c.overlap = f.value;
  c.iterations = iterations;
  c.point = 0.5 * (f.support_point_i + centre_distance - f.support_point_j);
  // sqrt(det W) = a b c / s^2: the inverse of the Gaussian curvature's root
  c.curvature_radius_i = i.axes_product * f.inverse_support_i * f.inverse_support_i;
  c.curvature_radius_j = j.axes_product * f.inverse_support_j * f.inverse_support_j;
  // Markauskas et al. 2010, eq. 19: 1 / (2 sqrt(A B)), with 4 A B = det(W_i^-1 + W_j^-1)
  c.reduced_radius = c.curvature_radius_i * c.curvature_radius_j / std::sqrt(det_sum);
  return c;
}

/// Local search from one normal; the result is a minimum of phi, or a proof of separation.
ContactGeometry descend(const Vector3& start, const EllipsoidShape& i, const EllipsoidShape& j,
                        const Vector3& centre_distance, const SearchOptions& options) {
  OverlapFunction f(i.a_matrix, j.a_matrix, centre_distance, start);
  const auto finish = [&](const OverlapFunction<Vector3>& at, ContactStatus otherwise,
                          int iterations) {
    return assemble(i, j, centre_distance, at,
                    tangent_determinant(curvature_radii_sum(i.a_matrix, j.a_matrix, at)),
                    at.value < 0.0 ? ContactStatus::separated : otherwise, iterations);
  };
  for (int iteration = 0; iteration < options.newton_limit; ++iteration) {
    if (options.goal == SearchGoal::contact && f.value < 0.0)
      return finish(f, ContactStatus::separated, iteration);
    const SymmetricMatrix3 radii = curvature_radii_sum(i.a_matrix, j.a_matrix, f);
    const TangentStep step = newton_step(f, radii);
    if (step.at_flat_minimum)
      return finish(f, ContactStatus::touching, iteration + 1);
    const bool last = step.newton && step.predicted_error <= tolerance::normal_error;
    if (last && step.length <= tolerance::extrapolated_step)
      return finish(
          extrapolated(i.a_matrix, j.a_matrix, f, OverlapHessian(radii, f.value), step.shift),
          ContactStatus::touching, iteration + 1);
    const bool moved = line_search(i, j, centre_distance, step, f);
    if (last || !moved)
      return finish(f, ContactStatus::touching, iteration + 1);
  }
  return finish(f, ContactStatus::not_converged, options.newton_limit);
}

/// Normal at which both bodies, scaled about their centres by one common factor, just touch. The
/// sign of phi at that normal tells whether the bodies touch at all, whatever their shapes.
Vector3 first_normal(const EllipsoidShape& i, const EllipsoidShape& j,
                     const Vector3& centre_distance) {
  const double length = norm(centre_distance);
  if (!(length > 0.0))
    return {1.0, 0.0, 0.0};
  const Vector3 d = (1.0 / length) * centre_distance;
  double low = 0.0, high = 1.0, lambda = 0.5;
  Vector3 n = d;
  for (int k = 0; k < tolerance::bracket_limit && high - low > tolerance::bracket_width; ++k) {
    n = normalized(PerramWertheim(i.a_matrix, j.a_matrix, d, lambda).y);
    const double s_i = support(i, n), s_j = support(j, n);
    if (s_i + s_j < dot(n, centre_distance))
      return n;
    ((1.0 - lambda) * s_i > lambda * s_j ? low : high) = lambda;
    const double fixed_point = next_lambda(s_i, s_j);
    if (std::fabs(fixed_point - lambda) <= tolerance::bracket_width)
      return n;
    const bool inside = fixed_point > low && fixed_point < high;
    lambda = inside && k % 3 != 2 ? fixed_point : 0.5 * (low + high);
  }
  return n;
}

constexpr int sample_count = 64, best_count = 8;

/// Unit vectors spread evenly over the sphere (golden-angle spiral).
std::array<Vector3, sample_count> spiral_directions() {
  std::array<Vector3, sample_count> directions;
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  for (int k = 0; k < sample_count; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / sample_count, r = std::sqrt(1.0 - z * z);
    directions[static_cast<std::size_t>(k)] = {r * std::cos(k * golden_angle),
                                               r * std::sin(k * golden_angle), z};
  }
  return directions;
}

/// Whether a result is to be preferred: the lower phi, and of equal ones what has converged.
bool is_better(const ContactGeometry& c, const ContactGeometry& best) {
  const bool only_c = c.status == ContactStatus::touching && c.status != best.status;
  const bool only_best = best.status == ContactStatus::touching && c.status != best.status;
  const double equal = tolerance::normal_error * std::fabs(best.overlap);
  return c.overlap < best.overlap + (only_c ? equal : only_best ? -equal : 0.0);
}

/// Deep overlap of slender bodies, where phi may have several minima: descends from the best of
/// many normals and keeps the lowest result.
ContactGeometry search_deep(ContactGeometry best, const EllipsoidShape& i, const EllipsoidShape& j,
                            const Vector3& centre_distance, const SearchOptions& options) {
  static const std::array<Vector3, sample_count> directions = spiral_directions();
  std::array<std::pair<double, int>, sample_count> ranking;
  for (int k = 0; k < sample_count; ++k) {
    const auto index = static_cast<std::size_t>(k);
    ranking[index] = {overlap_along(i, j, centre_distance, directions[index]), k};
  }
  std::partial_sort(ranking.begin(), ranking.begin() + best_count, ranking.end());
  for (int k = 0; k < best_count; ++k) {
    const int direction = ranking[static_cast<std::size_t>(k)].second;
    const ContactGeometry c =
        descend(directions[static_cast<std::size_t>(direction)], i, j, centre_distance, options);
    if (c.status == ContactStatus::separated)
      return c;
    if (is_better(c, best))
      best = c;
  }
  return best;
}

ContactGeometry certify(ContactGeometry c, const EllipsoidShape& i, const EllipsoidShape& j,
                        const Vector3& centre_distance, const SearchOptions& options) {
  if (!std::isfinite(c.overlap)) {
    c.status = ContactStatus::not_a_pose;
    return c;
  }
  return is_settled(c, i, j) ? c : search_deep(c, i, j, centre_distance, options);
}

} // namespace

bool is_settled(const ContactGeometry& found, const EllipsoidShape& i, const EllipsoidShape& j) {
  return found.status == ContactStatus::separated ||
         (found.status == ContactStatus::touching &&
          found.overlap <= i.smallest_curvature_radius + j.smallest_curvature_radius);
}

ContactGeometry find_contact(const EllipsoidShape& i, const EllipsoidShape& j,
                             const Vector3& centre_distance, const SearchOptions& options) {
  return find_contact_from(first_normal(i, j, centre_distance), i, j, centre_distance, options);
}

ContactGeometry find_contact_from(const Vector3& normal_guess, const EllipsoidShape& i,
                                  const EllipsoidShape& j, const Vector3& centre_distance,
                                  const SearchOptions& options) {
  return certify(descend(normal_guess, i, j, centre_distance, options), i, j, centre_distance,
                 options);
}

RelativeCurvature relative_curvature(const EllipsoidShape& i, const EllipsoidShape& j,
                                     const Vector3& normal) {
  const TangentFrame t(normal);
  const TangentMatrix c_i = curvatures(i, normal, t), c_j = curvatures(j, normal, t);
  return principal({c_i.xx + c_j.xx, c_i.xy + c_j.xy, c_i.yy + c_j.yy});
}

RelativeCurvature relative_curvature(const EllipsoidShape& i, const Vector3& normal) {
  return principal(curvatures(i, normal, TangentFrame(normal)));
}

ContactGeometry find_plane_contact(const EllipsoidShape& i, const Vector3& plane_point,
                                   const Vector3& plane_normal) {
  const Vector3 a_n = i.a_matrix * plane_normal;
  const double s = std::sqrt(dot(plane_normal, a_n));
  ContactGeometry c;
  c.normal = plane_normal;
  c.overlap = s - dot(plane_normal, plane_point);
  c.status = c.overlap < 0.0 ? ContactStatus::separated : ContactStatus::touching;
  c.point = (1.0 / s) * a_n - (0.5 * c.overlap) * plane_normal;
  c.curvature_radius_i = i.axes_product / (s * s);
  c.curvature_radius_j = std::numeric_limits<double>::infinity();
  c.reduced_radius = c.curvature_radius_i; // (19) with a flat partner
  return c;
}

} // namespace ellipsoid
