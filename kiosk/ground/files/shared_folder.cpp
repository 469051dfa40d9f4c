#include "kiosk/ground/files/shared_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

void share_as_above(const std::filesystem::path& folder) {
  const std::filesystem::path above = folder.has_parent_path() ? folder.parent_path() : ".";
  struct stat of_above {
  }, own{};
  if (::stat(above.c_str(), &of_above) != 0 || (of_above.st_mode & S_IWGRP) == 0) return;
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!opened.open() || ::fstat(opened.get(), &own) != 0) return;
  if (own.st_gid == of_above.st_gid && (own.st_mode & S_IWGRP) != 0) return;
  // In this order: the group that it has now is given no right.
  if (::fchown(opened.get(), static_cast<uid_t>(-1), of_above.st_gid) == 0)
    static_cast<void>(::fchmod(opened.get(), (own.st_mode & 07777) | S_IRWXG));
}

}  // namespace onggi::files
