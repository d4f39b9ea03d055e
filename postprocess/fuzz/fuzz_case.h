// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "coordination.h"
#include "porosity.h"
#include "repose.h"
#include "text_dump.h"

#include <cstdint>
#include <string>

namespace ellipsoid::post {

/// Reads a text as a dump and measures its frames as piles (small ones: fuzzing is about many
/// cases). Lets no InputError out; anything else that leaves it is a fault.
/// @return number of whole frames
inline int read_and_measure(const std::string& text) {
  constexpr std::size_t most_particles = 30;
  int frames = 0;
  try {
    TextDumpReader reader(memory_bytes(text), "fuzz");
    Frame frame;
    while (reader.next(frame)) {
      ++frames;
      const ParticleSet set = particles_of(frame, {});
      if (set.particles.size() > most_particles || set.spheres.size() > 10 * most_particles)
        continue;
      const PileOptions options;
      const Pile pile = find_pile(set, options);
      coordination(set, pile.members, {});
      plane_porosity(pile, options, {}, {});
      repose_angle(pile, options, Flank::right);
    }
  } catch (const InputError&) {
  }
  return frames;
}

} // namespace ellipsoid::post
