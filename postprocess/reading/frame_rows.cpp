// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_rows.h"

#include "byte_source.h"
#include "number_text.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

/// Values for which memory is set aside before they were seen: a wrong count in a broken file must
/// not ask for all the memory of the machine.
constexpr std::size_t most_values_ahead = std::size_t{1} << 16;

} // namespace

RowReader::RowReader(Frame& frame) : frame_(frame), values_(frame.names.size(), nullptr) {
  frame.columns.resize(frame.names.size());
  frame.unreadable.clear();
}

void RowReader::set_memory_aside() {
  const std::size_t more = std::max(std::size_t{1}, most_values_ahead / values_.size());
  held_ = std::min(frame_.rows, held_ + more);
  for (std::size_t k = 0; k < values_.size(); ++k) {
    frame_.columns[k].resize(held_);
    values_[k] = frame_.columns[k].data();
  }
}

FileLocation RowReader::here() const {
  return {frame_.location.file, frame_.location.line + row_, frame_.location.frame};
}

void RowReader::set_unreadable(std::size_t column, std::string_view token) {
  frame_.unreadable.resize(values_.size());
  std::string& message = frame_.unreadable[column];
  if (message.empty())
    message =
        unexpected(here(), fmt::format("a finite number in column \"{}\"", frame_.names[column]),
                   quoted(std::string(token)))
            .what();
}

/// False when the line has another number of values.
bool RowReader::parse(std::string_view line) {
  const char* at = line.data();
  const char* const end = at + line.size();
  const auto skip = [&](bool blanks) {
    while (at < end && is_blank(*at) == blanks)
      ++at;
  };
  for (std::size_t k = 0; k < values_.size(); ++k) {
    skip(true);
    if (at == end)
      return false;
    const char* const token = at;
    if ((at = read_number(token, end, values_[k][row_])))
      continue;
    at = token;
    skip(false);
    values_[k][row_] = 0.0;
    set_unreadable(k, {token, static_cast<std::size_t>(at - token)});
  }
  skip(true);
  return at == end;
}

/// What is wrong with a row that was not taken.
InputError RowReader::refused(std::string_view line) const {
  std::size_t count = 0;
  for (std::string_view rest = line; !next_token(rest).empty();)
    ++count;
  const std::size_t columns = values_.size();
  return unexpected(here(),
                    fmt::format("{} values in row {} of {}", columns, row_ + 1, frame_.rows),
                    fmt::format("{}: {}", count > columns ? "more" : fmt::format("{}", count),
                                quoted(std::string(line))));
}

void RowReader::read(std::string_view line) {
  if (row_ == held_)
    set_memory_aside();
  if (!parse(line))
    throw refused(line);
  ++row_;
}

void RowReader::read_lines(std::string_view text) {
  const bool is_binary = std::memchr(text.data(), '\0', text.size()) != nullptr;
  while (!text.empty()) {
    const std::size_t length = text.find('\n');
    const std::string_view line = without_return(text.substr(0, length));
    if (is_binary && line.find('\0') != line.npos)
      throw nul_byte(here());
    read(line);
    text.remove_prefix(length + 1);
  }
}

void RowReader::drop_missing_rows() {
  for (auto& column : frame_.columns)
    column.resize(std::min(column.size(), row_));
}

void read_rows(Frame& frame) {
  if (frame.unread.empty())
    return;
  RowReader reader(frame);
  reader.read_lines(frame.unread);
  reader.drop_missing_rows();
  frame.unread.clear();
}

} // namespace ellipsoid::post
