// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// One binary runs anywhere: a loop over columns of numbers is compiled for several widths of vector
// instructions, and the widest that the processor has is chosen at run time. No version fuses
// operations, so all give the same results, bit for bit.
#pragma once

namespace ellipsoid {

/// ELLIPSOID_VECTOR_VERSIONS(solve, Columns) defines `const solve_t solve` from the inline function
/// solve_loop(Columns&, int); everything that solve_loop calls must be inline.
#if defined(__x86_64__)
#if defined(__clang__) // which takes the width as a hint of the command line only
#define ELLIPSOID_AVX512 "avx512f,avx512dq,avx512vl"
#else
#define ELLIPSOID_AVX512 "avx512f,avx512dq,avx512vl,prefer-vector-width=512"
#endif
#define ELLIPSOID_VECTOR_VERSIONS(NAME, COLUMNS)                                                   \
  using NAME##_t = void (*)(COLUMNS&, int);                                                        \
  __attribute__((flatten)) void NAME##_plain(COLUMNS& c, int size) { NAME##_loop(c, size); }       \
  __attribute__((flatten, target("avx2"))) void NAME##_avx2(COLUMNS& c, int size) {                \
    NAME##_loop(c, size);                                                                          \
  }                                                                                                \
  __attribute__((flatten, target(ELLIPSOID_AVX512))) void NAME##_avx512(COLUMNS& c, int size) {    \
    NAME##_loop(c, size);                                                                          \
  }                                                                                                \
  NAME##_t NAME##_for_this_processor() {                                                           \
    __builtin_cpu_init();                                                                          \
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&                 \
        __builtin_cpu_supports("avx512vl"))                                                        \
      return NAME##_avx512;                                                                        \
    return __builtin_cpu_supports("avx2") ? NAME##_avx2 : NAME##_plain;                            \
  }                                                                                                \
  const NAME##_t NAME = NAME##_for_this_processor();
#else
#define ELLIPSOID_VECTOR_VERSIONS(NAME, COLUMNS)                                                   \
  using NAME##_t = void (*)(COLUMNS&, int);                                                        \
  const NAME##_t NAME = [](COLUMNS& c, int size) { NAME##_loop(c, size); };
#endif

} // namespace ellipsoid
