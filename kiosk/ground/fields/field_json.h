#pragma once

#include "kiosk/ground/fields/field.h"
#include "kiosk/ground/files/json.h"

namespace onggi::fields {

/// The list for programs: file, and of each field table, key, kind, words, what is allowed in words
/// and, where it has them, least, most, unit, default, choices, page; any_key, restarts_console.
files::Json json_of(const FieldList& list);

/// The list for people: a key with what it may be, its default and its words.
std::string text_of(const FieldList& list);

}  // namespace onggi::fields
