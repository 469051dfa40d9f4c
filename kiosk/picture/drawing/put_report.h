#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::drawing {

/// Handles --json: writes `report`, indented and with a newline, to `output`. True if standard
/// output is still free for a summary.
Result<bool> put_report(const files::Json& report, const files::Output& output);

/// Writes a laboratory report: the JSON and the plot to their outputs, and `words` to standard
/// output if that is still free.
Result<void> put_report(const files::Json& report, const std::string& words,
                        const drawing::Plot& plot, const files::Output& json,
                        const files::Output& picture);

}  // namespace onggi::drawing
