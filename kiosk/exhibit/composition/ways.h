#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kiosk/collection/decoration/way.h"
#include "kiosk/collection/settings/exhibit.h"

namespace onggi::exhibit {

/// The way of a pot whose vessel names none.
inline constexpr const char* kUsualWay = "slip_painted";

/// The good ways of a folder by id, and everything wrong with the others. A text that a language
/// lacks is shown in English.
struct WaysRead {
  std::map<std::string, decoration::Way> ways;
  std::vector<std::filesystem::path> files;
  settings::Problems problems;
  int keys_checked = 0;
};
WaysRead read_ways(const std::filesystem::path& folder);

/// Ways and glazes that the vessels `ids` of a shelf name, and that do not exist.
settings::Problems unknown_ways(const std::filesystem::path& shelf,
                                const std::vector<std::string>& ids,
                                const std::vector<std::string>& ways,
                                const std::vector<std::string>& glazes);

}  // namespace onggi::exhibit
