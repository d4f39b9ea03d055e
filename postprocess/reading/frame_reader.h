// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame.h"

#include <cstdint>
#include <memory>
#include <string>

namespace ellipsoid::post {

/// The frames of one file.
class FrameReader {
 public:
  virtual ~FrameReader() = default;
  /// Fills the next whole frame (its memory is used again); false at the end of the file.
  /// Throws InputError; frames given before stay valid.
  virtual bool next(Frame& frame) = 0;
  /// The same, but the rows may be left as text for read_rows(). What that throws comes before all
  /// that is given or thrown later: those frames do not count then.
  virtual bool next_unread(Frame& frame) { return next(frame); }
  /// Bytes on disk consumed so far.
  virtual std::uint64_t consumed() const = 0;
};

/// A reader by the file's name: VTK files (.vtk .vtu .vtp .pvtu), all others text dumps.
/// Throws InputError when it cannot be opened, or for VTK files in a build without VTK.
std::unique_ptr<FrameReader> open_frames(const std::string& path);

/// Whether a name ends like a VTK file's.
bool is_vtk_name(const std::string& path);

} // namespace ellipsoid::post
