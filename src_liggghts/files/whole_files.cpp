// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "whole_files.h"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

using LAMMPS_NS::bigint;
using LAMMPS_NS::Error;

namespace ellipsoid_host {

namespace {

struct Seal { // the last bytes of a restart file
  char mark[8];
  std::uint64_t length; // bytes before the seal
  std::int64_t step;
  std::uint64_t checksum; // of these bytes, length and step
};
constexpr char seal_mark[8] = {'E', 'L', 'L', 'S', 'E', 'A', 'L', '1'};
constexpr char own_version[] = "liggghts-ellipsoid";
constexpr char data_end[] = "# end of data file\n";
constexpr char data_title[] = "LAMMPS data file via write_data";
constexpr std::size_t longest_version = 512, longest_title = 1024;

struct Target {
  std::string name, present_name;
};
std::map<std::FILE*, Target>& open_files() {
  static std::map<std::FILE*, Target> files;
  return files;
}

/// FNV-1a, 64 bits: one changed byte always changes it.
class Checksum {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < size; ++k)
      value_ = (value_ ^ bytes[k]) * 1099511628211u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

/// Seal of a file whose first `length` bytes are read from `file`; length 0 if there are fewer.
Seal seal_of(std::FILE* file, std::uint64_t length, std::int64_t step) {
  Seal seal{};
  std::memcpy(seal.mark, seal_mark, sizeof seal_mark);
  Checksum checksum;
  std::vector<char> buffer(1 << 16);
  std::rewind(file);
  while (seal.length < length) {
    const auto left = length - seal.length;
    const auto wanted = left < buffer.size() ? static_cast<std::size_t>(left) : buffer.size();
    const std::size_t got = std::fread(buffer.data(), 1, wanted, file);
    if (got == 0)
      return Seal{};
    checksum.add(buffer.data(), got);
    seal.length += got;
  }
  seal.step = step;
  checksum.add(&seal.length, sizeof seal.length);
  checksum.add(&seal.step, sizeof seal.step);
  seal.checksum = checksum.value();
  return seal;
}

/// Bytes of an open file.
std::uint64_t size_of(std::FILE* file) {
  std::fseek(file, 0, SEEK_END);
  return static_cast<std::uint64_t>(std::ftell(file));
}

[[noreturn]] void refuse(Error* error, const std::string& kind, const std::string& name,
                         const std::string& problem) {
  error->one(FLERR, (kind + " file '" + name + "' " + problem).c_str());
  std::abort(); // not reached: the call above ends the program
}

/// A finished file gets its name; one that is not whole is removed and reported.
void close_and_rename(Error* error, const char* kind, std::FILE* file, bool complete) {
  const Target target = open_files()[file];
  open_files().erase(file);
  complete = std::fflush(file) == 0 && complete && std::ferror(file) == 0;
  int problem = errno;
  const bool renamed = target.present_name != target.name;
  if (complete && renamed && fsync(fileno(file)) != 0) {
    complete = false;
    problem = errno;
  }
  std::fclose(file);
  if (complete && renamed && std::rename(target.present_name.c_str(), target.name.c_str()) != 0) {
    complete = false;
    problem = errno;
  }
  if (complete)
    return;
  if (renamed)
    std::remove(target.present_name.c_str());
  refuse(error, kind, target.name,
         std::string("could not be written (") + std::strerror(problem) +
             "); make room or give another folder: an older file of this name is still there");
}

enum class SealState { missing, wrong, right };

/// Is the file as it was sealed? `step` is that of the seal.
SealState seal_state(std::FILE* file, std::int64_t& step) {
  Seal found{};
  const std::uint64_t size = size_of(file);
  if (size < sizeof found)
    return SealState::missing;
  std::fseek(file, -static_cast<long>(sizeof found), SEEK_END);
  if (std::fread(&found, sizeof found, 1, file) != 1 ||
      std::memcmp(found.mark, seal_mark, sizeof seal_mark) != 0)
    return SealState::missing;
  step = found.step;
  const Seal expected = seal_of(file, size - sizeof found, found.step);
  return expected.length == found.length && expected.checksum == found.checksum ? SealState::right
                                                                                : SealState::wrong;
}

constexpr char cut[] = "is cut or damaged: its end is missing; use an older restart file";
constexpr char damaged[] =
    "is damaged: its content does not have the checksum at its end; use an older restart file";

/// The version line that a restart file of any LIGGGHTS begins with; empty if it does not.
std::string version_line(std::FILE* file) {
  int head[2] = {-1, 0}; // number of the entry, length of the text
  std::rewind(file);
  if (std::fread(head, sizeof head, 1, file) != 1 || head[0] != 0 || head[1] < 1 ||
      head[1] > static_cast<int>(longest_version))
    return {};
  std::vector<char> text(static_cast<std::size_t>(head[1]));
  if (std::fread(text.data(), 1, text.size(), file) != text.size())
    return {};
  return std::string(text.begin(), text.end());
}

} // namespace

std::FILE* create_file(const char* name, const char* mode) {
  const std::string whole = name;
  const std::size_t slash = whole.rfind('/'), base = slash == std::string::npos ? 0 : slash + 1;
  // a name that `read_restart base.*` does not take for a file of a time step
  std::string present = whole.substr(0, base) + "." + whole.substr(base) + ".partial";
  struct stat status;
  if (lstat(name, &status) == 0 && !S_ISREG(status.st_mode))
    present = whole;
  std::FILE* file = std::fopen(present.c_str(), (std::string(mode) + "+").c_str());
  if (file)
    open_files()[file] = {whole, present};
  return file;
}

void finish_restart_file(Error* error, std::FILE* file, bigint step) {
  bool complete = std::fflush(file) == 0 && std::ferror(file) == 0;
  if (complete) {
    const std::uint64_t length = size_of(file);
    const Seal seal = seal_of(file, length, step);
    std::fseek(file, 0, SEEK_END);
    complete = seal.length == length && std::fwrite(&seal, sizeof seal, 1, file) == 1;
  }
  close_and_rename(error, "Restart", file, complete);
}

void finish_data_file(Error* error, std::FILE* file) {
  const bool complete = std::fprintf(file, "\n%s", data_end) > 0;
  close_and_rename(error, "Data", file, complete);
}

void check_restart_file(Error* error, const char* name) {
  std::FILE* file = std::fopen(name, "rb");
  if (!file)
    return;
  std::int64_t step = 0;
  const SealState state = seal_state(file, step);
  const std::string version = version_line(file);
  std::fclose(file);
  if (state == SealState::wrong)
    refuse(error, "Restart", name, damaged);
  if (state == SealState::right)
    return;
  if (version.empty())
    refuse(error, "Restart", name,
           "does not begin as a restart file does: it is cut, damaged or something else; use an "
           "older restart file");
  if (version.find(own_version) != std::string::npos)
    refuse(error, "Restart", name, cut);
  error->warning(FLERR, (std::string("Restart file '") + name +
                         "' has no checksum; it was written by another LIGGGHTS")
                            .c_str());
}

void check_rank_file(Error* error, const char* name, bigint step) {
  std::FILE* file = std::fopen(name, "rb");
  if (!file)
    return;
  std::int64_t sealed_step = step;
  const SealState state = seal_state(file, sealed_step);
  int count = 0;
  std::rewind(file);
  const bool begins = std::fread(&count, sizeof count, 1, file) == 1 && count >= 0;
  const std::uint64_t content = sizeof count + sizeof(double) * static_cast<std::uint64_t>(count);
  const bool complete = begins && content == size_of(file); // as another LIGGGHTS writes it
  std::fclose(file);
  if (state == SealState::wrong)
    refuse(error, "Restart", name, damaged);
  if (state == SealState::missing && !complete)
    refuse(error, "Restart", name, cut);
  if (sealed_step != step)
    refuse(error, "Restart", name,
           "is of time step " + std::to_string(sealed_step) + ", the file of all ranks of " +
               std::to_string(step) + "; use restart files of one time step");
}

void check_data_file(Error* error, const char* name) {
  std::FILE* file = std::fopen(name, "r");
  struct stat status;
  if (!file)
    return;
  if (fstat(fileno(file), &status) != 0 || !S_ISREG(status.st_mode)) {
    std::fclose(file);
    return;
  }
  std::vector<char> title(longest_title);
  const bool begins = std::fgets(title.data(), static_cast<int>(title.size()), file) != nullptr;
  const std::string first = begins ? title.data() : "";
  std::string last(sizeof data_end - 1, ' ');
  const bool long_enough = std::fseek(file, -static_cast<long>(last.size()), SEEK_END) == 0;
  const bool ended =
      long_enough && std::fread(&last[0], 1, last.size(), file) == last.size() && last == data_end;
  std::fclose(file);
  if (first.empty() || first.back() != '\n')
    refuse(error, "Data", name,
           "has no complete first line: it is cut or no data file; write it again");
  const bool own = first.compare(0, std::strlen(data_title), data_title) == 0 &&
                   first.find(own_version) != std::string::npos;
  if (own && !ended)
    refuse(error, "Data", name,
           std::string("is cut: it does not end with the line '") +
               std::string(data_end, sizeof data_end - 2) +
               "' of write_data; use an older data file");
}

} // namespace ellipsoid_host
