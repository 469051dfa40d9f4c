#include "kiosk/ground/files/file_watch.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>

namespace onggi::files {

namespace {
// IN_MODIFY, because a file that is cut by its name, or written by a program that keeps it open, is
// never closed.
constexpr std::uint32_t kChanges = IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM |
                                   IN_DELETE | IN_CREATE | IN_DELETE_SELF | IN_MOVE_SELF;
}  // namespace

FileWatch::FileWatch(const std::vector<std::filesystem::path>& folders)
    : inotify_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  for (const auto& folder : folders)
    if (::inotify_add_watch(inotify_.get(), folder.c_str(), kChanges | IN_ONLYDIR) >= 0) ++watched_;
}

bool FileWatch::changed(double now) {
  std::array<char, 4096> events;
  while (::read(inotify_.get(), events.data(), events.size()) > 0) last_ = now;
  if (last_ < 0.0 || now - last_ < kSettle) return false;
  last_ = -1.0;
  return true;
}

}  // namespace onggi::files
