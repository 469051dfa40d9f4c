#pragma once

#include <cstdint>

namespace onggi::view {

enum class Key : std::uint8_t {
  up,
  down,
  left,
  right,
  enter,
  back,
  help,
  depth_in,
  depth_out,  ///< Towards and away from the axis ("." and ",", or Page Up / Page Down).
  faster,
  slower,  ///< Wheel speed ("+" and "-").
  side,
  water,
  renew,
  restore,
  cut,       ///< "s", "w", "r", "z", "c".
  language,  ///< "l"
  comfort,   ///< "a"
  next,
  previous,  ///< Tab, and with Shift: every control, one after the other.
  other,     ///< Any key that has no name here: to one switch it is as good as another.
  tell,      ///< "v": what is on the screen is said, or said again.
  none,
};

/// What reaches the screens from window, touch or keypad. Pixels of the framebuffer, from the top
/// left.
struct InputEvent {
  enum class Kind : std::uint8_t {
    pointer_down,
    pointer_move,
    pointer_up,
    scroll,
    key_down,
    key_up,
    resize,
    close
  };
  Kind kind = Kind::pointer_move;
  float x = 0, y = 0;  ///< Pointer; or the new size.
  float scroll = 0;    ///< Notches; positive away from the visitor.
  Key key = Key::none;
  bool repeat = false;
  bool glass = false;       ///< A finger on the glass, no mouse.
  std::uint8_t finger = 0;  ///< Which: 0 a mouse or the first on the glass, 1..9 those beside it.
};

}  // namespace onggi::view
