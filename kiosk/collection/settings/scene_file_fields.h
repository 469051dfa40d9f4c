#pragma once

#include "kiosk/ground/fields/field.h"

namespace onggi::settings {

/// Every key of a scene's file. Ranges, units and defaults are the engine's DefFields, the words
/// are here; each number of the engine has some (scene_file_fields_test.cpp).
const fields::FieldList& scene_fields();

}  // namespace onggi::settings
