#include "kiosk/ground/files/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/files_read.h"
#include "kiosk/ground/files/output_kind.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

/// The file behind a name, links followed.
struct FileInfo {
  bool there = false;
  struct stat info {};
};

FileInfo standing(const std::string& where) {
  FileInfo found;
  found.there = ::stat(where.c_str(), &found.info) == 0;
  return found;
}

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

const char* name_of(Output::Kind kind) {
  switch (kind) {
    case Output::Kind::json:
      return "report in JSON";
    case Output::Kind::csv:
      return "table in CSV";
    case Output::Kind::glb:
      return "GLB";
    case Output::Kind::wav:
      return "sound in WAV";
    case Output::Kind::archive:
      return "packed archive";
    case Output::Kind::png:
      return "PNG";
    case Output::Kind::stl:
      return "binary STL";
    case Output::Kind::picture:
      break;
  }
  return "picture of this kind";
}

const char* format_of(Output::Kind kind) {
  return kind == Output::Kind::picture ? "PNG" : name_of(kind);
}

const char* endings_of(Output::Kind kind) {
  switch (kind) {
    case Output::Kind::json:
      return ".json";
    case Output::Kind::csv:
      return ".csv";
    case Output::Kind::glb:
      return ".glb";
    case Output::Kind::wav:
      return ".wav";
    case Output::Kind::archive:
      return ".tar.gz";
    case Output::Kind::png:
      return ".png";
    case Output::Kind::stl:
      return ".stl";
    case Output::Kind::picture:
      break;
  }
  return ".png or .svg";
}

fs::path folder_for(const std::string& where) {
  const fs::path folder = fs::path(where).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

Result<void> check_new(const std::string& where) {
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(where, ignored)))
    return problem(where, "This link points to a file that does not exist.",
                   "Create that file, or name another file.");
  const fs::path folder = folder_for(where);
  const FileInfo above = standing(folder.string());
  if (!above.there)
    return problem(
        where, "The folder " + folder.string() + " does not exist.",
        "Create it first: mkdir -p '" + folder.string() + "'. Or name a file elsewhere.");
  if (!S_ISDIR(above.info.st_mode) || fs::path(where).filename().empty())
    return problem(where, folder.string() + " is not a folder.", "Name a file in a folder.");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return tl::unexpected(disk_problem(where, "write", errno));
  return {};
}

/// Writes to a device or a pipe, which is never replaced.
Result<void> write_to_stream(const std::string& where, std::span<const std::byte> bytes) {
  // Without O_NONBLOCK, opening a pipe that has no reader would wait forever.
  const Descriptor out(::open(where.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!out.open() && errno == ENXIO)
    return problem(where, "No program reads from this pipe.", "Start the reading program first.");
  struct stat info {};
  if (!out.open() || ::fstat(out.get(), &info) != 0)
    return tl::unexpected(disk_problem(where, "write", errno));
  if (!S_ISCHR(info.st_mode) && !S_ISFIFO(info.st_mode))
    return problem(where, "The file was replaced while it was being checked.", "Try again.", 1);
  ::fcntl(out.get(), F_SETFL, 0);
  if (!write_all(out.get(), bytes)) return tl::unexpected(disk_problem(where, "write", errno));
  return {};
}

Result<void> write_to_stdout(std::span<const std::byte> bytes) {
  std::cout.flush();
  std::fflush(stdout);
  if (write_all(STDOUT_FILENO, bytes)) return {};
  return tl::unexpected(disk_problem("standard output", "write", errno));
}

}  // namespace

bool Output::to_stdout() const {
  if (where_ == "-") return true;
  struct stat out {};
  const FileInfo found = standing(where_);
  return found.there && ::fstat(STDOUT_FILENO, &out) == 0 && same_file(found.info, out) &&
         (S_ISREG(out.st_mode) || S_ISFIFO(out.st_mode));
}

bool Output::clashes_with(const Output& other) const {
  if (!wanted() || !other.wanted()) return false;
  if (to_stdout() || other.to_stdout()) return to_stdout() && other.to_stdout();
  const FileInfo mine = standing(where_), its = standing(other.where_);
  if (mine.there && its.there) return S_ISREG(mine.info.st_mode) && same_file(mine.info, its.info);
  // A name of a file that is not there yet stays relative if it is not made absolute first.
  const auto real = [](const std::string& where) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(where, ignored), ignored);
  };
  return mine.there == its.there && real(where_) == real(other.where_);
}

Result<void> Output::check() const {
  if (!wanted() || to_stdout()) return {};
  const FileInfo found = standing(where_);
  const bool file = !found.there || S_ISREG(found.info.st_mode);
  if (file && !forced_ && !name_agrees(where_, kind_))
    return problem(
        where_,
        "The name ends in " + fs::path(where_).extension().string() +
            ", but this is written as a " + format_of(kind_) + ".",
        std::string("Name a file that ends in ") + endings_of(kind_) + ", or add --force.");
  if (!found.there) return check_new(where_);
  const mode_t mode = found.info.st_mode;
  if (S_ISCHR(mode) || S_ISFIFO(mode)) return {};
  if (S_ISDIR(mode)) return problem(where_, "This is a folder.", "Name a file in it.");
  if (!S_ISREG(mode))
    return problem(
        where_,
        S_ISBLK(mode) ? "This is a disk device; writing would erase it." : "This is a socket.",
        "Name a file.");
  if (was_read(found.info))
    return problem(where_, "This command reads the file, so it does not overwrite it.",
                   "Name another file.");
  if (!forced_ && !is_of_kind(where_, kind_))
    return problem(where_,
                   std::string("The file exists and is not a ") + name_of(kind_) +
                       ", so it is not overwritten.",
                   "Name another file, or add --force to overwrite this one.");
  return {};
}

Result<void> Output::write(std::span<const std::byte> bytes) const {
  if (!wanted()) return {};
  if (auto good = check(); !good) return good;
  if (to_stdout()) return write_to_stdout(bytes);
  const FileInfo found = standing(where_);
  if (found.there && !S_ISREG(found.info.st_mode)) return write_to_stream(where_, bytes);
  return write_durably(where_, bytes);
}

Result<void> Output::write(const std::string& text) const {
  return write(std::as_bytes(std::span(text)));
}

}  // namespace onggi::files
