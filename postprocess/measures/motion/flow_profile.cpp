// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "flow_profile.h"

#include <cmath>

namespace ellipsoid::post {

FlowProfile::FlowProfile(const Vector3& middle, const std::optional<Vector3>& along, double begin,
                         double end, std::size_t count)
    : middle_(middle), along_(along), begin_(begin),
      width_((end - begin) / static_cast<double>(count)), sums_(count) {
  for (std::size_t k = 0; k < count; ++k) {
    FlowBin& bin = sums_[k];
    bin.begin = begin + width_ * static_cast<double>(k);
    bin.end = begin + width_ * static_cast<double>(k + 1);
    if (!along)
      bin.area = M_PI * (bin.end * bin.end - bin.begin * bin.begin);
  }
}

FlowProfile FlowProfile::rings(const Vector3& middle, double radius, std::size_t count) {
  return FlowProfile(middle, {}, 0.0, radius, count);
}

FlowProfile FlowProfile::strips(const Vector3& along, double begin, double end, std::size_t count) {
  return FlowProfile({}, along, begin, end, count);
}

void FlowProfile::add(const std::vector<Passage>& passages, double duration) {
  for (const Passage& passage : passages) {
    const double coordinate =
        along_ ? dot(*along_, passage.position) : norm(passage.position - middle_);
    const double number = std::floor((coordinate - begin_) / width_);
    if (!(number >= 0.0 && number < static_cast<double>(sums_.size()))) {
      ++beyond_;
      continue;
    }
    FlowBin& bin = sums_[static_cast<std::size_t>(number)];
    const Vector3 velocity = (1.0 / duration) * passage.way;
    const double speed = dot(velocity, passage.normal);
    (passage.is_forward ? bin.forward : bin.backward) += 1;
    bin.net_mass += passage.is_forward ? passage.mass : -passage.mass;
    bin.mass += passage.mass;
    bin.speed += passage.mass * speed;
    bin.speed_square += passage.mass * speed * speed;
    bin.across += passage.mass * norm(velocity - speed * passage.normal);
  }
}

std::vector<FlowBin> FlowProfile::bins() const {
  std::vector<FlowBin> means = sums_;
  for (FlowBin& bin : means)
    for (double* sum : {&bin.speed, &bin.speed_square, &bin.across})
      *sum = bin.mass > 0.0 ? *sum / bin.mass : 0.0;
  return means;
}

} // namespace ellipsoid::post
