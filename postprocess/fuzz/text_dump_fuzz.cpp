// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// libFuzzer target: any bytes through the text dump reader, the particles and the measures of a
// pile. Broken input may only lead to InputError.
//
//   CC=clang CXX=clang++ cmake -S . -B fuzz -DELLIPSOID_FUZZ=ON
//   cmake --build fuzz --target text_dump_fuzz
//   fuzz/bin/text_dump_fuzz -max_total_time=3600 -timeout=10 WORK postprocess/fuzz/corpus
#include "fuzz_case.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  ellipsoid::post::read_and_measure(std::string(reinterpret_cast<const char*>(bytes), size));
  return 0;
}
