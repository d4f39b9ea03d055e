// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The spacings by which spheres are placed and sized in an ellipsoid: their words and numbers.
#pragma once

#include <optional>
#include <string>

namespace ellipsoid {

/// The numbers stand in dumps (column f_spacing) and in data files.
enum class SphereSpacing {
  paper = 0,           ///< eqs. (3) to (8): inscribed, distances as the ellipse's ordinates
  minimax_outline = 1, ///< the largest distance between outline and ellipse is smallest
  minimax_area = 2,    ///< the area between outline and ellipse is smallest
  paper_touching = 3,  ///< N = 3 of section 4.2.1: side spheres touch the centre sphere
  medial = 4,          ///< inscribed, on the medial ellipse, any a, b, c: ellipsoid_spheres.h
  minimax_volume = 5   ///< the same plane, the volume between is smallest: ellipsoid_spheres.h
};

/// Reads a word of words_of_spacings().
/// @throws std::invalid_argument any other word
SphereSpacing sphere_spacing_from_word(const std::string& word);

/// The spacing of a number, or none.
std::optional<SphereSpacing> sphere_spacing_from_number(double number);

/// The word that sphere_spacing_from_word() reads.
std::string word_of(SphereSpacing spacing);

/// Whether a spacing places its spheres on the medial ellipse; the others are chains on the axis.
bool is_planar(SphereSpacing spacing);

/// All words that are read: "paper, minimax, ...".
std::string words_of_spacings();
/// The words of the chains.
std::string words_of_chains();
/// Numbers with their words: "0 (paper), 1 (minimax_outline), ...".
std::string numbers_of_spacings();

} // namespace ellipsoid
