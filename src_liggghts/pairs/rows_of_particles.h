// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ellipsoid_host {

/// A row of any length for each owned particle, empty for most. A packed row is its length, counted
/// with this number, and its values.
class RowsOfParticles {
 public:
  using Row = std::vector<double>;

  const Row& of(int particle) const {
    static const Row none;
    const auto k = static_cast<std::size_t>(particle);
    return k < rows_.size() ? rows_[k] : none;
  }
  Row& at(int particle) {
    const auto k = static_cast<std::size_t>(particle);
    if (k >= rows_.size())
      rows_.resize(k + 1);
    return rows_[k];
  }
  std::vector<Row>& all() { return rows_; }

  void clear() { rows_.clear(); }
  void empty(int particle) {
    if (!of(particle).empty())
      at(particle).clear();
  }
  void copy(int from, int to) {
    if (of(from).empty() && of(to).empty())
      return;
    const Row copied = of(from);
    at(to) = copied;
  }

  int packed_size(int particle) const { return 1 + static_cast<int>(of(particle).size()); }
  int pack(int particle, double* buffer) const {
    buffer[0] = packed_size(particle);
    std::copy(of(particle).begin(), of(particle).end(), buffer + 1);
    return packed_size(particle);
  }
  int unpack(int particle, const double* buffer) {
    const int size = static_cast<int>(buffer[0]);
    empty(particle);
    if (size > 1)
      at(particle).assign(buffer + 1, buffer + size);
    return size;
  }
  /// @param[in] extra of the particle: what fixes have in the restart file, one after the other
  /// @param[in] which of them is the row
  void unpack_extra(int particle, const double* extra, int which) {
    for (int k = 0; k < which; ++k)
      extra += static_cast<std::ptrdiff_t>(*extra);
    unpack(particle, extra);
  }
  int largest_packed_size(int particles) const {
    int largest = 1;
    for (int i = 0; i < particles; ++i)
      largest = std::max(largest, packed_size(i));
    return largest;
  }

  double bytes() const {
    double sum = static_cast<double>(rows_.capacity() * sizeof(Row));
    for (const Row& row : rows_)
      sum += static_cast<double>(row.capacity() * sizeof(double));
    return sum;
  }

 private:
  std::vector<Row> rows_;
};

/// A fix that sends rows of any length along with particles.
class SendsRows {
 public:
  virtual ~SendsRows() = default;
  /// Of the rows of this rank.
  virtual int largest_row() const = 0;
};

} // namespace ellipsoid_host
