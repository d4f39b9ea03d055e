// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "compressed_bytes.h"

#include <algorithm>
#include <bzlib.h>
#include <cstring>
#include <fmt/format.h>
#include <lzma.h>
#include <zlib.h>
#include <zstd.h>

namespace ellipsoid::post {
namespace {

constexpr std::size_t longest_magic = 6, block = std::size_t{1} << 18;

/// A source whose first bytes were looked at already.
class PeekedBytes : public ByteSource {
 public:
  explicit PeekedBytes(std::unique_ptr<ByteSource> source) : m_source(std::move(source)) {
    char magic[longest_magic];
    std::size_t got = 1;
    while (m_begin.size() < longest_magic && got > 0) {
      got = m_source->read(magic, longest_magic - m_begin.size());
      m_begin.append(magic, got);
    }
  }
  const std::string& begin() const { return m_begin; }
  std::size_t read(char* buffer, std::size_t size) override {
    if (m_given == m_begin.size())
      return m_source->read(buffer, size);
    const std::size_t got = m_begin.copy(buffer, size, m_given);
    m_given += got;
    return got;
  }
  std::uint64_t consumed() const override { return m_source->consumed(); }

 private:
  std::unique_ptr<ByteSource> m_source;
  std::string m_begin;
  std::size_t m_given = 0;
};

/// Bytes that wait for a decompressor, and room for what it gives.
struct Stretch {
  const char* in;
  std::size_t in_left;
  char* out;
  std::size_t out_left;
};

enum class StreamState { goes_on, ended };

/// Decompresses stream after stream (files may be joined).
class Decompressor : public ByteSource {
 public:
  Decompressor(std::unique_ptr<ByteSource> source, const char* name)
      : m_source(std::move(source)), m_name(name), m_buffer(block) {}

  std::size_t read(char* buffer, std::size_t size) override {
    Stretch stretch{m_buffer.data() + m_offset, m_held - m_offset, buffer, size};
    while (stretch.out_left == size) {
      if (stretch.in_left == 0) {
        m_held = m_source->read(m_buffer.data(), m_buffer.size());
        stretch.in = m_buffer.data();
        stretch.in_left = m_held;
        if (m_held == 0) {
          m_offset = 0;
          if (m_is_inside)
            throw broken("unexpected end of file");
          return 0;
        }
      }
      if (!m_is_inside) {
        begin();
        m_is_inside = true;
      }
      if (step(stretch) == StreamState::ended)
        m_is_inside = false;
    }
    m_offset = m_held - stretch.in_left;
    return size - stretch.out_left;
  }
  std::uint64_t consumed() const override { return m_source->consumed(); }

 protected:
  /// Begins another stream.
  virtual void begin() = 0;
  virtual StreamState step(Stretch& stretch) = 0;
  InputError broken(const std::string& reason) const {
    return InputError(fmt::format("{} data that are broken or cut off ({})", m_name, reason));
  }

 private:
  std::unique_ptr<ByteSource> m_source;
  const char* m_name;
  std::vector<char> m_buffer;
  std::size_t m_offset = 0, m_held = 0;
  bool m_is_inside = false; ///< a stream that has not ended
};

class GzipBytes : public Decompressor {
 public:
  explicit GzipBytes(std::unique_ptr<ByteSource> source) : Decompressor(std::move(source), "gzip") {
    constexpr int with_header = 16;
    if (inflateInit2(&m_stream, MAX_WBITS + with_header) != Z_OK)
      throw broken("no memory");
  }
  ~GzipBytes() override { inflateEnd(&m_stream); }
  GzipBytes(const GzipBytes&) = delete;
  GzipBytes& operator=(const GzipBytes&) = delete;

 private:
  void begin() override { inflateReset(&m_stream); }
  StreamState step(Stretch& s) override {
    m_stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(s.in));
    m_stream.avail_in = static_cast<uInt>(s.in_left);
    m_stream.next_out = reinterpret_cast<Bytef*>(s.out);
    m_stream.avail_out = static_cast<uInt>(std::min<std::size_t>(s.out_left, block));
    const uInt room = m_stream.avail_out;
    const int code = inflate(&m_stream, Z_NO_FLUSH);
    if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR)
      throw broken(m_stream.msg ? m_stream.msg : "invalid data");
    s.in += s.in_left - m_stream.avail_in;
    s.in_left = m_stream.avail_in;
    s.out += room - m_stream.avail_out;
    s.out_left -= room - m_stream.avail_out;
    return code == Z_STREAM_END ? StreamState::ended : StreamState::goes_on;
  }
  z_stream m_stream{};
};

class BzipBytes : public Decompressor {
 public:
  explicit BzipBytes(std::unique_ptr<ByteSource> source)
      : Decompressor(std::move(source), "bzip2") {}
  ~BzipBytes() override { end(); }
  BzipBytes(const BzipBytes&) = delete;
  BzipBytes& operator=(const BzipBytes&) = delete;

 private:
  void end() {
    if (m_is_open)
      BZ2_bzDecompressEnd(&m_stream);
    m_is_open = false;
  }
  void begin() override {
    end();
    m_stream = bz_stream{};
    if (BZ2_bzDecompressInit(&m_stream, 0, 0) != BZ_OK)
      throw broken("no memory");
    m_is_open = true;
  }
  StreamState step(Stretch& s) override {
    m_stream.next_in = const_cast<char*>(s.in);
    m_stream.avail_in = static_cast<unsigned>(s.in_left);
    m_stream.next_out = s.out;
    m_stream.avail_out = static_cast<unsigned>(std::min<std::size_t>(s.out_left, block));
    const unsigned room = m_stream.avail_out;
    const int code = BZ2_bzDecompress(&m_stream);
    if (code != BZ_OK && code != BZ_STREAM_END)
      throw broken("invalid data");
    s.in += s.in_left - m_stream.avail_in;
    s.in_left = m_stream.avail_in;
    s.out += room - m_stream.avail_out;
    s.out_left -= room - m_stream.avail_out;
    return code == BZ_STREAM_END ? StreamState::ended : StreamState::goes_on;
  }
  bz_stream m_stream{};
  bool m_is_open = false;
};

class XzBytes : public Decompressor {
 public:
  explicit XzBytes(std::unique_ptr<ByteSource> source) : Decompressor(std::move(source), "xz") {}
  ~XzBytes() override { lzma_end(&m_stream); }
  XzBytes(const XzBytes&) = delete;
  XzBytes& operator=(const XzBytes&) = delete;

 private:
  void begin() override {
    if (lzma_stream_decoder(&m_stream, UINT64_MAX, 0) != LZMA_OK)
      throw broken("no memory");
  }
  StreamState step(Stretch& s) override {
    m_stream.next_in = reinterpret_cast<const std::uint8_t*>(s.in);
    m_stream.avail_in = s.in_left;
    m_stream.next_out = reinterpret_cast<std::uint8_t*>(s.out);
    m_stream.avail_out = s.out_left;
    const lzma_ret code = lzma_code(&m_stream, LZMA_RUN);
    if (code != LZMA_OK && code != LZMA_STREAM_END)
      throw broken("invalid data");
    s.in += s.in_left - m_stream.avail_in;
    s.in_left = m_stream.avail_in;
    s.out += s.out_left - m_stream.avail_out;
    s.out_left = m_stream.avail_out;
    return code == LZMA_STREAM_END ? StreamState::ended : StreamState::goes_on;
  }
  lzma_stream m_stream = LZMA_STREAM_INIT;
};

class ZstdBytes : public Decompressor {
 public:
  explicit ZstdBytes(std::unique_ptr<ByteSource> source)
      : Decompressor(std::move(source), "zstd"), m_stream(ZSTD_createDStream()) {
    if (!m_stream)
      throw broken("no memory");
  }
  ~ZstdBytes() override { ZSTD_freeDStream(m_stream); }
  ZstdBytes(const ZstdBytes&) = delete;
  ZstdBytes& operator=(const ZstdBytes&) = delete;

 private:
  void begin() override { ZSTD_initDStream(m_stream); }
  StreamState step(Stretch& s) override {
    ZSTD_inBuffer in{s.in, s.in_left, 0};
    ZSTD_outBuffer out{s.out, s.out_left, 0};
    const std::size_t code = ZSTD_decompressStream(m_stream, &out, &in);
    if (ZSTD_isError(code) != 0)
      throw broken(ZSTD_getErrorName(code));
    s.in += in.pos;
    s.in_left -= in.pos;
    s.out += out.pos;
    s.out_left -= out.pos;
    return code == 0 ? StreamState::ended : StreamState::goes_on;
  }
  ZSTD_DStream* m_stream;
};

} // namespace

std::unique_ptr<ByteSource> decompressed(std::unique_ptr<ByteSource> source) {
  auto peeked = std::make_unique<PeekedBytes>(std::move(source));
  const std::string begin = peeked->begin();
  const auto is = [&begin](std::string_view magic) { return starts_with(begin, magic); };
  if (is("\x1f\x8b"))
    return std::make_unique<GzipBytes>(std::move(peeked));
  if (is("BZh"))
    return std::make_unique<BzipBytes>(std::move(peeked));
  if (is(std::string_view("\xfd"
                          "7zXZ\0",
                          6)))
    return std::make_unique<XzBytes>(std::move(peeked));
  if (is("\x28\xb5\x2f\xfd"))
    return std::make_unique<ZstdBytes>(std::move(peeked));
  return peeked;
}

} // namespace ellipsoid::post
