// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "written_file.h"

#include "input_error.h"
#include "opened_files.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>

namespace ellipsoid::post {

WrittenFile::WrittenFile(const std::string& path) : path_(path), file_(stdout) {
  if (path != "-" && has_been_read(path))
    throw InputError(fmt::format("{}: this file has been read and is not written over: choose "
                                 "another name for the result",
                                 path));
  if (path != "-")
    file_ = std::fopen(path.c_str(), "wb");
  require(file_ != nullptr);
}

WrittenFile::~WrittenFile() {
  if (file_ && file_ != stdout)
    std::fclose(file_);
}

void WrittenFile::require(bool is_good) const {
  if (!is_good)
    throw InputError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void WrittenFile::write(const std::string& text) {
  require(std::fwrite(text.data(), 1, text.size(), file_) == text.size());
}

void WrittenFile::close() {
  std::FILE* file = file_;
  file_ = nullptr;
  require((file == stdout ? std::fflush(file) : std::fclose(file)) == 0);
}

} // namespace ellipsoid::post
