// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A file that is in memory.
#pragma once

#include "byte_source.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace ellipsoid::post {

class MemoryBytes : public ByteSource {
 public:
  explicit MemoryBytes(std::string content) : content_(std::move(content)) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t got = content_.copy(buffer, size, offset_);
    offset_ += got;
    return got;
  }
  std::uint64_t consumed() const override { return offset_; }

 private:
  std::string content_;
  std::size_t offset_ = 0;
};

inline std::unique_ptr<ByteSource> memory_bytes(std::string content) {
  return std::make_unique<MemoryBytes>(std::move(content));
}

} // namespace ellipsoid::post
