// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Keywords `vary` of fix particletemplate/ellipsoid: random factors on some of the semi-axes.
#pragma once

#include "insertion/size_distribution.h"
#include "math/vector3.h"
#include "multisphere/multisphere_template.h"

#include <array>
#include <vector>

namespace ellipsoid_host {

class ArgumentReader;

class TemplateVariations {
 public:
  /// One keyword: all|a|b|c|bc uniform|gaussian|lognormal first second.
  struct Variation {
    std::array<bool, 3> axes{}; ///< a, b, c
    ellipsoid::SizeDistribution factor;
  };

  /// Reads what stands after the keyword.
  void add(ArgumentReader& reader);
  const std::vector<Variation>& all() const { return variations_; }
  /// Whether sizes vary only, at a fixed shape.
  bool keep_shape() const;

  /// Semi-axes times the factors that value_of(distribution) gives, one for each variation.
  template <class ValueOf>
  ellipsoid::Vector3 varied(const ellipsoid::Vector3& semiaxes, ValueOf value_of) const {
    double axes[3] = {semiaxes.x, semiaxes.y, semiaxes.z};
    for (const Variation& variation : variations_) {
      const double factor = value_of(variation.factor);
      for (std::size_t k = 0; k < 3; ++k)
        if (variation.axes[k])
          axes[k] *= factor;
    }
    return {axes[0], axes[1], axes[2]};
  }
  /// Mean over the random factors.
  /// @param[in] volume without them
  double mean_volume(double volume) const;

  /// @throws std::invalid_argument particles of some size or shape cannot have these spheres
  void check_spheres(const ellipsoid::Vector3& semiaxes, int count,
                     ellipsoid::SphereSpacing spacing) const;

 private:
  std::vector<Variation> variations_;

  void check_set(const ellipsoid::Vector3& semiaxes, int count,
                 ellipsoid::SphereSpacing spacing) const;
  void check_chain(const ellipsoid::Vector3& semiaxes, int count,
                   ellipsoid::SphereSpacing spacing) const;
};

} // namespace ellipsoid_host
