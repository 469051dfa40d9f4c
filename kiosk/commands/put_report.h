#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/files/json.h"

namespace onggi::commands {

/// What --json asks for: writes `report` durably to the file `where`, to standard output where that
/// is "-", and nowhere where it is empty. True where standard output is still free for a person's
/// summary.
Result<bool> put_report(const files::Json& report, const std::string& where);

}  // namespace onggi::commands
