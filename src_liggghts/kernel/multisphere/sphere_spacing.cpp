// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "multisphere/sphere_spacing.h"

#include <stdexcept>

namespace ellipsoid {
namespace {

struct SpacingRow {
  SphereSpacing spacing;
  const char* word;
  bool is_planar;
};

/// A row per spacing.
constexpr SpacingRow rows[] = {
    {SphereSpacing::paper, "paper", false},
    {SphereSpacing::minimax_outline, "minimax_outline", false},
    {SphereSpacing::minimax_area, "minimax_area", false},
    {SphereSpacing::paper_touching, "paper_touching", false},
    {SphereSpacing::medial, "medial", true},
    {SphereSpacing::minimax_volume, "minimax_volume", true},
};

const SpacingRow& row_of(SphereSpacing spacing) {
  for (const SpacingRow& row : rows)
    if (row.spacing == spacing)
      return row;
  throw std::logic_error("a sphere spacing has no row in sphere_spacing.cpp");
}

/// The texts of all rows, with commas; an empty one is left out.
template <class Text> std::string listed(const Text& text_of) {
  std::string list;
  for (const SpacingRow& row : rows) {
    const std::string text = text_of(row);
    if (!text.empty())
      list += (list.empty() ? "" : ", ") + text;
  }
  return list;
}

} // namespace

SphereSpacing sphere_spacing_from_word(const std::string& word) {
  if (word == "minimax")
    return SphereSpacing::minimax_outline;
  for (const SpacingRow& row : rows)
    if (word == row.word)
      return row.spacing;
  throw std::invalid_argument("multisphere template: spacing '" + word +
                              "' is unknown; use one of " + words_of_spacings());
}

std::optional<SphereSpacing> sphere_spacing_from_number(double number) {
  for (const SpacingRow& row : rows)
    if (number == static_cast<double>(row.spacing))
      return row.spacing;
  return {};
}

std::string word_of(SphereSpacing spacing) { return row_of(spacing).word; }

bool is_planar(SphereSpacing spacing) { return row_of(spacing).is_planar; }

std::string words_of_spacings() {
  return "minimax, " + listed([](const SpacingRow& row) { return std::string(row.word); });
}

std::string words_of_chains() {
  return listed([](const SpacingRow& row) { return std::string(row.is_planar ? "" : row.word); });
}

std::string numbers_of_spacings() {
  return listed([](const SpacingRow& row) {
    return std::to_string(static_cast<int>(row.spacing)) + " (" + row.word + ")";
  });
}

} // namespace ellipsoid
