// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "sleeping_pairs.h"

namespace ellipsoid {

namespace {

/// Paths are sums of many terms, which are rounded: so much of a gap is relied upon.
constexpr double trusted_share = 1.0 - 1e-9;

/// The next smaller number of single precision, or one not far below.
float rounded_down(double x) { return static_cast<float>(x * (1.0 - 1.2e-7)); }

} // namespace

void SleepingPairs::begin(std::size_t bodies) {
  size_ = 0;
  bodies_.assign(bodies, Body());
  looks_at_.assign(bodies, never);
}

void SleepingPairs::count(int i, int j) {
  Body& body = bodies_[static_cast<std::size_t>(i)];
  if (body.as_first++ == 0)
    body.first_place = size_;
  ++bodies_[static_cast<std::size_t>(j)].as_second;
  ++size_;
}

void SleepingPairs::make_room() {
  deadlines_.assign(2 * size_, never);
  twins_.resize(deadlines_.size());
  std::size_t end = 0;
  for (Body& body : bodies_) {
    body.begin = end;
    end = body.end();
    body.as_second = 0; // counted anew by connect()
  }
}

void SleepingPairs::connect(std::size_t place, int i, int j) {
  const Body& one = bodies_[static_cast<std::size_t>(i)];
  Body& other = bodies_[static_cast<std::size_t>(j)];
  const std::size_t entry = one.begin + (place - one.first_place), twin = other.end();
  ++other.as_second;
  twins_[entry] = {j, static_cast<std::uint32_t>(twin)};
  twins_[twin] = {i, static_cast<std::uint32_t>(entry)};
}

void SleepingPairs::sleep(std::size_t place, int i, double gap, const Travels& travels) {
  const Body& body = bodies_[static_cast<std::size_t>(i)];
  divide(i, body.begin + (place - body.first_place), trusted_share * gap, travels);
}

/// By their ways in the last step, but a sixth at least for each.
void SleepingPairs::divide(int body, std::size_t entry, double left, const Travels& travels) {
  constexpr double least_share = 1.0 / 6.0;
  const Twin twin = twins_[entry];
  const double way = travels.last(body), both = way + travels.last(twin.body);
  const double share = both > 0.0 ? least_share + (1.0 - 2.0 * least_share) * (way / both) : 0.5;
  const auto set = [&](int of, std::size_t at, double part) {
    const float deadline = rounded_down(travels.path(of) + part);
    deadlines_[at] = deadline;
    float& least = looks_at_[static_cast<std::size_t>(of)];
    least = std::min(least, deadline);
  };
  set(body, entry, share * left);
  set(twin.body, twin.entry, (1.0 - share) * left);
}

} // namespace ellipsoid
