// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "number_text.h"

#include "byte_source.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace ellipsoid::post {
namespace {

__extension__ using Wide = unsigned __int128;

/// Powers of ten 10^q as mantissa 2^(exponent - 63) with 2^63 <= mantissa < 2^64, cut off.
struct PowersOfTen {
  static constexpr int largest = 64;
  std::uint64_t mantissas[2 * largest + 1] = {};
  int exponents[2 * largest + 1] = {};

  /// From power to power with 128 bits, of which the last eight are lost at most.
  constexpr PowersOfTen() {
    constexpr Wide one = Wide{1} << 127;
    Wide up = one, down = one;
    int up_exponent = 0, down_exponent = 0;
    for (int q = 0; q <= largest; ++q) {
      set(q, up, up_exponent);
      set(-q, down, down_exponent);
      const Wide sum = up + up / 4; // 10 = 8 (1 + 1/4)
      const bool carries = sum < up;
      up = carries ? up / 2 + up / 8 : sum;
      up_exponent += carries ? 4 : 3;
      const Wide less = down / 5 * 4 + down % 5 * 4 / 5; // 1/10 = 4/5 / 8
      const bool is_short = less < one;
      down = is_short ? down / 5 * 8 + down % 5 * 8 / 5 : less;
      down_exponent -= is_short ? 4 : 3;
    }
  }

 private:
  constexpr void set(int power, Wide mantissa, int exponent) {
    mantissas[largest + power] = static_cast<std::uint64_t>(mantissa >> 64);
    exponents[largest + power] = exponent;
  }
};

constexpr PowersOfTen powers_of_ten;

/// A number as its text says it: digits 10^exponent.
struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
  bool is_exact = false; ///< `digits` holds all of them
  bool is_negative = false;
};

unsigned digit_at(const char* at) { return static_cast<unsigned char>(*at) - unsigned{'0'}; }

/// Eight characters as one number, the first one lowest; digits as their values.
std::uint64_t eight_characters(const char* at) {
  std::uint64_t bytes = 0;
  for (unsigned k = 0; k < 8; ++k)
    bytes |= std::uint64_t{static_cast<unsigned char>(at[k])} << (8 * k); // one load
  return bytes ^ 0x3030303030303030;
}

/// How many of eight characters are digits, up to the first one that is none.
unsigned leading_digits(std::uint64_t characters) {
  // a sum that exceeds a byte can only disturb those behind the first one that is no digit
  const std::uint64_t none = ((characters + 0x7676767676767676) | characters) & 0x8080808080808080;
  return none == 0 ? 8 : static_cast<unsigned>(__builtin_ctzll(none)) / 8;
}

/// The number that eight digits form.
std::uint64_t value_of(std::uint64_t digits) {
  digits = (10 * digits + (digits >> 8)) & 0x00ff00ff00ff00ff;   // pairs
  digits = (100 * digits + (digits >> 16)) & 0x0000ffff0000ffff; // fours
  return (10000 * digits + (digits >> 32)) & 0xffffffff;
}

/// Takes a run of digits, usually a short one.
inline const char* read_digits(const char* at, std::uint64_t& digits) {
  for (unsigned digit = digit_at(at); digit < 10; digit = digit_at(++at))
    digits = 10 * digits + digit;
  return at;
}

/// Takes a run of digits, usually a long one.
inline const char* read_many_digits(const char* at, const char* end, std::uint64_t& digits) {
  static constexpr std::uint64_t powers[] = {1,      10,      100,      1000,     10000,
                                             100000, 1000000, 10000000, 100000000};
  while (end - at >= 8) {
    const std::uint64_t characters = eight_characters(at);
    const unsigned count = leading_digits(characters);
    // moved up: what is no digit is gone, zeros come in front
    const unsigned half = 32 - 4 * count;
    digits = powers[count] * digits + value_of(characters << half << half);
    at += count;
    if (count < 8)
      return at;
  }
  return read_digits(at, digits);
}

/// Takes "e-05" and the like; leaves a text that is none where it stands.
const char* read_exponent(const char* at, int& exponent) {
  const char* digits_begin = at + 1;
  const bool is_negative = *digits_begin == '-';
  if (is_negative || *digits_begin == '+')
    ++digits_begin;
  std::uint64_t written = 0;
  const char* end = read_digits(digits_begin, written);
  if (end == digits_begin || end > digits_begin + 4)
    return at;
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
inline const char* read_decimal(const char* begin, const char* end, Decimal& number) {
  constexpr std::ptrdiff_t most_digits = 19; // that fit into 64 bits whatever they are
  const char* at = read_digits(begin, number.digits);
  std::ptrdiff_t count = at - begin;
  if (*at == '.') {
    const char* fraction = ++at;
    at = read_many_digits(at, end, number.digits);
    count += at - fraction;
    number.exponent = -static_cast<int>(at - fraction); // a line is shorter than INT_MAX
  }
  number.is_exact =
      count > 0 && (count <= most_digits || significant_digits(begin, count) <= most_digits);
  return *at == 'e' || *at == 'E' ? read_exponent(at, number.exponent) : at;
}

/// +-digits 10^exponent, digits > 0, by one multiplication of 64 bits by 64 bits; the cut-off power
/// makes it too small by less than 1 of the upper half. False where rounding to 53 bits could
/// depend on that.
bool rounded(const Decimal& number, double& value) {
  if (std::abs(number.exponent) > PowersOfTen::largest)
    return false;
  const auto power = static_cast<std::size_t>(PowersOfTen::largest + number.exponent);
  const int shift = __builtin_clzll(number.digits);
  const Wide product = Wide{number.digits << shift} * powers_of_ten.mantissas[power];
  const auto upper_half = static_cast<std::uint64_t>(product >> 64);
  // with the leading bit in front; then too small by less than 3
  const std::uint64_t is_short = ~upper_half >> 63;
  const std::uint64_t upper =
      (upper_half << is_short) | (static_cast<std::uint64_t>(product) >> 63 & is_short);
  constexpr unsigned surplus_bits = 11;
  constexpr std::uint64_t middle = 1u << (surplus_bits - 1), most_missing = 3;
  const std::uint64_t surplus = upper & (2 * middle - 1);
  const std::uint64_t mantissa = (upper >> surplus_bits) + (surplus > middle ? 1 : 0);
  const int exponent = powers_of_ten.exponents[power] + 64 - shift - static_cast<int>(is_short);
  constexpr int bias = 1022; // the leading bit of the mantissa adds 1
  const std::uint64_t sign = number.is_negative ? 1 : 0;
  const std::uint64_t bits =
      (sign << 63) + (static_cast<std::uint64_t>(exponent + bias) << 52) + mantissa;
  std::memcpy(&value, &bits, sizeof(value));
  return surplus - (middle - most_missing) > most_missing;
}

/// Any number, by the standard library.
[[gnu::noinline]] const char* read_any_number(const char* text, const char* end, double& value) {
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

const char* read_longer_number(const char* text, const char* end, double& value) {
  if (*text == '+')
    ++text;
  Decimal number;
  number.is_negative = *text == '-';
  const char* number_end = read_decimal(text + (number.is_negative ? 1 : 0), end, number);
  if ((number_end != end && !is_blank(*number_end)) || !number.is_exact)
    return read_any_number(text, end, value);
  if (number.digits == 0)
    value = number.is_negative ? -0.0 : 0.0;
  else if (!rounded(number, value))
    return read_any_number(text, end, value);
  return number_end;
}

} // namespace ellipsoid::post
