// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "run_summary.h"

#include "csv_table.h"
#include "key_units.h"
#include "natural_order.h"
#include "spread.h"
#include "whole_token.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace ellipsoid::post {
namespace {

struct Group {
  Row keys;
  std::vector<const Row*> rows;
};

std::string label_of(const Value* value) {
  double number = 0.0;
  if (!value || std::holds_alternative<std::monostate>(*value))
    return "-";
  if (as_number(*value, number))
    return fmt::format("{}", number);
  const auto* text = std::get_if<std::string>(value);
  return text ? *text : "-";
}

/// Numbers as numbers, and before words; words in natural order.
bool comes_before(const Quantity& p, const Quantity& q) {
  const std::string &a = std::get<std::string>(p.value), &b = std::get<std::string>(q.value);
  const auto x = whole_token<double>(a), y = whole_token<double>(b);
  if (x && y && *x != *y)
    return *x < *y;
  return x.has_value() == y.has_value() ? natural_less(a, b) : x.has_value();
}

std::vector<Group> groups_of(const Table& runs, const std::vector<std::string>& keys) {
  std::vector<Group> groups;
  for (const Row& row : runs.rows) {
    Row group_keys;
    for (const std::string& key : keys)
      group_keys.push_back({key, key, "", label_of(find_value(row, key))});
    const auto it = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return std::equal(group.keys.begin(), group.keys.end(), group_keys.begin(),
                        [](const Quantity& p, const Quantity& q) { return p.value == q.value; });
    });
    if (it != groups.end())
      it->rows.push_back(&row);
    else
      groups.push_back({std::move(group_keys), {&row}});
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& p, const Group& q) {
    return std::lexicographical_compare(p.keys.begin(), p.keys.end(), q.keys.begin(), q.keys.end(),
                                        comes_before);
  });
  return groups;
}

std::vector<double> numbers_of(const Group& group, const std::string& key) {
  std::vector<double> numbers;
  double number = 0.0;
  for (const Row* row : group.rows)
    if (const Value* value = find_value(*row, key); value && as_number(*value, number))
      numbers.push_back(number);
  return numbers;
}

/// "repose_angle_deg" and "half_range" to "repose_angle_half_range_deg": the unit stays last.
std::string key_with(const std::string& key, const std::string& what) {
  const auto [name, unit] = parts_of_key(key);
  return name + "_" + what + (unit.empty() ? "" : "_" + unit);
}

void append_spread(Row& row, const Quantity& quantity, const Spread& s) {
  const std::string& key = quantity.key;
  row.push_back({key_with(key, "mean"), quantity.name, quantity.unit, s.mean});
  row.push_back({key_with(key, "half_range"), "+-", quantity.unit, s.half_range});
  row.push_back({key + "_half_range_percent", "+-", "%",
                 s.mean != 0.0 ? Value(100.0 * s.half_range / std::abs(s.mean)) : Value()});
  row.push_back({key_with(key, "standard_deviation"), "s.d.", quantity.unit, s.standard_deviation});
  row.push_back({key_with(key, "lowest"), "lowest", quantity.unit, s.lowest});
  row.push_back({key_with(key, "highest"), "highest", quantity.unit, s.highest});
}

/// A row per group; `append` adds the spread of each quantity that the group has.
Table grouped(const Table& runs, const std::vector<std::string>& group_keys,
              const std::vector<std::string>& quantities,
              const std::function<void(Row&, const Quantity&, const Spread&)>& append) {
  Table result{"Mean and margin (half range) over runs", {}};
  const std::vector<Quantity> header = runs.header();
  for (const Group& group : groups_of(runs, group_keys)) {
    Row row = group.keys;
    row.push_back({"runs", "runs", "", static_cast<std::int64_t>(group.rows.size())});
    for (const std::string& key : quantities) {
      const std::vector<double> values = numbers_of(group, key);
      const auto known = std::find_if(header.begin(), header.end(),
                                      [&](const Quantity& q) { return q.key == key; });
      if (!values.empty() && known != header.end())
        append(row, *known, spread_of(values));
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

} // namespace

Table summary_for_people(const Table& runs, const std::vector<std::string>& group_keys,
                         const std::vector<std::string>& quantities) {
  return grouped(runs, group_keys, quantities, [](Row& row, const Quantity& q, const Spread& s) {
    const double percent = s.mean != 0.0 ? 100.0 * s.half_range / std::abs(s.mean) : 0.0;
    const std::string words =
        s.count > 1 ? fmt::format("{:.4g} +- {:.2g} ({:.1f} %)", s.mean, s.half_range, percent)
                    : fmt::format("{:.4g} (one run)", s.mean);
    row.push_back({q.key, q.name, q.unit, words});
  });
}

Table summary_of(const Table& runs, const std::vector<std::string>& group_keys,
                 const std::vector<std::string>& quantities) {
  return grouped(runs, group_keys, quantities, append_spread);
}

} // namespace ellipsoid::post
