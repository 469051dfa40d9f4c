#pragma once

#include <filesystem>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

/// Notes in `keepsake`, the table [keepsake] of `exhibit.file`, if visitors' keepsakes would lie
/// among the museum's content: there they would be vessels on the shelf, and be copied with it.
/// Links are followed. Also if no such folder can be made: it lies below a file, or its name is too
/// long.
void check_keepsake_place(toml::TomlReader::Table keepsake, const Exhibit& exhibit,
                          const std::filesystem::path& language_folder);

}  // namespace onggi::settings
