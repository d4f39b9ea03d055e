// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// One binary runs anywhere: a loop over columns of numbers is compiled for several widths of vector
// instructions, and the widest that the processor has is chosen at run time. No version fuses
// operations, so all give the same results, bit for bit.
#pragma once

namespace ellipsoid {

#if defined(__clang__) // which takes the width as a hint of the command line only
#define ELLIPSOID_AVX512 "avx512f,avx512dq,avx512vl"
#else
#define ELLIPSOID_AVX512 "avx512f,avx512dq,avx512vl,prefer-vector-width=512"
#endif

/// WidestVersion<loop>::run(data, count) calls loop(data, count): an inline function, all of whose
/// callees are inline, too.
template <auto loop> struct WidestVersion;

template <class Data, void (*loop)(Data&, int)> struct WidestVersion<loop> {
  static void run(Data& data, int count) {
    static const Version widest = choose();
    widest(data, count);
  }

 private:
  using Version = void (*)(Data&, int);

  __attribute__((flatten)) static void plain(Data& data, int count) { loop(data, count); }
#if defined(__x86_64__)
  __attribute__((flatten, target("avx2"))) static void avx2(Data& data, int count) {
    loop(data, count);
  }
  __attribute__((flatten, target(ELLIPSOID_AVX512))) static void avx512(Data& data, int count) {
    loop(data, count);
  }
  static Version choose() {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      return avx512;
    return __builtin_cpu_supports("avx2") ? avx2 : plain;
  }
#else
  static Version choose() { return plain; }
#endif
};

} // namespace ellipsoid
