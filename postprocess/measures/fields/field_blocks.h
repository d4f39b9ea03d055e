// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "field_targets.h"

#include <functional>
#include <vector>

namespace ellipsoid::post {

/// Sums of fields over the frames of a series, kept in blocks of frames that follow each other: the
/// mean over all frames, and how well it is known. Frames near each other are alike; blocks much
/// less so. Memory: 20 to 40 blocks, however many frames there are (`keeps_blocks`), or one.
class FieldBlocks {
 public:
  explicit FieldBlocks(bool keeps_blocks) : keeps_blocks_(keeps_blocks) {}
  void add(const std::vector<FieldSums>& frame);

  std::size_t frames() const;
  std::size_t points() const { return blocks_.empty() ? 0 : blocks_.front().sums.size(); }
  /// Mean over the frames at one point.
  FieldSums mean(std::size_t point) const;

  /// Standard errors of numbers that are made of the mean at one point: the jackknife over blocks
  /// of unequal numbers of frames (Busing, Meijer, van der Leeden 1999, Statistics and Computing 9,
  /// 3-8). Empty for less than two blocks.
  std::vector<double>
  standard_errors(std::size_t point,
                  const std::function<std::vector<double>(const FieldSums&)>& numbers) const;

 private:
  struct Block {
    std::size_t frames = 0;
    std::vector<FieldSums> sums;
  };
  void join_neighbours();

  bool keeps_blocks_;
  std::size_t frames_in_block_ = 1; ///< of all blocks but the last
  std::vector<Block> blocks_;
};

} // namespace ellipsoid::post
