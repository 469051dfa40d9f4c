#pragma once

namespace onggi::view {

/// Pixels of the framebuffer, from the top left.
struct Rect {
  float x = 0, y = 0, w = 0, h = 0;
  bool contains(float px, float py) const { return px >= x && py >= y && px < x + w && py < y + h; }
  friend bool operator==(const Rect&, const Rect&) = default;
};

}  // namespace onggi::view
