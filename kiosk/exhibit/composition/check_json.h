#pragma once

#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/ground/files/json.h"

namespace onggi::exhibit {

/// A report for programs: whether all is good, files, counts, and each problem and note with file,
/// line and column (where it has them), what, remedy.
files::Json json_of(const CheckReport& report);

}  // namespace onggi::exhibit
