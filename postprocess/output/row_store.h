// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The rows of a long table: some in memory, the others in a temporary file.
#pragma once

#include "table.h"

#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ellipsoid::post {

class RowStore {
 public:
  /// @param[in] most_held rows go to a temporary file where they take more memory than that (bytes)
  explicit RowStore(std::size_t most_held = 4u << 20);

  /// Throws InputError where the temporary file cannot be written.
  void add(const Row& row);
  std::size_t size() const { return size_; }
  /// The quantities of all rows in the order of their first appearance; their values mean nothing.
  const std::vector<Quantity>& header() const { return header_; }
  /// All rows in their order. Throws InputError where the temporary file cannot be read.
  void visit(const std::function<void(const Row&)>& use) const;
  /// All rows in memory.
  Table table(const std::string& title) const;

 private:
  std::size_t column_of(const Quantity& q, std::size_t usual);

  std::size_t most_held_, size_ = 0;
  std::vector<Quantity> header_;
  std::map<std::string, std::size_t> columns_; ///< places in the header
  std::string held_;                           ///< whole rows that are not in the file
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

} // namespace ellipsoid::post
