#pragma once

#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::files::test {

namespace fs = std::filesystem;

inline std::span<const std::byte> bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

inline std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// Runs `act` in a child process and gives its wait status: 0 where `act` returned true.
inline int in_child(const std::function<bool()>& act) {
  const pid_t pid = ::fork();
  if (pid == 0) ::_exit(act() ? 0 : 1);
  int status = 0;
  ::waitpid(pid, &status, 0);
  return status;
}

constexpr int kNoMounts = 77;

/// Runs `act` in a child process that sees `folder` as a small disk of its own (`options` of
/// tmpfs). Exit status kNoMounts where this machine does not allow that.
inline int on_a_disk(const fs::path& folder, unsigned long flags, const char* options,
                     const std::function<bool()>& act) {
  return in_child([&] {
    const bool own = ::unshare(CLONE_NEWNS) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
    if (!own || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount("none", folder.c_str(), "tmpfs", flags, options) != 0) {
      ::_exit(kNoMounts);
    }
    return act();
  });
}

}  // namespace onggi::files::test
