// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "template_variations.h"

#include "ellipsoid_host.h"
#include "multisphere/ellipsoid_spheres.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

using ellipsoid::SizeDistribution;
using ellipsoid::SphereSpacing;
using ellipsoid::Vector3;

namespace ellipsoid_host {

void TemplateVariations::add(ArgumentReader& reader) {
  const std::string keyword = "vary";
  Variation variation;
  const int which = reader.choice(keyword, {"all", "a", "b", "c", "bc"});
  const bool chosen[5][3] = {{true, true, true},
                             {true, false, false},
                             {false, true, false},
                             {false, false, true},
                             {false, true, true}};
  std::copy(chosen[which], chosen[which] + 3, variation.axes.begin());
  const int kind = reader.choice(keyword, {"uniform", "gaussian", "lognormal"});
  if (kind == 0) {
    const double low = reader.positive(keyword);
    variation.factor = {SizeDistribution::Kind::uniform, low,
                        reader.number(keyword, low, HUGE_VAL)};
  } else if (kind == 1) {
    const double mean = reader.positive(keyword);
    const double largest_deviation = 0.999 * mean / SizeDistribution::cut;
    variation.factor = {SizeDistribution::Kind::gaussian, mean,
                        reader.number(keyword, 0.0, largest_deviation)};
  } else {
    constexpr double largest = 3.0; // of the logarithm's mean and standard deviation
    const double mean = reader.number(keyword, -largest, largest);
    variation.factor = {SizeDistribution::Kind::lognormal, mean,
                        reader.number(keyword, 0.0, largest)};
  }
  variations_.push_back(variation);
}

bool TemplateVariations::keep_shape() const {
  return std::all_of(variations_.begin(), variations_.end(), [](const Variation& variation) {
    return variation.axes[0] && variation.axes[1] && variation.axes[2];
  });
}

double TemplateVariations::mean_volume(double volume) const {
  for (const Variation& variation : variations_)
    volume *= variation.factor.moment(
        static_cast<int>(std::count(variation.axes.begin(), variation.axes.end(), true)));
  return volume;
}

void TemplateVariations::check_spheres(const Vector3& semiaxes, int count,
                                       SphereSpacing spacing) const {
  if (ellipsoid::is_planar(spacing))
    check_set(semiaxes, count, spacing);
  else
    check_chain(semiaxes, count, spacing);
}

/// The particles of all extreme sizes must have their spheres.
void TemplateVariations::check_set(const Vector3& semiaxes, int count,
                                   SphereSpacing spacing) const {
  const std::size_t corners = std::size_t{1} << std::min<std::size_t>(variations_.size(), 6);
  for (std::size_t corner = 0; corner < corners; ++corner) {
    std::size_t bits = corner;
    const Vector3 axes = varied(semiaxes, [&bits](const SizeDistribution& factor) {
      const bool is_large = bits % 2 == 1;
      bits /= 2;
      return is_large ? factor.largest() : factor.smallest();
    });
    ellipsoid::make_ellipsoid_spheres(axes, count, spacing);
  }
}

/// Both the most and the least elongated particle must have a chain.
void TemplateVariations::check_chain(const Vector3& semiaxes, int count,
                                     SphereSpacing spacing) const {
  if (semiaxes.y != semiaxes.z)
    throw std::invalid_argument("the semi-axes b and c differ, chains need b = c; use equal ones, "
                                "or 'spacing medial' or 'minimax_volume'");
  double longest = semiaxes.x / semiaxes.y, shortest = longest;
  for (const Variation& variation : variations_) {
    if (variation.axes[1] != variation.axes[2])
      throw std::invalid_argument("'vary b' and 'vary c' make the semi-axes b and c differ, "
                                  "multi-spheres need b = c; use 'vary bc'");
    const SizeDistribution& factor = variation.factor;
    if (variation.axes[0] != variation.axes[1]) {
      const bool on_a = variation.axes[0];
      longest *= on_a ? factor.largest() : 1.0 / factor.smallest();
      shortest *= on_a ? factor.smallest() : 1.0 / factor.largest();
    }
  }
  for (const double aspect : {shortest, longest})
    ellipsoid::make_multisphere(aspect * semiaxes.y, semiaxes.y, count, spacing);
}

} // namespace ellipsoid_host
