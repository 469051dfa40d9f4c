#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace onggi::archives {

/// The names in one archive: which of them may become files, and that no two become the same one.
/// Uses no file. One thread.
class EntryNames {
 public:
  /// `archive` stands in each Problem. `depth`: most folders within folders.
  EntryNames(std::string archive, std::size_t depth)
      : archive_(std::move(archive)), depth_(depth) {}

  /// A Problem for a `name` that leads out of its folder, or is written as another system would
  /// (absolute, "..", a drive's letter, a backslash), is no UTF-8, has control characters, is too
  /// long or lies too deep. A '/' at its end: a folder.
  Result<void> check(std::string_view name) const;

  /// A Problem where the checked `name` is there already, or is the same but for A to Z in another
  /// case, or where one of two is a file and the other a folder. The same folder may come again.
  Result<void> add(std::string_view name);

  /// Where a Problem of the entry `name` is: "scan.zip, jar/scan.glb".
  std::string where(std::string_view name) const;

 private:
  struct Taken {
    std::string name;
    bool folder = false;
  };
  bool take(const std::string& name, bool folder);

  std::string archive_;
  std::size_t depth_;
  std::map<std::string, Taken> taken_;  // by the name in lower case
};

/// True for what an operating system adds and no scan needs: __MACOSX, .DS_Store, ._scan.glb,
/// Thumbs.db, desktop.ini.
bool is_litter(std::string_view name);

}  // namespace onggi::archives
