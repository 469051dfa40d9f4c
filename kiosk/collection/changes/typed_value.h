#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/fields/field.h"
#include "kiosk/ground/toml/toml_places.h"

namespace onggi::changes {

/// A key as a person typed it: "idle.warn_after", "step.open.after" or "step.2.after".
struct TypedKey {
  toml::Path path;    ///< With the number of an element: {"step", "2", "after"}.
  toml::Path names;   ///< Without: {"step", "after"}.
  std::string shown;  ///< With an element's id, where it has one: "step.open.after".
};

/// Finds `key` in `text`, which `places` are of. Problem, called `name`, where it cannot be read or
/// names an element that is not there, with the nearest right id.
Result<TypedKey> typed_key(const std::string& text, const toml::TomlPlaces& places,
                           const std::string& key, const std::string& name);

/// What a person typed in a shell, where it loses its quotes, as TOML writes it: `Onggi` for a text
/// becomes `"Onggi"`, `en, ko` for a list `["en", "ko"]`. TOML's own form stays as it is. `field`:
/// the key's, or null; then `was`, the value that stands there ("": none), tells the kind. Problem,
/// called `name`, where it is of another kind; ranges are left to the reader.
Result<std::string> typed_value(const std::string& typed, const fields::Field* field,
                                const std::string& was, const std::string& name);

}  // namespace onggi::changes
