#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::drawing {

/// What --json asks for: `report`, indented and with a newline, to where `output` says. True where
/// standard output is still free for a person's summary.
Result<bool> put_report(const files::Json& report, const files::Output& output);

/// All that a laboratory tells: the JSON and the plot to where they are asked for, and `words` for
/// a person, where standard output is still free for them.
Result<void> put_report(const files::Json& report, const std::string& words,
                        const drawing::Plot& plot, const files::Output& json,
                        const files::Output& picture);

}  // namespace onggi::drawing
