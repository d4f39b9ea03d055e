// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Random numbers that depend on (seed, particle, draw) only: the same on any number of ranks, in
// any order, and after a restart.
#pragma once

#include <cstdint>

namespace ellipsoid {

/// SplitMix64 (Steele, Lea, Flood 2014) as a counter-based generator.
class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, std::uint64_t particle)
      : state_(scramble(seed) ^ scramble(particle * golden + 1U)) {}

  /// Uniform in [0, 1).
  double uniform() {
    state_ += golden;
    return static_cast<double>(scramble(state_) >> 11) * 0x1.0p-53;
  }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U;
  std::uint64_t state_;

  static std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
};

} // namespace ellipsoid
