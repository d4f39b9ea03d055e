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
  explicit PeekedBytes(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {
    char magic[longest_magic];
    std::size_t got = 1;
    while (begin_.size() < longest_magic && got > 0) {
      got = source_->read(magic, longest_magic - begin_.size());
      begin_.append(magic, got);
    }
  }
  const std::string& begin() const { return begin_; }
  std::size_t read(char* buffer, std::size_t size) override {
    if (given_ == begin_.size())
      return source_->read(buffer, size);
    const std::size_t got = begin_.copy(buffer, size, given_);
    given_ += got;
    return got;
  }
  std::uint64_t consumed() const override { return source_->consumed(); }

 private:
  std::unique_ptr<ByteSource> source_;
  std::string begin_;
  std::size_t given_ = 0;
};

/// Bytes that wait for a decompressor, and room for what it gives.
struct Stretch {
  const char* in;
  std::size_t in_left;
  char* out;
  std::size_t out_left;

  void advance(std::size_t read, std::size_t written) {
    in += read;
    in_left -= read;
    out += written;
    out_left -= written;
  }
};

enum class StreamState { goes_on, ended };

/// Decompresses stream after stream (files may be joined).
class Decompressor : public ByteSource {
 public:
  Decompressor(std::unique_ptr<ByteSource> source, const char* name)
      : source_(std::move(source)), name_(name), buffer_(block) {}

  std::size_t read(char* buffer, std::size_t size) override {
    Stretch stretch{buffer_.data() + offset_, held_ - offset_, buffer, size};
    while (stretch.out_left == size) {
      if (stretch.in_left == 0) {
        held_ = source_->read(buffer_.data(), buffer_.size());
        stretch.in = buffer_.data();
        stretch.in_left = held_;
        if (held_ == 0) {
          offset_ = 0;
          if (is_inside_)
            throw broken("unexpected end of file");
          return 0;
        }
      }
      if (!is_inside_) {
        begin();
        is_inside_ = true;
      }
      if (step(stretch) == StreamState::ended)
        is_inside_ = false;
    }
    offset_ = held_ - stretch.in_left;
    return size - stretch.out_left;
  }
  std::uint64_t consumed() const override { return source_->consumed(); }

 protected:
  /// Begins another stream.
  virtual void begin() = 0;
  virtual StreamState step(Stretch& stretch) = 0;
  InputError broken(const std::string& reason) const {
    return InputError(fmt::format("{} data that are broken or cut off ({})", name_, reason));
  }

 private:
  std::unique_ptr<ByteSource> source_;
  const char* name_;
  std::vector<char> buffer_;
  std::size_t offset_ = 0, held_ = 0;
  bool is_inside_ = false; ///< a stream that has not ended
};

class GzipBytes : public Decompressor {
 public:
  explicit GzipBytes(std::unique_ptr<ByteSource> source) : Decompressor(std::move(source), "gzip") {
    constexpr int with_header = 16;
    if (inflateInit2(&stream_, MAX_WBITS + with_header) != Z_OK)
      throw broken("no memory");
  }
  ~GzipBytes() override { inflateEnd(&stream_); }
  GzipBytes(const GzipBytes&) = delete;
  GzipBytes& operator=(const GzipBytes&) = delete;

 private:
  void begin() override { inflateReset(&stream_); }
  StreamState step(Stretch& s) override {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(s.in));
    stream_.avail_in = static_cast<uInt>(s.in_left);
    stream_.next_out = reinterpret_cast<Bytef*>(s.out);
    stream_.avail_out = static_cast<uInt>(std::min<std::size_t>(s.out_left, block));
    const uInt room = stream_.avail_out;
    const int code = inflate(&stream_, Z_NO_FLUSH);
    if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR)
      throw broken(stream_.msg ? stream_.msg : "invalid data");
    s.advance(s.in_left - stream_.avail_in, room - stream_.avail_out);
    return code == Z_STREAM_END ? StreamState::ended : StreamState::goes_on;
  }
  z_stream stream_{};
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
    if (is_open_)
      BZ2_bzDecompressEnd(&stream_);
    is_open_ = false;
  }
  void begin() override {
    end();
    stream_ = bz_stream{};
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK)
      throw broken("no memory");
    is_open_ = true;
  }
  StreamState step(Stretch& s) override {
    stream_.next_in = const_cast<char*>(s.in);
    stream_.avail_in = static_cast<unsigned>(s.in_left);
    stream_.next_out = s.out;
    stream_.avail_out = static_cast<unsigned>(std::min<std::size_t>(s.out_left, block));
    const unsigned room = stream_.avail_out;
    const int code = BZ2_bzDecompress(&stream_);
    if (code != BZ_OK && code != BZ_STREAM_END)
      throw broken("invalid data");
    s.advance(s.in_left - stream_.avail_in, room - stream_.avail_out);
    return code == BZ_STREAM_END ? StreamState::ended : StreamState::goes_on;
  }
  bz_stream stream_{};
  bool is_open_ = false;
};

class XzBytes : public Decompressor {
 public:
  explicit XzBytes(std::unique_ptr<ByteSource> source) : Decompressor(std::move(source), "xz") {}
  ~XzBytes() override { lzma_end(&stream_); }
  XzBytes(const XzBytes&) = delete;
  XzBytes& operator=(const XzBytes&) = delete;

 private:
  void begin() override {
    if (lzma_stream_decoder(&stream_, UINT64_MAX, 0) != LZMA_OK)
      throw broken("no memory");
  }
  StreamState step(Stretch& s) override {
    stream_.next_in = reinterpret_cast<const std::uint8_t*>(s.in);
    stream_.avail_in = s.in_left;
    stream_.next_out = reinterpret_cast<std::uint8_t*>(s.out);
    stream_.avail_out = s.out_left;
    const lzma_ret code = lzma_code(&stream_, LZMA_RUN);
    if (code != LZMA_OK && code != LZMA_STREAM_END)
      throw broken("invalid data");
    s.advance(s.in_left - stream_.avail_in, s.out_left - stream_.avail_out);
    return code == LZMA_STREAM_END ? StreamState::ended : StreamState::goes_on;
  }
  lzma_stream stream_ = LZMA_STREAM_INIT;
};

class ZstdBytes : public Decompressor {
 public:
  explicit ZstdBytes(std::unique_ptr<ByteSource> source)
      : Decompressor(std::move(source), "zstd"), stream_(ZSTD_createDStream()) {
    if (!stream_)
      throw broken("no memory");
  }
  ~ZstdBytes() override { ZSTD_freeDStream(stream_); }
  ZstdBytes(const ZstdBytes&) = delete;
  ZstdBytes& operator=(const ZstdBytes&) = delete;

 private:
  void begin() override { ZSTD_initDStream(stream_); }
  StreamState step(Stretch& s) override {
    ZSTD_inBuffer in{s.in, s.in_left, 0};
    ZSTD_outBuffer out{s.out, s.out_left, 0};
    const std::size_t code = ZSTD_decompressStream(stream_, &out, &in);
    if (ZSTD_isError(code) != 0)
      throw broken(ZSTD_getErrorName(code));
    s.advance(in.pos, out.pos);
    return code == 0 ? StreamState::ended : StreamState::goes_on;
  }
  ZSTD_DStream* stream_;
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
