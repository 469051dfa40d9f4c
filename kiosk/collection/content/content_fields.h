#pragma once

#include "kiosk/ground/fields/field.h"

namespace onggi::content {

/// Every key of vessel.toml, glazes.toml and a lesson. read_pack(), read_glazes() and read_lesson()
/// take their bounds from here.
const fields::FieldList& vessel_fields();
const fields::FieldList& glaze_fields();
const fields::FieldList& lesson_fields();

}  // namespace onggi::content
