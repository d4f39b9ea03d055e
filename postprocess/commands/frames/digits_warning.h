// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "contacts.h"
#include "frame_loop.h"

namespace ellipsoid::post {

/// Warns on standard error when a file's digits are too few for contacts (the host's default format
/// %g keeps six).
void warn_of_digits(const ChosenFrame& chosen);

/// Warns of a box that repeats so closely that particles come near their own images, which are not
/// counted as partners.
void warn_of_own_images(const ChosenFrame& chosen, const ContactNetwork& network);

} // namespace ellipsoid::post
