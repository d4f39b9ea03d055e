// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "byte_source.h"

#include "compressed_bytes.h"
#include "input_error.h"
#include "opened_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <mutex>
#include <set>
#include <sys/stat.h>
#include <utility>

namespace ellipsoid::post {
namespace {

class PlainFile : public ByteSource {
 public:
  explicit PlainFile(std::FILE* file) : file_(file) {}
  ~PlainFile() override {
    if (file_ != stdin)
      std::fclose(file_);
  }
  PlainFile(const PlainFile&) = delete;
  PlainFile& operator=(const PlainFile&) = delete;

  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t got = std::fread(buffer, 1, size, file_);
    if (got < size && std::ferror(file_))
      throw InputError(fmt::format("a file that cannot be read ({})", std::strerror(errno)));
    consumed_ += got;
    return got;
  }
  std::uint64_t consumed() const override { return consumed_; }

 private:
  std::FILE* file_;
  std::uint64_t consumed_ = 0;
};

} // namespace

namespace {

/// Files by device and number.
using OpenedFiles = std::set<std::pair<dev_t, ino_t>>;

std::pair<OpenedFiles&, std::mutex&> opened_files() {
  static OpenedFiles files;
  static std::mutex mutex;
  return {files, mutex};
}

} // namespace

bool has_been_read(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0)
    return false;
  const auto [files, mutex] = opened_files();
  const std::lock_guard<std::mutex> lock(mutex);
  return files.count({status.st_dev, status.st_ino}) > 0;
}

std::unique_ptr<ByteSource> open_bytes(const std::string& path) {
  if (path == "-")
    return decompressed(std::make_unique<PlainFile>(stdin));
  struct stat status {};
  const bool is_there = stat(path.c_str(), &status) == 0;
  if (is_there && S_ISREG(status.st_mode)) {
    const auto [files, mutex] = opened_files();
    const std::lock_guard<std::mutex> lock(mutex);
    files.insert({status.st_dev, status.st_ino});
  }
  if (is_there && S_ISDIR(status.st_mode))
    throw InputError(fmt::format("{}: is a directory; give the dump files in it", path));
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file)
    throw InputError(fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
  return decompressed(std::make_unique<PlainFile>(file));
}

std::string_view next_token(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end]))
    ++end;
  const std::string_view token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

LineReader::LineReader(std::unique_ptr<ByteSource> source, std::string name)
    : source_(std::move(source)), name_(std::move(name)), buffer_(std::size_t{1} << 18) {}

bool LineReader::refill() {
  if (broken_)
    throw BrokenLine(*broken_);
  if (at_end_)
    return false;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ + 1 == buffer_.size())
    buffer_.resize(2 * buffer_.size());
  std::size_t got = 0;
  try {
    got = source_->read(buffer_.data() + end_, buffer_.size() - end_ - 1);
  } catch (const InputError& error) {
    broken_.emplace(next_location(), "more data", error.what());
    throw BrokenLine(*broken_);
  }
  end_ += got;
  buffer_[end_] = '\n';
  at_end_ = got == 0;
  return got > 0;
}

bool LineReader::deliver(std::size_t length, std::size_t skipped, std::string_view& line) {
  ++line_number_;
  line = without_return({buffer_.data() + begin_, length});
  begin_ += length + skipped;
  line_has_end_ = skipped > 0;
  if (!line.empty() && std::memchr(line.data(), '\0', line.size()))
    throw nul_byte({name_, line_number_, 0});
  return true;
}

bool LineReader::refill_or_leave_to_next() {
  try {
    return end_ - begin_ <= longest_line && refill();
  } catch (const BrokenLine&) {
    return false; // `next` throws it again
  }
}

std::size_t LineReader::append_lines(std::size_t most, std::string_view stop, std::size_t enough,
                                     std::string& text) {
  std::size_t lines = 0;
  bool is_stopped = false;
  do {
    const char* const begin = buffer_.data() + begin_;
    const char* const end = buffer_.data() + end_;
    const char* at = begin;
    const std::size_t lines_before = lines;
    while (lines < most) {
      const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
      const char* newline = static_cast<const char*>(found);
      if (!newline)
        break;
      is_stopped = starts_with({at, static_cast<std::size_t>(newline - at)}, stop);
      if (is_stopped)
        break;
      at = newline + 1;
      ++lines;
    }
    text.append(begin, at);
    begin_ += static_cast<std::size_t>(at - begin);
    line_number_ += lines - lines_before;
    is_stopped = is_stopped || lines == most || text.size() > enough;
  } while (!is_stopped && refill_or_leave_to_next());
  return lines;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  for (;;) {
    const char* begin = buffer_.data() + begin_;
    const std::size_t held = end_ - begin_;
    const void* newline =
        held > searched ? std::memchr(begin + searched, '\n', held - searched) : nullptr;
    if (newline)
      return deliver(static_cast<std::size_t>(static_cast<const char*>(newline) - begin), 1, line);
    if (held > longest_line)
      throw BrokenLine(next_location(), "lines of text",
                       fmt::format("a line of more than {} bytes", longest_line));
    searched = held;
    if (!refill())
      return end_ > begin_ && deliver(end_ - begin_, 0, line);
  }
}

BrokenLine nul_byte(const FileLocation& location) {
  return {location, "text", "a NUL byte: these are binary data"};
}

} // namespace ellipsoid::post
