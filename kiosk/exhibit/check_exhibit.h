#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::exhibit {

/// What a check went through, and everything it found.
struct CheckReport {
  int files = 0, keys = 0, vessels = 0, languages = 0;
  std::vector<Problem> problems;

  /// "All good: checked ..." or "2 problems: checked ...", with the counts.
  std::string summary() const;
};

/// Checks what `path` names: an exhibit and all that it leads to (scene, languages, shelf with
/// every pack), or a single scene, language, drawing, vessel or shelf. Empty: config/exhibit.toml
/// of the program. A Problem only when there is nothing at `path`. Allocates; reads files.
Result<CheckReport> check_path(const std::string& path);

}  // namespace onggi::exhibit
