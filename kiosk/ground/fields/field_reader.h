#pragma once

#include <string_view>

#include "kiosk/ground/fields/field.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::fields {

/// The field `key` of the list's `table`. It must be there: a reader asks only for what its list
/// has, and each reader's tests read every key.
const Field& field_at(const FieldList& list, std::string_view table, std::string_view key);

/// Reads a number or whole number within the field's range, as TomlReader::Table does.
bool read_number(toml::TomlReader::Table& table, const Field& field, double& out);
bool read_whole(toml::TomlReader::Table& table, const Field& field, int& out);

}  // namespace onggi::fields
