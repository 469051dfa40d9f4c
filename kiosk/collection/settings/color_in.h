#pragma once

#include <array>
#include <string>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

/// Reads `key`, "#9DB5A0", into `out` as linear light. As TomlReader::Table::text() otherwise.
bool read_color(toml::TomlReader::Table& table, const std::string& key, std::array<float, 3>& out);

}  // namespace onggi::settings
