#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::exhibit {

/// Everything that a check read, and everything that it found.
struct CheckReport {
  std::vector<std::filesystem::path> files;  ///< Each file that was read, in order, once.
  int keys = 0, vessels = 0, languages = 0;
  std::vector<Problem> problems;
  bool whole = false;  ///< An exhibit and everything that it leads to, not one of its files.
  std::vector<Problem> notes;  ///< Left out on purpose: unfinished vessels, names.

  /// "All good: checked ..." or "2 problems: checked ...", with the counts.
  std::string summary() const;
};

/// Checks `path`: an exhibit and everything that it leads to (scene, languages, shelf with every
/// pack), or a single scene, language, drawing, vessel or shelf. Empty: the exhibit `config`
/// (exhibit_file(), so the one in the current folder). Labels must exist in the languages of
/// `config` if given, else of the exhibit of the site that contains `path`. Problem only if `path`
/// does not exist. After a `stop`, the remaining vessels of an exhibit are skipped. Allocates;
/// reads files.
Result<CheckReport> check_path(const std::string& path, const std::string& config = "",
                               const std::stop_token& stop = {});

}  // namespace onggi::exhibit
