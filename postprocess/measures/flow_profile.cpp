// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "flow_profile.h"

#include <cmath>

namespace ellipsoid::post {

FlowProfile::FlowProfile(const Vector3& middle, const std::optional<Vector3>& along, double begin,
                         double end, std::size_t count)
    : m_middle(middle), m_along(along), m_begin(begin),
      m_width((end - begin) / static_cast<double>(count)), m_sums(count) {
  for (std::size_t k = 0; k < count; ++k) {
    FlowBin& bin = m_sums[k];
    bin.begin = begin + m_width * static_cast<double>(k);
    bin.end = begin + m_width * static_cast<double>(k + 1);
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
        m_along ? dot(*m_along, passage.position) : norm(passage.position - m_middle);
    const double number = std::floor((coordinate - m_begin) / m_width);
    if (!(number >= 0.0 && number < static_cast<double>(m_sums.size()))) {
      ++m_beyond;
      continue;
    }
    FlowBin& bin = m_sums[static_cast<std::size_t>(number)];
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
  std::vector<FlowBin> means = m_sums;
  for (FlowBin& bin : means)
    for (double* sum : {&bin.speed, &bin.speed_square, &bin.across})
      *sum = bin.mass > 0.0 ? *sum / bin.mass : 0.0;
  return means;
}

} // namespace ellipsoid::post
