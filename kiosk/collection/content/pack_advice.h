#pragma once

#include <string>
#include <vector>

#include "kiosk/collection/content/pack.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

/// A standing visitor reads a label of this length in under a minute.
inline constexpr int kMostLabelWords = 100;

/// Words between spaces, as a reader counts them.
int count_words(const std::string& text);

/// Notes in the reader of `root`, a vessel.toml, what its label still needs: true size, museum,
/// source, licence, and a complete label in each of `languages` (if empty, in any one). Also
/// reports what should not be there: "not known", a text that is too long.
void ask_for_the_rest(toml::TomlReader::Table root, const Pack& pack,
                      const std::vector<std::string>& languages);

/// Notes each text of `pack` that a screen cannot show (settings/visitor_text.h), and cuts it to
/// what a screen can, so that the vessel stays on the shelf.
void fit_to_screens(toml::TomlReader::Table root, Pack& pack);

}  // namespace onggi::content
