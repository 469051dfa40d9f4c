#pragma once

#include "kiosk/ground/fields/field.h"

namespace onggi::content {

/// The texts of a language's file, in the order of the program's English, which is the `words` of
/// each: "text.attract.title". Made once; any thread.
const fields::FieldList& word_fields();

}  // namespace onggi::content
