// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "byte_source.h"

namespace ellipsoid::post {

/// What a source's first bytes say it is: gzip, bzip2, xz or zstd data are decompressed on the way,
/// from files and pipes alike; anything else is given as it is. Data that are broken or cut off are
/// an InputError of read().
std::unique_ptr<ByteSource> decompressed(std::unique_ptr<ByteSource> source);

} // namespace ellipsoid::post
