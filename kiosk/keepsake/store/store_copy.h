#pragma once

#include <filesystem>
#include <functional>

namespace onggi::store {

/// A folder of its own in the system's temporary folder, removed with the object.
class CopyFolder {
 public:
  CopyFolder();
  ~CopyFolder();
  CopyFolder(const CopyFolder&) = delete;
  CopyFolder& operator=(const CopyFolder&) = delete;
  /// Empty if it could not be created.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Copies a store that another program may be writing, with its log, to `to`, as both were at one
/// moment. False if they changed meanwhile or could not be read: copy again. Blocks. Tests use
/// `meanwhile`, which is called between the two files.
bool copy_still(const std::filesystem::path& file, const std::filesystem::path& to,
                const std::function<void()>& meanwhile = {});

}  // namespace onggi::store
