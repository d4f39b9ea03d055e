// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "number_text.h"

#include "byte_source.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace ellipsoid::post {
namespace {

/// Powers of ten that a double holds exactly.
constexpr double exact_powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int largest_exact_power = 22;
constexpr std::uint64_t largest_exact_integer = std::uint64_t{1} << 53;

/// A number as its text says it: digits 10^exponent.
struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
  bool is_exact = false; ///< `digits` holds all of them
};

unsigned digit_at(const char* place) { return static_cast<unsigned char>(*place) - unsigned{'0'}; }

/// The value of eight digits at once; false when one of the bytes is none.
bool eight_digits(const char* place, std::uint64_t& value) {
  std::uint64_t bytes = 0; // digit k in byte k: the first one is the lowest
  for (unsigned k = 0; k < 8; ++k)
    bytes |= std::uint64_t{static_cast<unsigned char>(place[k])} << (8 * k); // one load
  constexpr std::uint64_t high_halves = 0xf0f0f0f0f0f0f0f0, zeros = 0x3030303030303030;
  if ((bytes & high_halves) != zeros ||
      ((bytes + 0x0606060606060606) & high_halves) != zeros) // ':' to '?' would carry
    return false;
  bytes -= zeros;
  bytes = (10 * bytes + (bytes >> 8)) & 0x00ff00ff00ff00ff;   // pairs
  bytes = (100 * bytes + (bytes >> 16)) & 0x0000ffff0000ffff; // fours
  value = (10000 * bytes + (bytes >> 32)) & 0xffffffff;
  return true;
}

/// Takes a run of digits, usually a short one.
inline const char* take_digits(const char* place, std::uint64_t& digits) {
  for (unsigned digit = digit_at(place); digit < 10; digit = digit_at(++place))
    digits = 10 * digits + digit;
  return place;
}

/// Takes a run of digits, usually a long one.
inline const char* take_many_digits(const char* place, const char* end, std::uint64_t& digits) {
  std::uint64_t eight = 0;
  for (; end - place >= 8 && eight_digits(place, eight); place += 8)
    digits = 100000000 * digits + eight;
  return take_digits(place, digits);
}

/// Takes "e-05" and the like; leaves a text that is none where it stands.
const char* take_exponent(const char* place, int& exponent) {
  const char* digits_begin = place + 1;
  const bool is_negative = *digits_begin == '-';
  if (is_negative || *digits_begin == '+')
    ++digits_begin;
  std::uint64_t written = 0;
  const char* end = take_digits(digits_begin, written);
  if (end == digits_begin || end > digits_begin + 4)
    return place;
  exponent += is_negative ? -static_cast<int>(written) : static_cast<int>(written);
  return end;
}

/// Number of digits without the zeros in front.
std::ptrdiff_t significant_digits(const char* begin, std::ptrdiff_t count) {
  for (; count > 0 && (*begin == '0' || *begin == '.'); ++begin)
    count -= *begin == '0' ? 1 : 0;
  return count;
}

/// @param[in] begin where the digits begin, behind the sign
inline const char* take_decimal(const char* begin, const char* end, Decimal& number) {
  constexpr std::ptrdiff_t most_digits = 19; // that fit into 64 bits whatever they are
  const char* place = take_digits(begin, number.digits);
  std::ptrdiff_t count = place - begin;
  if (*place == '.') {
    const char* fraction = ++place;
    place = take_many_digits(place, end, number.digits);
    count += place - fraction;
    number.exponent = -static_cast<int>(place - fraction); // a line is shorter than INT_MAX
  }
  number.is_exact =
      count > 0 && (count <= most_digits || significant_digits(begin, count) <= most_digits);
  return *place == 'e' || *place == 'E' ? take_exponent(place, number.exponent) : place;
}

/// digits 10^exponent for digits of more than 53 bits by one operation in a longer format, where
/// the processor has one with 64 bits. False where the second rounding, to 53 bits, could differ
/// from a single one: the first one ended close to the middle between two doubles.
bool round_twice(const Decimal& number, double& value) {
  using Long = long double;
  if constexpr (std::numeric_limits<Long>::digits == 64 && sizeof(Long) == 16) {
    static constexpr Long powers[] = {1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,
                                      1e7L,  1e8L,  1e9L,  1e10L, 1e11L, 1e12L, 1e13L,
                                      1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L, 1e20L,
                                      1e21L, 1e22L, 1e23L, 1e24L, 1e25L, 1e26L, 1e27L}; // exact
    if (std::abs(number.exponent) > 27)
      return false;
    const Long digits = static_cast<Long>(number.digits);
    const Long rounded =
        number.exponent < 0 ? digits / powers[-number.exponent] : digits * powers[number.exponent];
    std::uint64_t mantissa = 0;
    std::memcpy(&mantissa, &rounded, sizeof(mantissa));
    constexpr std::uint64_t surplus_bits = 0x7ff, middle = 0x400;
    value = static_cast<double>(rounded);
    return (mantissa & surplus_bits) - (middle - 1) > 2;
  }
  return false;
}

/// Any number, by the standard library.
const char* read_any_number(const char* text, const char* end, double& value) {
  const char* token_end = std::find_if(text, end, is_blank);
  const auto result = std::from_chars(text, token_end, value);
  if (result.ptr != token_end || text == token_end)
    return nullptr;
  if (result.ec == std::errc::result_out_of_range) { // too small: 0 is meant; too large: error
    const char* exponent =
        std::find_if(text, token_end, [](char letter) { return letter == 'e' || letter == 'E'; });
    value = 0.0;
    return exponent + 1 < token_end && exponent[1] == '-' ? token_end : nullptr;
  }
  return result.ec == std::errc() && std::isfinite(value) ? token_end : nullptr;
}

} // namespace

const char* read_number(const char* text, const char* end, double& value) {
  if (*text == '+')
    ++text;
  const bool is_negative = *text == '-';
  Decimal number;
  const char* number_end = take_decimal(text + (is_negative ? 1 : 0), end, number);
  if ((number_end != end && !is_blank(*number_end)) || !number.is_exact)
    return read_any_number(text, end, value);
  if (number.digits <= largest_exact_integer && std::abs(number.exponent) <= largest_exact_power) {
    // one operation on two exact values: rounded once
    const double digits = static_cast<double>(static_cast<std::int64_t>(number.digits));
    value = number.exponent < 0 ? digits / exact_powers[-number.exponent]
                                : digits * exact_powers[number.exponent];
  } else if (!round_twice(number, value)) {
    return read_any_number(text, end, value);
  }
  if (is_negative)
    value = -value;
  return number_end;
}

} // namespace ellipsoid::post
