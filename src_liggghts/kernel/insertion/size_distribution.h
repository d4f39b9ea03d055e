// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Random factors on the semi-axes of particles, with their exact moments.
#pragma once

#include <cmath>

namespace ellipsoid {

/// A random number > 0 that is drawn from one uniform number, so that any source of those will do.
/// Normal and lognormal ones are cut at `cut` standard deviations of the normal variable.
class SizeDistribution {
 public:
  enum class Kind { constant, uniform, gaussian, lognormal };
  static constexpr double cut = 3.0;

  /// constant: always `first`. uniform: by number, from `first` to `second`. gaussian: mean
  /// `first`, standard deviation `second` (before cutting). lognormal: the logarithm has mean
  /// `first` and standard deviation `second`.
  SizeDistribution(Kind kind = Kind::constant, double first = 1.0, double second = 0.0)
      : kind_(kind), first_(first), second_(second) {}

  double smallest() const { return value(0.0, -cut); }
  double largest() const { return value(1.0, cut); }

  /// @param[in] u uniform in [0, 1)
  double draw(double u) const {
    return value(u, kind_ == Kind::gaussian || kind_ == Kind::lognormal ? cut_normal(u) : 0.0);
  }

  /// Mean of the k-th power, k = 0 to 3.
  double moment(int k) const {
    const double a = first_, b = second_;
    switch (kind_) {
    case Kind::uniform: // (b^(k+1) - a^(k+1)) / ((k + 1) (b - a)) without the division by zero
      return (k == 0   ? 1.0
              : k == 1 ? a + b
              : k == 2 ? a * a + a * b + b * b
                       : (a + b) * (a * a + b * b)) /
             (k + 1);
    case Kind::gaussian: {
      const double square = b * b * (1.0 - 2.0 * cut * density(cut) / mass_within());
      return k == 0 ? 1.0 : k == 1 ? a : k == 2 ? a * a + square : a * (a * a + 3.0 * square);
    }
    case Kind::lognormal:
      return std::exp(k * a + 0.5 * k * k * b * b) * (below(cut - k * b) - below(-cut - k * b)) /
             mass_within();
    default:
      return std::pow(a, k);
    }
  }

 private:
  Kind kind_;
  double first_, second_;

  static double below(double z) { return 0.5 * std::erfc(-z * std::sqrt(0.5)); }
  static double density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * M_PI); }
  static double mass_within() { return below(cut) - below(-cut); }

  /// Standard normal variable, cut, of a uniform one: Newton's method within a bracket.
  static double cut_normal(double u) {
    const double wanted = below(-cut) + u * mass_within();
    double low = -cut, high = cut, z = 0.0;
    for (int step = 0; step < 60; ++step) {
      const double excess = below(z) - wanted;
      (excess > 0.0 ? high : low) = z;
      const double next = z - excess / density(z);
      const double inside = next > low && next < high ? next : 0.5 * (low + high);
      const bool converged = std::fabs(inside - z) < 1e-15;
      z = inside;
      if (converged)
        break;
    }
    return z;
  }

  double value(double u, double z) const {
    switch (kind_) {
    case Kind::uniform:
      return first_ + u * (second_ - first_);
    case Kind::gaussian:
      return first_ + z * second_;
    case Kind::lognormal:
      return std::exp(first_ + z * second_);
    default:
      return first_;
    }
  }
};

} // namespace ellipsoid
