// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "canvas.h"

namespace ellipsoid::post {

/// Perceptually even colours from dark blue over green to yellow (viridis), t from 0 to 1.
Colour colour_of(double t);

/// A colour of the wheel for angles, share from 0 to 1, the same at both ends.
Colour cyclic_colour(double share);

/// Kinds that have a colour of their own.
constexpr std::size_t most_kinds = 7;

/// Colours of kinds, from 0; safe for colour-blind readers.
Colour kind_colour(std::size_t kind);

/// Lighter (amount > 0) variant of a colour, towards white.
Colour lighter(const Colour& colour, double amount);

} // namespace ellipsoid::post
