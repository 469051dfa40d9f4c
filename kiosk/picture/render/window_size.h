#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::render {

/// Reads "1280x720" into `options`; 320x240 to 7680x4320. An empty text means full screen.
Result<void> read_window_size(const std::string& text, render::WindowOptions& options);

}  // namespace onggi::render
