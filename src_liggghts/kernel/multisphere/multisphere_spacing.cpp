// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/multisphere_spacing.h"

#include <cmath>
#include <optional>

namespace ellipsoid {

double inscribed_radius(double a, double b, double x) {
  const double focal_squared = (a - b) * (a + b);
  if (a * std::fabs(x) >= focal_squared)
    return a - std::fabs(x);
  return b * std::sqrt(1.0 - x * x / focal_squared); // Markauskas et al. 2010, eq. 4
}

double cutting_plane(double centre_left, double radius_left, double centre_right,
                     double radius_right) {
  return 0.5 * (centre_left + centre_right) + (radius_left - radius_right) *
                                                  (radius_left + radius_right) /
                                                  (2.0 * (centre_right - centre_left));
}

namespace {

/// Spheres that touch to within this share of their radii do not count as overlapping.
constexpr double touching_tolerance = 1e-9;

/// Centres x_0 = 0, x_1 .. x_n from the first distance d_1.
std::vector<double> centres_from_first_distance(double a, int n, double first_distance) {
  std::vector<double> centres{0.0};
  const auto ordinate = [a](double x) { // of the ellipse, in units of b; 0 beyond the vertex
    return x < a ? std::sqrt((1.0 - x / a) * (1.0 + x / a)) : 0.0;
  };
  double distance = first_distance;
  for (int k = 1; k <= n; ++k) {
    const double previous = centres.back();
    centres.push_back(previous + distance);
    distance *= previous < a ? ordinate(centres.back()) / ordinate(previous) : 0.0; // eq. 7
  }
  return centres;
}

/// The equal-ripple construction for a given ripple e. Spheres touch the ellipse's outer parallel
/// curve (distance +e) from within; neighbours cut each other on the inner one (distance -e).
class EqualRipple {
 public:
  EqualRipple(double a, double b, double ripple) : a_(a), b_(b), ripple_(ripple) {}

  double radius(double centre) const { return inscribed_radius(a_, b_, centre) + ripple_; }

  /// Whether the sphere reaches the vertex to within the ripple.
  bool covers_tip(double centre) const { return centre + radius(centre) >= a_ - ripple_; }

  /// Centre of the right neighbour of a sphere that does not cover the tip.
  double next_centre(double centre) const {
    const double tip = centre + radius(centre);
    // A ripple so large that the axis itself lies closer to the ellipse: only the demand that
    // neighbours hang together is left, and they touch.
    if (inscribed_radius(a_, b_, tip) <= ripple_)
      return next_through({tip, 0.0}, tip);
    const double angle = notch_angle(centre);
    return next_through(inner_parallel(angle),
                        a_ * std::cos(angle) * (1.0 - b_ / a_) * (1.0 + b_ / a_));
  }

 private:
  struct Point {
    double x, y;
  };

  /// The gap function is concave in the centre, zero at the present sphere's, positive at the axis
  /// point from which the ellipse's normal passes the notch, negative at the outer vertex: its
  /// other root is the neighbour.
  double next_through(const Point& notch, double below_notch) const {
    const auto gap = [&](double c) { return radius(c) - std::hypot(notch.x - c, notch.y); };
    return bisect(gap, below_notch, a_ + ripple_);
  }

  /// Foot on the ellipse at eccentric angle t, moved inwards by the ripple.
  Point inner_parallel(double t) const {
    const double nx = b_ * std::cos(t), ny = a_ * std::sin(t), scale = ripple_ / std::hypot(nx, ny);
    return {a_ * std::cos(t) - nx * scale, b_ * std::sin(t) - ny * scale};
  }

  /// Eccentric angle of the foot of the notch to the right of the sphere's crest.
  double notch_angle(double centre) const {
    const double crest = std::acos(std::fmin(1.0, a_ * centre / ((a_ - b_) * (a_ + b_)))); // eq. 3
    // Below this angle the inner parallel curve has crossed the axis.
    const double squared = (a_ * ripple_ / b_ - b_) * (a_ * ripple_ / b_ + b_);
    const double smallest =
        squared > 0.0 ? std::asin(std::fmin(1.0, std::sqrt(squared / ((a_ - b_) * (a_ + b_)))))
                      : 0.0;
    const auto outside = [&](double t) {
      const Point q = inner_parallel(t);
      return std::hypot(q.x - centre, q.y) - radius(centre);
    };
    return bisect(outside, smallest, crest);
  }

  double a_, b_, ripple_;
};

/// The centres from 0 to the tip, or nothing if more than n steps are needed.
std::optional<std::vector<double>> reach_tip(const EqualRipple& chain, int n) {
  std::vector<double> centres{0.0};
  while (!chain.covers_tip(centres.back())) {
    if (static_cast<int>(centres.size()) > n)
      return std::nullopt;
    centres.push_back(chain.next_centre(centres.back()));
  }
  return centres;
}

} // namespace

bool neighbours_overlap(const HalfChain& half) {
  for (std::size_t k = 1; k < half.centres.size(); ++k)
    if (!(half.centres[k] - half.centres[k - 1] <
          (1.0 - touching_tolerance) * (half.radii[k - 1] + half.radii[k])))
      return false;
  return true;
}

MultisphereTemplate mirrored(double a, double b, SphereSpacing spacing, const HalfChain& half) {
  MultisphereTemplate chain{a, b, spacing, {}, {}};
  for (std::size_t k = half.centres.size() - 1; k > 0; --k) {
    chain.centres.push_back(-half.centres[k]);
    chain.radii.push_back(half.radii[k]);
  }
  chain.centres.insert(chain.centres.end(), half.centres.begin(), half.centres.end());
  chain.radii.insert(chain.radii.end(), half.radii.begin(), half.radii.end());
  return chain;
}

HalfChain paper_half_chain(double a, double b, int n) {
  const double last_centre = (a - b) * (a + b) / a; // eq. 5
  const auto excess = [&](double first_distance) {  // eq. 8
    return centres_from_first_distance(a, n, first_distance).back() - last_centre;
  };
  // Distances fall from the middle to the end, so d_1 lies between the mean and the whole.
  HalfChain half;
  half.centres = centres_from_first_distance(a, n, bisect(excess, last_centre / n, last_centre));
  half.centres.back() = last_centre;
  for (const double x : half.centres)
    half.radii.push_back(inscribed_radius(a, b, x));
  return half;
}

HalfChain minimax_outline_half_chain(double a, double b, int n) {
  // The smaller the ripple, the more spheres. One sphere alone reaches the tip with (a - b)/2.
  double too_small = 0.0, enough = 0.5 * (a - b);
  for (;;) {
    const double middle = 0.5 * (too_small + enough);
    if (!(middle > too_small && middle < enough))
      break;
    (reach_tip(EqualRipple(a, b, middle), n) ? enough : too_small) = middle;
  }
  const EqualRipple best(a, b, enough);
  HalfChain half;
  half.centres = reach_tip(best, n).value();
  for (const double x : half.centres)
    half.radii.push_back(best.radius(x));
  return half;
}

} // namespace ellipsoid
