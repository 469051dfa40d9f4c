#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/passing_folder.h"

namespace onggi::commands {

/// A scan out of a zip archive, for one command. Its files are gone with this, and also where the
/// command is interrupted.
class ScanArchive {
 public:
  /// Unpacks `file` and takes the scan `name` in it; "": the only one. Problem: the archive is
  /// refused (archives::unpack), it has no scan, or several and none is named.
  static Result<ScanArchive> open(const std::filesystem::path& file, const std::string& name);

  const std::filesystem::path& scan() const { return scan_; }
  /// Documents in the archive that could not be used.
  const std::vector<Problem>& notes() const { return notes_; }
  /// `told` in the words of whoever has the archive and never saw its files.
  Problem as_named(Problem told) const;

 private:
  ScanArchive(std::filesystem::path file, files::PassingFolder folder)
      : file_(std::move(file)), folder_(std::move(folder)) {}
  Result<void> choose(const std::string& name);

  std::filesystem::path file_;
  files::PassingFolder folder_;
  std::filesystem::path scan_;
  std::vector<Problem> notes_;
};

}  // namespace onggi::commands
