#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::console {

/// Who changed what by the page: a line of JSON each, in the file `changes` of the program's state
/// folder, kept kDays days. No passphrase, and of a visitor only the keepsake's folder name. One
/// thread.
class ChangeLog {
 public:
  static constexpr std::int64_t kDays = 400;

  explicit ChangeLog(const std::filesystem::path& state) : file_(state / "changes") {}

  struct Change {
    std::int64_t at = 0;  ///< s since 1970.
    std::string who;      ///< A name, or "code" for who came by a code.
    std::string from;     ///< The address.
    std::string did;      ///< "deleted keepsake", "added person"
    std::string what;     ///< "2026-05-04_141503_moon_jar", "maria.k"
  };
  /// Appends it. Problem, exit 1: the disk refuses; whoever changes something then says so.
  Result<void> add(const Change& change) const;
  /// The newest `most` lines, newest first, as they stand in the file.
  std::vector<std::string> newest(std::size_t most) const;
  /// Removes lines that are older than kDays at `now`. Problem, exit 1.
  Result<void> forget(std::int64_t now) const;

 private:
  std::filesystem::path file_;
};

}  // namespace onggi::console
