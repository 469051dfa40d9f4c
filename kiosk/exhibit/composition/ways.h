#pragma once

#include <filesystem>
#include <map>
#include <optional>
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

/// What to tell of an exhibit's folder of ways that has none; `exhibit`: its TOML.
Problem no_ways(const std::filesystem::path& exhibit, const std::filesystem::path& folder);

/// What a vessel is decorated with that names the way `id`: that one of `ways`, else the usual one,
/// else nothing. `problem` says where it is not what it should be; `vessel` is its id.
struct WayFound {
  const decoration::Way* way = nullptr;
  std::optional<Problem> problem;
};
WayFound find_way(const std::map<std::string, decoration::Way>& ways, const std::string& id,
                  const std::string& vessel);

/// Ways and glazes that the vessels `ids` of a shelf name, and that do not exist; and a usual way
/// that is missing where a vessel names none.
settings::Problems unknown_ways(const std::filesystem::path& shelf,
                                const std::vector<std::string>& ids,
                                const std::vector<std::string>& ways,
                                const std::vector<std::string>& glazes);

}  // namespace onggi::exhibit
