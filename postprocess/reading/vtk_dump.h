// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_reader.h"

namespace ellipsoid::post {

/// A file of the host's `dump custom/vtk`: one frame. Points become x y z, vectors v and omega
/// become vx vy vz and omegax ..., the rotation matrix TENSOR becomes quat1..quat4, other arrays
/// of several components NAME[1] .... The time step is the last number in the file's name.
class VtkDumpReader : public FrameReader {
 public:
  /// Throws InputError when the file cannot be opened.
  explicit VtkDumpReader(std::string path);
  bool next(Frame& frame) override;
  std::uint64_t consumed() const override { return consumed_; }

 private:
  std::string path_;
  bool is_done_ = false;
  std::uint64_t consumed_ = 0;
};

} // namespace ellipsoid::post
