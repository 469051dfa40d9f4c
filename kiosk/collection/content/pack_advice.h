#pragma once

#include <string>
#include <vector>

#include "kiosk/collection/content/pack.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

/// A visitor reads a label of this length in under a minute, standing.
inline constexpr int kMostLabelWords = 100;

/// Words between spaces, as a reader counts them.
int count_words(const std::string& text);

/// Nothing but spaces, or nothing.
bool is_blank(const std::string& text);

/// Notes with the reader of `root`, a vessel.toml, what is still to be written until its label is
/// whole: true size, museum, source, licence, and a label with every part in each of `languages`
/// (none given: in one of any). Also what stands there and should not: "not known", a long text.
void ask_for_the_rest(toml::TomlReader::Table root, const Pack& pack,
                      const std::vector<std::string>& languages);

}  // namespace onggi::content
