#include "kiosk/ground/files/durable_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/durable_steps.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

constexpr int kMostLeftBehind = 1000;

bool sync(int fd) {
  while (::fsync(fd) != 0) {
    // This file system has no fsync for folders.
    if (errno == EINVAL || errno == ENOTSUP) return true;
    if (errno != EINTR) return false;
  }
  return true;
}

/// A new or renamed name survives a power cut only after its folder is synced.
Result<void> sync_folder(const fs::path& folder) {
  const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd.open() || !sync(fd.get())) {
    return tl::unexpected(disk_problem(folder, "write", errno));
  }
  step_done("folder synced");
  return {};
}

/// Keeps owner and permissions of the old file, so that root can write for the museum's user. A
/// user who cannot change the owner keeps the file as their own.
void keep_rights(int fd, const struct stat& before) {
  const bool given = ::fchown(fd, before.st_uid, before.st_gid) == 0;
  ::fchmod(fd, before.st_mode & (given ? 07777 : 0777));
}

}  // namespace

Problem disk_problem(const fs::path& path, const char* doing, int error) {
  const std::string where = path.string(), folder = folder_of(path).string();
  std::error_code ignored;
  const auto told = [&](const std::string& what, const std::string& remedy) {
    return Problem{where, what, remedy, 1};
  };
  if (error == ENOENT && !fs::exists(folder, ignored))
    return told("The folder " + folder + " does not exist.", "Create it, or name another folder.");
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return told("The disk is full.",
                  "Free some space, lower keepsake.quota_mb, or name a folder on another disk.");
    case EFBIG:
      return told("The file is larger than this disk or this user's limit allows.",
                  "Raise the limit on file sizes, or name a folder on another disk.");
    case EROFS:
      return told("The disk is mounted read-only.",
                  "Mount it for writing, or name a folder on another disk.");
    case EACCES:
    case EPERM:
      return told(std::string("The kiosk's user may not ") + doing + " here.",
                  "Let user number " + std::to_string(::geteuid()) + " write in the folder " +
                      folder + ", or name another folder.");
    case ENOTDIR:
    case EEXIST:
    case EISDIR:
      return told("A file is in the place of a folder, or a folder in the place of a file.",
                  "Move it away, or name another folder.");
    case ENAMETOOLONG:
      return told("The name is too long for this disk.", "Name a folder with a shorter path.");
    case EIO:
      return told("The disk reports that it cannot store data.",
                  "Check the disk: it may be failing. Name a folder on another until then.");
    default:
      return told(
          std::string("The kiosk could not ") + doing + " this: " + std::strerror(error) + ".",
          "Check the disk, and check that the folder " + folder + " is writable.");
  }
}

Result<void> make_folder(const fs::path& folder) {
  struct stat info {};
  if (::stat(folder.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode)) return {};
    return tl::unexpected(disk_problem(folder, "make", ENOTDIR));
  }
  const fs::path above = folder_of(folder);
  if (above == folder) return tl::unexpected(disk_problem(folder, "make", ENOENT));
  if (Result<void> made = make_folder(above); !made) return made;
  if (::mkdir(folder.c_str(), 0755) != 0 && errno != EEXIST) {
    return tl::unexpected(disk_problem(folder, "make", errno));
  }
  return sync_folder(above);
}

Result<void> rename_durably(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) {
    return tl::unexpected(disk_problem(to, "write", errno));
  }
  step_done("renamed");
  return sync_folder(folder_of(to));
}

Result<void> write_durably(const fs::path& file, std::span<const std::byte> bytes) {
  struct stat before {};
  const bool there = ::lstat(file.c_str(), &before) == 0;
  if (there && S_ISLNK(before.st_mode)) {
    // Write to the link's target and keep the link: somebody set up the link on purpose.
    std::error_code lost;
    const fs::path target = fs::canonical(file, lost);
    if (lost)
      return problem(file.string(), "This link points to a file that does not exist.",
                     "Create that file, or remove the link.", 1);
    return write_durably(target, bytes);
  }
  if (there && S_ISDIR(before.st_mode)) return tl::unexpected(disk_problem(file, "write", EISDIR));
  if (there && !S_ISREG(before.st_mode))
    return problem(file.string(),
                   "This is a device, a pipe or a socket. Onggi does not replace it.",
                   "Name a file.", 1);

  const fs::path folder = folder_of(file);
  // The temporary file is in the same folder, because rename() is atomic only within one disk. Its
  // name is unique, so that two writers never share it. In a container a process often has the
  // number of one that was killed and left its file: then the next name is taken.
  static std::atomic<unsigned> count{0};
  fs::path temporary;
  Descriptor fd;
  for (int tries = 0; !fd.open(); ++tries) {
    temporary = folder / ("." + file.filename().string() + "." + std::to_string(::getpid()) + "-" +
                          std::to_string(count.fetch_add(1)) + ".part");
    fd = Descriptor(
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644));
    if (!fd.open() && (errno != EEXIST || tries == kMostLeftBehind))
      return tl::unexpected(disk_problem(file, "write", errno));
  }
  if (there) keep_rights(fd.get(), before);
  step_done("opened");
  const std::size_t half = bytes.size() / 2;
  const auto write_in_halves = [&] {
    if (!write_all(fd.get(), bytes.first(half))) return false;
    step_done("half written");
    return write_all(fd.get(), bytes.subspan(half));
  };
  const auto synced = [&] {
    step_done("written");
    return sync(fd.get()) && fd.close();
  };
  if (!write_in_halves() || !synced()) {
    const int error = errno;
    ::unlink(temporary.c_str());
    return tl::unexpected(disk_problem(file, "write", error));
  }
  step_done("synced");
  if (Result<void> renamed = rename_durably(temporary, file); !renamed) {
    ::unlink(temporary.c_str());
    return renamed;
  }
  return {};
}

}  // namespace onggi::files
