#pragma once

#include <filesystem>
#include <vector>

#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

/// Reports changed files in some folders after the changes have settled, because editors and copies
/// need several steps for one change. Uses Linux's inotify and reads no file. One thread.
class FileWatch {
 public:
  /// A change is over after this many seconds without another event.
  static constexpr double kSettle = 1.0;

  /// Watches the files directly in these folders; a missing folder is skipped. Fewer are watched if
  /// the system has no watches left.
  explicit FileWatch(const std::vector<std::filesystem::path>& folders);

  /// True once for each finished change. `now` is in seconds and never goes back. Never waits.
  bool changed(double now);
  /// True while a change has begun and changed() has not reported it.
  bool pending() const { return last_ >= 0.0; }
  /// How many folders are watched.
  int watched() const { return watched_; }

 private:
  files::Descriptor inotify_;
  int watched_ = 0;
  double last_ = -1.0;  ///< Time of the last event; below 0: no change is going on.
};

}  // namespace onggi::files
