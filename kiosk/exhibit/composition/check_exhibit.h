#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::exhibit {

/// What a check went through, and everything it found.
struct CheckReport {
  std::vector<std::filesystem::path> files;  ///< Each that was looked at, in order, once.
  int keys = 0, vessels = 0, languages = 0;
  std::vector<Problem> problems;

  /// "All good: checked ..." or "2 problems: checked ...", with the counts.
  std::string summary() const;
};

/// Checks what `path` names: an exhibit and all that it leads to (scene, languages, shelf with
/// every pack), or a single scene, language, drawing, vessel or shelf. Empty: the exhibit `config`
/// (exhibit_file(), so that of the folder one stands in). Labels of vessels have to be in the
/// languages of `config`, where that is given, else of the exhibit of the site that `path` lies in.
/// A Problem only when there is nothing at `path`. Of an exhibit, asked to `stop`, the vessels that
/// it has not come to are left out. Allocates; reads files.
Result<CheckReport> check_path(const std::string& path, const std::string& config = "",
                               const std::stop_token& stop = {});

}  // namespace onggi::exhibit
