// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "separation/deferred_checks.h"

namespace ellipsoid {

namespace {

/// The next smaller number of single precision, or one not far below.
float rounded_down(double x) { return static_cast<float>(x * (1.0 - 1.2e-7)); }

} // namespace

void DeferredChecks::begin(std::size_t bodies) {
  size_ = 0;
  bodies_.assign(bodies, Body());
  first_deadlines_.assign(bodies, never);
}

void DeferredChecks::count(int i, int j) {
  Body& body = bodies_[static_cast<std::size_t>(i)];
  if (body.as_first++ == 0)
    body.first_index = size_;
  ++bodies_[static_cast<std::size_t>(j)].as_second;
  ++size_;
}

void DeferredChecks::make_room() {
  deadlines_.assign(2 * size_, never);
  twins_.resize(deadlines_.size());
  std::size_t end = 0, most = 0;
  for (Body& body : bodies_) {
    body.begin = end;
    end = body.end();
    most = std::max(most, end - body.begin);
    body.as_second = 0; // counted anew by connect()
  }
  due_.resize(most);
}

void DeferredChecks::connect(std::size_t index, int i, int j) {
  const Body& one = bodies_[static_cast<std::size_t>(i)];
  Body& other = bodies_[static_cast<std::size_t>(j)];
  const std::size_t entry = one.begin + (index - one.first_index), twin = other.end();
  ++other.as_second;
  twins_[entry] = {j, static_cast<std::uint32_t>(twin)};
  twins_[twin] = {i, static_cast<std::uint32_t>(entry)};
}

void DeferredChecks::defer(std::size_t index, int i, double gap, double approach,
                           MotionClocks& clocks) {
  const Body& body = bodies_[static_cast<std::size_t>(i)];
  const std::size_t entry = body.begin + (index - body.first_index);
  const Twin twin = twins_[entry];
  const MotionClocks::Deadlines until = clocks.deadlines(i, twin.body, gap, approach);
  set_deadline(i, entry, until.i);
  set_deadline(twin.body, twin.entry, until.j);
}

void DeferredChecks::set_deadline(int body, std::size_t entry, double time) {
  const float deadline = rounded_down(time);
  deadlines_[entry] = deadline;
  float& first = first_deadlines_[static_cast<std::size_t>(body)];
  first = std::min(first, deadline);
}

} // namespace ellipsoid
