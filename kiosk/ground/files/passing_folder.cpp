#include "kiosk/ground/files/passing_folder.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "kiosk/ground/files/durable_file.h"

namespace onggi::files {

namespace {

namespace fs = std::filesystem;

/// The other process: waits until nobody holds the other end of `pipe`.
[[noreturn]] void remove_when_alone(int pipe, const fs::path& folder) {
  // What is typed at the terminal to end the program is not meant for this.
  ::setsid();
  char byte = 0;
  while (::read(pipe, &byte, 1) < 0 && errno == EINTR) {
  }
  std::error_code error;
  fs::remove_all(folder, error);
  ::_exit(error ? 1 : 0);
}

}  // namespace

Result<PassingFolder> PassingFolder::make(const std::string& name) {
  std::error_code none;
  const fs::path above = fs::temp_directory_path(none);
  std::string path = (above / ("onggi-" + name + "-XXXXXX")).string();
  if (none || ::mkdtemp(path.data()) == nullptr)
    return tl::unexpected(disk_problem(path, "make", none ? ENOENT : errno));
  int ends[2] = {-1, -1};
  const bool piped = ::pipe2(ends, O_CLOEXEC) == 0;
  Descriptor waits(ends[0]), held(ends[1]);
  const pid_t remover = piped ? ::fork() : -1;
  if (remover == 0) {
    held.close();
    remove_when_alone(waits.get(), path);
  }
  if (remover < 0) {
    const Problem told = disk_problem(path, "make", errno);
    fs::remove(path, none);
    return tl::unexpected(told);
  }
  return PassingFolder(path, std::move(held), remover);
}

PassingFolder::~PassingFolder() {
  if (remover_ < 0) return;
  held_.close();
  while (::waitpid(remover_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace onggi::files
