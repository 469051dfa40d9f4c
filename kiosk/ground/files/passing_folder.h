#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

/// A folder for what is needed for a moment. It is gone when this goes, and also when this process
/// is interrupted or killed: a small process of its own waits for that, and removes it. Call make()
/// before this process has threads. One thread.
class PassingFolder {
 public:
  /// "onggi-NAME-xxxxxx" in the system's folder for temporary files ($TMPDIR, else /tmp), for this
  /// user alone. Problem, exit 1.
  static Result<PassingFolder> make(const std::string& name);
  PassingFolder(PassingFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})),
        held_(std::move(other.held_)),
        remover_(std::exchange(other.remover_, -1)) {}
  PassingFolder& operator=(PassingFolder&&) = delete;
  /// Waits until the folder is removed.
  ~PassingFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  PassingFolder(std::filesystem::path path, Descriptor held, pid_t remover)
      : path_(std::move(path)), held_(std::move(held)), remover_(remover) {}

  std::filesystem::path path_;
  Descriptor held_;  // the end of a pipe: when the last one is closed, the remover goes to work
  pid_t remover_;
};

}  // namespace onggi::files
