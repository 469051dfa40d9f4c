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
  previous,  ///< Tab, and with Shift: all controls in turn.
  other,     ///< Any other key: for one switch every key is good.
  tell,      ///< "v": speaks the screen, or speaks it again.
  none,
};

/// Input for the screens from window, touch or keypad. Pixels of the framebuffer, from the top
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
  bool glass = false;       ///< A finger on the touch screen, not a mouse.
  std::uint8_t finger = 0;  ///< Number: 0 a mouse or the first finger, 1..9 the others.
};

}  // namespace onggi::view
