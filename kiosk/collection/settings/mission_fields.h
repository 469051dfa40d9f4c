#pragma once

#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/ground/fields/field.h"

namespace onggi::settings {

/// Every key of content/missions.toml. read_missions() takes its bounds from here.
const fields::FieldList& mission_fields();

/// A table whose keys are languages: a text in each, within `bound`. `words` end a sentence about
/// it.
fields::Field spoken_field(const std::string& table, const std::string& words, TextBound bound);

/// "1 to 40 letters", "1 to 160 letters, also of several lines".
std::string letters_range(TextBound bound);

}  // namespace onggi::settings
