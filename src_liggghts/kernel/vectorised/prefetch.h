// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

namespace ellipsoid {

/// Asks the processor for the cache line of an address, to read it a little later.
///
/// g++ takes a function that does nothing else for one without any effect, and removes the calls of
/// it. The empty asm statement counts as an effect.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");
}

/// The same, to write there.
inline void prefetch_to_write(const void* address) {
  __builtin_prefetch(address, 1);
  asm volatile("");
}

} // namespace ellipsoid
