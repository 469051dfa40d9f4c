#pragma once

#include <map>
#include <string>
#include <vector>

#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::settings {

/// Reads the table [key] of `entry`, a text for visitors by language. Notes faults, and a text that
/// is missing in one of `languages`; without languages, one that has no English, which is shown
/// where a language lacks it.
std::map<std::string, std::string> read_by_language(toml::TomlReader::Table& entry,
                                                    const std::string& key, TextBound bound,
                                                    const std::vector<std::string>& languages);

}  // namespace onggi::settings
