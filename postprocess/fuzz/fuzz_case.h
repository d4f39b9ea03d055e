// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "coordination.h"
#include "frame_rows.h"
#include "memory_bytes.h"
#include "porosity.h"
#include "repose.h"
#include "text_dump.h"

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>

namespace ellipsoid::post {

/// What reading a dump to its end gave.
struct Reading {
  std::size_t frames = 0;
  std::string error;
};

/// @param[in] most_held frames whose rows are text while the reader is ahead of them
inline Reading reading_of(const std::string& text, std::size_t most_held) {
  Reading result;
  std::deque<Frame> held;
  const auto read_until = [&](std::size_t left) {
    for (; held.size() > left; held.pop_front()) {
      read_rows(held.front());
      ++result.frames;
    }
  };
  try {
    TextDumpReader reader(memory_bytes(text), "fuzz");
    try {
      for (Frame frame; reader.next_unread(frame); read_until(most_held))
        held.push_back(frame);
    } catch (const InputError&) {
      read_until(0); // what is wrong in an earlier row comes first
      throw;
    }
    read_until(0);
  } catch (const InputError& error) {
    result.error = error.what();
  }
  return result;
}

/// The same frames and the same error whether rows are read at once or later.
inline void read_at_once_and_later(const std::string& text) {
  const Reading at_once = reading_of(text, 0), later = reading_of(text, 3);
  if (at_once.frames != later.frames || at_once.error != later.error)
    throw std::logic_error("rows read later: " + later.error + ", at once: " + at_once.error);
}

/// Reads a text as a dump and measures its frames as piles (small ones: fuzzing is about many
/// cases). Lets no InputError out; anything else that leaves it is a fault.
/// @return number of whole frames
inline int read_and_measure(const std::string& text) {
  constexpr std::size_t most_particles = 30;
  int frames = 0;
  read_at_once_and_later(text);
  try {
    TextDumpReader reader(memory_bytes(text), "fuzz");
    Frame frame;
    while (reader.next(frame)) {
      ++frames;
      const ParticleSet set = particles_of(frame, {});
      if (set.particles.size() > most_particles || set.spheres.size() > 10 * most_particles)
        continue;
      const PileOptions options;
      const Pile pile = find_pile(set, options, near_pairs(set, options));
      coordination(set, pile.members, find_contacts(set, 0.0), {});
      plane_porosity(pile, options, {}, {});
      repose_angle(pile, options, Flank::right);
    }
  } catch (const InputError&) {
  }
  return frames;
}

} // namespace ellipsoid::post
