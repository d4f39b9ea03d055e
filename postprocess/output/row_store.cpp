// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "row_store.h"

#include "input_error.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// A row: its number of values, and of each its column, its kind (place in the variant) and bytes.
template <class Number> void append(std::string& bytes, Number number) {
  char text[sizeof(Number)];
  std::memcpy(text, &number, sizeof(Number));
  bytes.append(text, sizeof(Number));
}

void append_value(std::string& bytes, const Value& value) {
  append(bytes, static_cast<std::uint8_t>(value.index()));
  if (const auto* flag = std::get_if<bool>(&value))
    append(bytes, static_cast<std::uint8_t>(*flag ? 1 : 0));
  else if (const auto* integer = std::get_if<std::int64_t>(&value))
    append(bytes, *integer);
  else if (const auto* real = std::get_if<double>(&value))
    append(bytes, *real);
  else if (const auto* text = std::get_if<std::string>(&value)) {
    append(bytes, static_cast<std::uint64_t>(text->size()));
    bytes += *text;
  }
}

InputError file_error(const char* what) {
  return InputError(fmt::format("the rows of a long table are kept in a temporary file, which "
                                "cannot be {}: {}",
                                what, std::strerror(errno)));
}

/// Reads what is in the file, then what is in memory.
class StoredBytes {
 public:
  StoredBytes(std::FILE* file, const std::string& held) : file_(file), held_(held) {
    if (file_ && std::fseek(file_, 0, SEEK_SET) != 0)
      throw file_error("read");
  }

  template <class Number> Number number() {
    Number value{};
    read(reinterpret_cast<char*>(&value), sizeof(Number));
    return value;
  }

  std::string text() {
    std::string value(number<std::uint64_t>(), '\0');
    read(value.data(), value.size());
    return value;
  }

  Value value() {
    switch (number<std::uint8_t>()) {
    case 1:
      return number<std::uint8_t>() == 1;
    case 2:
      return number<std::int64_t>();
    case 3:
      return number<double>();
    case 4:
      return text();
    default:
      return std::monostate();
    }
  }

 private:
  /// A row is wholly in the file or wholly in memory.
  void read(char* bytes, std::size_t count) {
    if (count == 0)
      return;
    if (file_ && std::fread(bytes, 1, count, file_) == count)
      return;
    if (file_ && std::ferror(file_) != 0)
      throw file_error("read");
    file_ = nullptr;
    held_.copy(bytes, count, at_);
    at_ += count;
  }

  std::FILE* file_;
  const std::string& held_;
  std::size_t at_ = 0;
};

} // namespace

RowStore::RowStore(std::size_t most_held) : most_held_(most_held), file_(nullptr, &std::fclose) {}

/// @param[in] usual where it is if rows are alike
std::size_t RowStore::column_of(const Quantity& q, std::size_t usual) {
  if (usual < header_.size() && header_[usual].key == q.key)
    return usual;
  const auto [place, is_new] = columns_.try_emplace(q.key, header_.size());
  if (is_new)
    header_.push_back(q);
  return place->second;
}

void RowStore::add(const Row& row) {
  append(held_, static_cast<std::uint32_t>(row.size()));
  for (std::size_t k = 0; k < row.size(); ++k) {
    append(held_, static_cast<std::uint32_t>(column_of(row[k], k)));
    append_value(held_, row[k].value);
  }
  ++size_;
  if (held_.size() <= most_held_)
    return;
  if (!file_)
    file_.reset(std::tmpfile());
  if (!file_ || std::fseek(file_.get(), 0, SEEK_END) != 0 ||
      std::fwrite(held_.data(), 1, held_.size(), file_.get()) != held_.size() ||
      std::fflush(file_.get()) != 0)
    throw file_error("written");
  held_.clear();
}

void RowStore::visit(const std::function<void(const Row&)>& use) const {
  StoredBytes bytes(file_.get(), held_);
  Row row;
  for (std::size_t n = 0; n < size_; ++n) {
    row.resize(bytes.number<std::uint32_t>());
    for (Quantity& q : row) {
      const Quantity& known = header_[bytes.number<std::uint32_t>()];
      if (q.key != known.key) // rows are mostly alike
        q = known;
      q.value = bytes.value();
    }
    use(row);
  }
}

Table RowStore::table(const std::string& title) const {
  Table all{title, {}};
  visit([&all](const Row& row) { all.rows.push_back(row); });
  return all;
}

} // namespace ellipsoid::post
