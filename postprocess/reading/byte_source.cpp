// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "byte_source.h"

#include "compressed_bytes.h"
#include "input_error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>

namespace ellipsoid::post {
namespace {

class PlainFile : public ByteSource {
 public:
  explicit PlainFile(std::FILE* file) : m_file(file) {}
  ~PlainFile() override {
    if (m_file != stdin)
      std::fclose(m_file);
  }
  PlainFile(const PlainFile&) = delete;
  PlainFile& operator=(const PlainFile&) = delete;

  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t got = std::fread(buffer, 1, size, m_file);
    if (got < size && std::ferror(m_file))
      throw InputError(fmt::format("a file that cannot be read ({})", std::strerror(errno)));
    m_consumed += got;
    return got;
  }
  std::uint64_t consumed() const override { return m_consumed; }

 private:
  std::FILE* m_file;
  std::uint64_t m_consumed = 0;
};

class MemoryBytes : public ByteSource {
 public:
  explicit MemoryBytes(std::string content) : m_content(std::move(content)) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t got = m_content.copy(buffer, size, m_offset);
    m_offset += got;
    return got;
  }
  std::uint64_t consumed() const override { return m_offset; }

 private:
  std::string m_content;
  std::size_t m_offset = 0;
};

} // namespace

std::unique_ptr<ByteSource> open_bytes(const std::string& path) {
  if (path == "-")
    return decompressed(std::make_unique<PlainFile>(stdin));
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode))
    throw InputError(fmt::format("{}: is a directory; give the dump files in it", path));
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file)
    throw InputError(fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
  return decompressed(std::make_unique<PlainFile>(file));
}

std::unique_ptr<ByteSource> memory_bytes(std::string content) {
  return std::make_unique<MemoryBytes>(std::move(content));
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
    : m_source(std::move(source)), m_name(std::move(name)), m_buffer(std::size_t{1} << 18) {}

bool LineReader::refill() {
  if (m_broken)
    throw BrokenLine(*m_broken);
  if (m_at_end)
    return false;
  std::memmove(m_buffer.data(), m_buffer.data() + m_begin, m_end - m_begin);
  m_end -= m_begin;
  m_begin = 0;
  if (m_end + 1 == m_buffer.size())
    m_buffer.resize(2 * m_buffer.size());
  std::size_t got = 0;
  try {
    got = m_source->read(m_buffer.data() + m_end, m_buffer.size() - m_end - 1);
  } catch (const InputError& error) {
    m_broken.emplace(next_location(), "more data", error.what());
    throw BrokenLine(*m_broken);
  }
  m_end += got;
  m_buffer[m_end] = '\n';
  m_at_end = got == 0;
  return got > 0;
}

bool LineReader::deliver(std::size_t length, std::size_t skipped, std::string_view& line) {
  ++m_line_number;
  line = without_return({m_buffer.data() + m_begin, length});
  m_begin += length + skipped;
  if (!line.empty() && std::memchr(line.data(), '\0', line.size()))
    throw nul_byte({m_name, m_line_number, 0});
  return true;
}

bool LineReader::refill_or_leave_to_next() {
  try {
    return m_end - m_begin <= longest_line && refill();
  } catch (const BrokenLine&) {
    return false; // `next` throws it again
  }
}

std::size_t LineReader::append_lines(std::size_t most, std::string_view stop, std::size_t enough,
                                     std::string& text) {
  std::size_t lines = 0;
  bool is_stopped = false;
  do {
    const char* const begin = m_buffer.data() + m_begin;
    const char* const end = m_buffer.data() + m_end;
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
    m_begin += static_cast<std::size_t>(at - begin);
    m_line_number += lines - lines_before;
    is_stopped = is_stopped || lines == most || text.size() > enough;
  } while (!is_stopped && refill_or_leave_to_next());
  return lines;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  for (;;) {
    const char* begin = m_buffer.data() + m_begin;
    const std::size_t held = m_end - m_begin;
    const void* newline =
        held > searched ? std::memchr(begin + searched, '\n', held - searched) : nullptr;
    if (newline)
      return deliver(static_cast<std::size_t>(static_cast<const char*>(newline) - begin), 1, line);
    if (held > longest_line)
      throw BrokenLine(next_location(), "lines of text",
                       fmt::format("a line of more than {} bytes", longest_line));
    searched = held;
    if (!refill())
      return m_end > m_begin && deliver(m_end - m_begin, 0, line);
  }
}

BrokenLine nul_byte(const FileLocation& location) {
  return {location, "text", "a NUL byte: these are binary data"};
}

} // namespace ellipsoid::post
