#include "kiosk/ground/files/free_space.h"

#include <sys/statvfs.h>

namespace onggi::files {

std::uint64_t free_bytes(const std::filesystem::path& path) {
  struct statvfs disk {};
  if (::statvfs(path.c_str(), &disk) != 0) return 0;
  return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

}  // namespace onggi::files
