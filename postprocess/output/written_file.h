// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <cstdio>
#include <string>

namespace ellipsoid::post {

/// A result that is written piece by piece; all throws InputError where it cannot be written.
class WrittenFile {
 public:
  /// @param[in] path "-": standard output. One that has been read is refused.
  explicit WrittenFile(const std::string& path);
  ~WrittenFile();
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;

  void write(const std::string& text);
  void close(); ///< or the flush of standard output

 private:
  void require(bool is_good) const;

  std::string path_;
  std::FILE* file_;
};

} // namespace ellipsoid::post
