#pragma once

#include "kiosk/collection/settings/hours.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

/// Reads [hours] of exhibit.toml: "10:00-18:00" or "closed" by day of the week, every_day, and
/// exceptions by date. Notes Problems for missing or invalid hours, which never close the museum.
/// Allocates.
void read_hours(toml::TomlReader::Table table, Hours& hours);

}  // namespace onggi::settings
