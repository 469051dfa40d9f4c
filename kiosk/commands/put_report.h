#pragma once

#include "engine/base/result.h"
#include "kiosk/files/json.h"
#include "kiosk/files/output.h"

namespace onggi::commands {

/// What --json asks for: `report`, indented and with a newline, to where `output` says. True where
/// standard output is still free for a person's summary.
Result<bool> put_report(const files::Json& report, const files::Output& output);

}  // namespace onggi::commands
