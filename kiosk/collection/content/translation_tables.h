#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kiosk/collection/settings/translations.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

struct Vessel;

/// The ids that an exhibit has, by kind ("vessel"). For a kind that is not here, any id is good.
using KnownIds = std::map<std::string, std::vector<std::string>>;

/// Reads the tables [vessel.ID], [glaze.ID], [lesson.ID] and [mission.ID] of a language's file
/// (kiosk/docs/languages.md). Notes unknown ids and keys, empty texts and texts that do not fit,
/// and leaves them out. Allocates.
settings::Translations::Language read_translation_tables(toml::TomlReader::Table& root,
                                                         const KnownIds& known);

/// What the files of `languages` (codes) in `folder` say of the exhibit's things. Faults are left
/// out and not told: check_language() tells them. Allocates.
settings::Translations read_translations(const std::filesystem::path& folder,
                                         const std::vector<std::string>& languages);

/// Puts what `translations` say of the vessel over its labels. A text that a language lacks stays
/// as Vessel::label() gives it. Allocates.
void translate(Vessel& vessel, const settings::Translations& translations);

}  // namespace onggi::content
