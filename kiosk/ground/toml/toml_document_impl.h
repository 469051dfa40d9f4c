#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kiosk/ground/toml/toml_places.h"
#include "kiosk/ground/toml/toml_reader_impl.h"

// For the files that change a TOML text: the document of a text, to prove what a change did.

namespace onggi::toml {

/// True if `path` is `first`, or lies below it.
bool begins_with(const Path& path, const Path& first);

/// How lines of `text` end.
std::string_view end_of_line(std::string_view text);

/// The document; none where `text` is no TOML.
std::optional<::toml::table> parsed(const std::string& text);

/// The node at `path` of a document, or null.
::toml::node* node_at(::toml::node& root, const Path& path);

}  // namespace onggi::toml
