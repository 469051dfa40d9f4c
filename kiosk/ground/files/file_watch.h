#pragma once

#include <filesystem>
#include <vector>

#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

/// Tells that files of some folders have changed, once they have come to rest: editors and copies
/// take several steps to one change. Linux's inotify; nothing is read. One thread.
class FileWatch {
 public:
  /// A change is over when nothing more has come for so many seconds.
  static constexpr double kSettle = 1.0;

  /// The files right in these folders; one that is not there is passed over. Where the system has
  /// no watch left to give, fewer are watched.
  explicit FileWatch(const std::vector<std::filesystem::path>& folders);

  /// True once for each change that is over. `now` in seconds, never going back. Never waits.
  bool changed(double now);
  /// A change is going on, and changed() will tell of it.
  bool pending() const { return last_ >= 0.0; }
  /// How many folders are watched.
  int watched() const { return watched_; }

 private:
  files::Descriptor inotify_;
  int watched_ = 0;
  double last_ = -1.0;  ///< When the last step of a change came; below 0: none is going on.
};

}  // namespace onggi::files
