#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/web/message.h"

namespace onggi::web {

/// A file that a request brought. It is removed when this goes, unless it was moved away. One
/// thread.
class ReceivedFile {
 public:
  /// A new, empty file in `into.folder`, which only this user can read. Its name begins with
  /// "onggi-received-" and ends in ".part". Problem, exit 1.
  static Result<std::shared_ptr<ReceivedFile>> make(const IntoFile& into);
  ~ReceivedFile();
  ReceivedFile(const ReceivedFile&) = delete;
  ReceivedFile& operator=(const ReceivedFile&) = delete;

  /// Writes `bytes` at the end. False, with errno set, where the disk refuses.
  bool append(std::span<const std::byte> bytes);
  /// Moves the file to `to`, on the same disk; an older file there is replaced. Call it once.
  /// Not synced: after a power cut `to` may be incomplete. Problem, exit 1; then it stays here.
  Result<void> move_to(const std::filesystem::path& to);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }  ///< Bytes so far.

 private:
  ReceivedFile(std::filesystem::path path, files::Descriptor file, std::shared_ptr<void> ticket)
      : path_(std::move(path)), file_(std::move(file)), ticket_(std::move(ticket)) {}

  std::filesystem::path path_;  // empty: moved away
  files::Descriptor file_;      // locked, which tells remove_abandoned() that somebody has it
  std::shared_ptr<void> ticket_;
  std::uint64_t size_ = 0;
};

/// Removes from `folder` the files of ReceivedFile that a program left when it was killed, and
/// says how many. A file that a running program has stays. Call it at the start. Any thread.
std::size_t remove_abandoned(const std::filesystem::path& folder);

}  // namespace onggi::web
