// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The fuzzing corpus and its mutations by a fixed generator: no crash, no hang, no exception but
// InputError. (postprocess/fuzz holds the target for a fuzzing engine.)
#include "../../postprocess/fuzz/fuzz_case.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace ellipsoid::post {
namespace {

std::vector<std::string> corpus() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(__FILE__).parent_path() / "../../postprocess/fuzz/corpus"))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

std::string mutated(std::string text, std::mt19937& generator) {
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(generator);
  };
  static const std::vector<std::string> pieces = {"1e308",  "-", "nan", "\n",     " ",  "0",
                                                  "1e-308", "9", ".",   "ITEM: ", "\0", "1e18"};
  for (std::size_t change = 0; change <= below(4) && !text.empty(); ++change) {
    const std::size_t place = below(text.size());
    switch (below(4)) {
    case 0:
      text[place] = static_cast<char>(below(256));
      break;
    case 1:
      text.erase(place, 1 + below(20));
      break;
    case 2:
      text.insert(place, pieces[below(pieces.size())]);
      break;
    default:
      text.resize(place);
    }
  }
  return text;
}

TEST(FuzzCorpus, is_read_without_a_fault) {
  const auto texts = corpus();
  ASSERT_GE(texts.size(), 10u);
  int frames = 0;
  for (const std::string& text : texts)
    frames += read_and_measure(text);
  EXPECT_GE(frames, 6);
}

TEST(FuzzCorpus, mutations_are_read_without_a_fault) {
  std::mt19937 generator(20100);
  const auto texts = corpus();
  for (int round = 0; round < 3000; ++round)
    for (const std::string& text : texts)
      read_and_measure(mutated(text, generator));
}

} // namespace
} // namespace ellipsoid::post
