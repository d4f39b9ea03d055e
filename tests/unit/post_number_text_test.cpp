// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Numbers of text dumps: every one must be the double that the standard library gives.
#include "number_text.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace ellipsoid::post {
namespace {

/// The value, or NaN where the text is refused or not read to its end.
double value_of(const std::string& text) {
  double value = 0.0;
  const std::string line = text + "\n";
  const char* end = line.data() + text.size();
  return read_number(line.data(), end, value) == end ? value : std::nan("");
}

void expect_same(const std::string& text) {
  const double value = value_of(text), wanted = std::strtod(text.c_str(), nullptr);
  EXPECT_EQ(std::memcmp(&value, &wanted, sizeof(value)), 0)
      << text << ": " << fmt::format("{} is not {}", value, wanted);
}

TEST(NumberText, random_doubles_in_all_formats) {
  std::mt19937_64 generator(20101);
  std::uniform_int_distribution<int> digits(1, 21), exponents(-25, 25);
  std::uniform_real_distribution<double> mantissas(-1.0, 1.0);
  for (int k = 0; k < 300000; ++k) {
    const double value = mantissas(generator) * std::pow(10.0, exponents(generator));
    expect_same(fmt::format("{:.{}g}", value, digits(generator)));
    expect_same(fmt::format("{:.{}f}", value, digits(generator)));
    expect_same(fmt::format("{:.{}e}", value, digits(generator)));
  }
}

TEST(NumberText, all_bit_patterns) {
  std::mt19937_64 generator(20102);
  for (int k = 0; k < 300000; ++k) {
    const std::uint64_t bits = generator();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value) && std::abs(value) > 1e-300)
      expect_same(fmt::format("{:.17g}", value));
  }
}

/// Decimal fractions right in the middle between two doubles, and next to it: m + 1/2 with m of 53
/// bits, scaled by powers of two, written with all digits that fit into 19.
TEST(NumberText, between_two_doubles) {
  std::mt19937_64 generator(20103);
  for (int k = 0; k < 100000; ++k) {
    const std::uint64_t odd = (std::uint64_t{1} << 53) + (generator() >> 11);
    for (const int difference : {-1, 0, 1}) {
      const std::uint64_t twice = 2 * odd + 1 + static_cast<std::uint64_t>(difference);
      expect_same(fmt::format("{}", twice)); // of 55 bits
      expect_same(fmt::format("{}.{:02}", twice / 4, 25 * (twice % 4)));
    }
  }
}

TEST(NumberText, special_forms) {
  for (const char* text :
       {"0", "-0", "0.0", "1.", ".5", "-.5e1", "1e22", "1e23", "123456789012345678", "00012.5",
        "0.000000000000000000000000012345678901234567", "12345678901234567890123", "1E+2", "1e-2",
        "1e0005", "9007199254740993", "18446744073709551616", "1.7976931348623157e308", "4.9e-324"})
    expect_same(text);
  EXPECT_EQ(value_of("+2.5"), 2.5);
  EXPECT_EQ(value_of("1e-400"), 0.0);
  EXPECT_EQ(value_of("-1e-99999"), 0.0);
}

TEST(NumberText, what_is_no_finite_number) {
  for (const char* text :
       {"",      "-",     "+",   ".",   "e5",        "-e5",      "1e",         "1e+",
        "1.2.3", "0x10",  "nan", "inf", "-inf",      "1e400",    "-1e99999",   "1,5",
        "12a",   "1e5.0", "--1", "1\r", "12345678:", "1234567/", "1.1234567:9"})
    EXPECT_TRUE(std::isnan(value_of(text))) << text;
}

TEST(NumberText, stops_behind_the_number) {
  const std::string line = "12.5 7\t8\n";
  double value = 0.0;
  const char* end = line.data() + line.size() - 1;
  const char* place = read_number(line.data(), end, value);
  EXPECT_EQ(place, line.data() + 4);
  place = read_number(place + 1, end, value);
  EXPECT_EQ(value, 7.0);
  EXPECT_EQ(read_number(place + 1, end, value), end);
}

} // namespace
} // namespace ellipsoid::post
