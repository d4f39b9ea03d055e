// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "natural_order.h"

#include <cctype>

namespace ellipsoid::post {
namespace {

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

} // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      std::size_t i_end = i, j_end = j;
      while (i_end < a.size() && is_digit(a[i_end]))
        ++i_end;
      while (j_end < b.size() && is_digit(b[j_end]))
        ++j_end;
      while (i < i_end && a[i] == '0')
        ++i;
      while (j < j_end && b[j] == '0')
        ++j;
      if (i_end - i != j_end - j)
        return i_end - i < j_end - j;
      if (const int order = a.compare(i, i_end - i, b, j, j_end - j); order != 0)
        return order < 0;
      i = i_end;
      j = j_end;
    } else {
      if (a[i] != b[j])
        return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  if (a.size() - i != b.size() - j)
    return a.size() - i < b.size() - j;
  return a < b; // differ by leading zeros only
}

} // namespace ellipsoid::post
