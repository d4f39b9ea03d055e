// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "field_blocks.h"

#include <cmath>

namespace ellipsoid::post {
namespace {

void add_to(std::vector<FieldSums>& to, const std::vector<FieldSums>& more) {
  to.resize(more.size(), FieldSums{});
  for (std::size_t n = 0; n < more.size(); ++n)
    for (std::size_t k = 0; k < field_size; ++k)
      to[n][k] += more[n][k];
}

} // namespace

void FieldBlocks::add(const std::vector<FieldSums>& frame) {
  constexpr std::size_t most_blocks = 40;
  if (blocks_.empty() || (keeps_blocks_ && blocks_.back().frames == frames_in_block_)) {
    if (blocks_.size() == most_blocks)
      join_neighbours();
    blocks_.emplace_back();
  }
  add_to(blocks_.back().sums, frame);
  ++blocks_.back().frames;
}

void FieldBlocks::join_neighbours() {
  std::vector<Block> joined(blocks_.size() / 2);
  for (std::size_t b = 0; b < joined.size(); ++b)
    for (const std::size_t part : {2 * b, 2 * b + 1}) {
      add_to(joined[b].sums, blocks_[part].sums);
      joined[b].frames += blocks_[part].frames;
    }
  blocks_ = std::move(joined);
  frames_in_block_ *= 2;
}

std::size_t FieldBlocks::frames() const {
  std::size_t sum = 0;
  for (const Block& block : blocks_)
    sum += block.frames;
  return sum;
}

FieldSums FieldBlocks::mean(std::size_t point) const {
  FieldSums mean{};
  for (const Block& block : blocks_)
    for (std::size_t k = 0; k < field_size; ++k)
      mean[k] += block.sums[point][k];
  for (double& value : mean)
    value /= static_cast<double>(frames());
  return mean;
}

std::vector<double> FieldBlocks::standard_errors(
    std::size_t point, const std::function<std::vector<double>(const FieldSums&)>& numbers) const {
  if (blocks_.size() < 2)
    return {};
  const double count = static_cast<double>(blocks_.size()), all = static_cast<double>(frames());
  const FieldSums mean_of_all = mean(point);
  const std::vector<double> whole = numbers(mean_of_all);
  std::vector<std::vector<double>> left_out;
  for (const Block& block : blocks_) {
    const double m = static_cast<double>(block.frames);
    FieldSums rest{};
    for (std::size_t k = 0; k < field_size; ++k)
      rest[k] = (all * mean_of_all[k] - block.sums[point][k]) / (all - m);
    left_out.push_back(numbers(rest));
  }
  std::vector<double> errors(whole.size(), 0.0);
  for (std::size_t n = 0; n < whole.size(); ++n) {
    double centre = count * whole[n];
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      centre -= (1.0 - static_cast<double>(blocks_[b].frames) / all) * left_out[b][n];
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const double h = all / static_cast<double>(blocks_[b].frames);
      const double pseudo_value = h * whole[n] - (h - 1.0) * left_out[b][n];
      errors[n] += (pseudo_value - centre) * (pseudo_value - centre) / (h - 1.0) / count;
    }
    errors[n] = std::sqrt(errors[n]);
  }
  return errors;
}

} // namespace ellipsoid::post
