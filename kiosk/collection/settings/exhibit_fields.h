#pragma once

#include "kiosk/ground/fields/field.h"

namespace onggi::settings {

/// Every key of exhibit.toml: exhibit_settings(), and the tables whose keys are languages, vessels
/// and days.
const fields::FieldList& exhibit_fields();

}  // namespace onggi::settings
