// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Rows of a long table come back as they were, from memory and from the temporary file.
#include "row_store.h"

#include <gtest/gtest.h>
#include <random>

namespace ellipsoid::post {
namespace {

/// Rows with a part of twelve quantities in changing order, of all kinds.
std::vector<Row> random_rows(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Row> rows(count);
  for (Row& row : rows)
    for (std::size_t k = random() % 12; k < 12; k += 1 + random() % 2) {
      const std::string key = "q" + std::to_string((k + (random() % 50 == 0 ? 5 : 0)) % 12);
      if (find_value(row, key))
        continue;
      const Value values[] = {std::monostate(), random() % 2 == 0,
                              static_cast<std::int64_t>(random()),
                              std::uniform_real_distribution<double>(-1e9, 1e9)(random),
                              std::string(random() % 40, static_cast<char>('a' + k))};
      row.push_back({key, "name of " + key, "unit of " + key, values[random() % 5]});
    }
  return rows;
}

void expect_same(const Row& row, const Row& other) {
  ASSERT_EQ(row.size(), other.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    EXPECT_EQ(row[k].key, other[k].key);
    EXPECT_EQ(row[k].name, other[k].name);
    EXPECT_EQ(row[k].unit, other[k].unit);
    EXPECT_EQ(row[k].value, other[k].value);
  }
}

TEST(RowStore, rows_come_back_whether_in_memory_or_in_the_file) {
  const std::vector<Row> rows = random_rows(500, 5);
  for (const std::size_t most_held : {std::size_t{0}, std::size_t{1000}, std::size_t{1} << 30}) {
    RowStore store(most_held);
    for (std::size_t n = 0; n < rows.size(); ++n) {
      store.add(rows[n]);
      if (n == 250) { // rows may be looked at in between
        EXPECT_EQ(store.table("").rows.size(), 251u);
      }
    }
    ASSERT_EQ(store.size(), rows.size());
    for (int again = 0; again < 2; ++again) {
      std::size_t n = 0;
      store.visit([&](const Row& row) { expect_same(row, rows[n++]); });
      EXPECT_EQ(n, rows.size());
    }
    const Table table{"", rows};
    const std::vector<Quantity> header = table.header();
    ASSERT_EQ(store.header().size(), header.size());
    for (std::size_t k = 0; k < header.size(); ++k)
      EXPECT_EQ(store.header()[k].key, header[k].key);
  }
}

TEST(RowStore, no_rows) {
  const RowStore store;
  store.visit([](const Row&) { FAIL(); });
  EXPECT_TRUE(store.header().empty());
}

} // namespace
} // namespace ellipsoid::post
