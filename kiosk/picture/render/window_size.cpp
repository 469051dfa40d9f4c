#include "kiosk/picture/render/window_size.h"

#include <charconv>

namespace onggi::render {

Result<void> read_window_size(const std::string& text, render::WindowOptions& options) {
  if (text.empty()) return {};
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, width);
  const bool cross = w.ec == std::errc() && w.ptr != end && *w.ptr == 'x';
  const auto h = cross ? std::from_chars(w.ptr + 1, end, height) : w;
  if (!cross || h.ec != std::errc() || h.ptr != end || width < 320 || height < 240 ||
      width > 7680 || height > 4320)
    return problem("--window " + text,
                   "A window size is WIDTHxHEIGHT in pixels, 320x240 to 7680x4320.",
                   "For example: --window 1280x720.");
  options.width = width;
  options.height = height;
  return {};
}

}  // namespace onggi::render
