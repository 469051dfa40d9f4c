#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/mishap.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/show_me.h"
#include "kiosk/visit/screens/stroke_board.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::screens {

/// The two drawers at the wheel, in place of the hint. tools: a hand's tools, over the pot, or
/// below it where it is out of reach. wheel: wheel, clay and force.
enum class Drawer { closed, tools, wheel };

/// The control that opens the drawer with `control`; "" if it is in no drawer.
std::string way_into_drawer(const std::string& control);

/// Layout of the throwing screen's words and controls. The most used ones are always visible:
/// water, undo, "Show me", done. The others are in two drawers.
struct ThrowingControls {
  double speed = 0;  ///< Requested wheel speed, rad/s.
  device::Grip grip = device::Grip::both;
  bool water = false, cut = false;
  std::optional<bool> fire = {};  ///< Charcoal's button is in the place of water's: whether it
                                  ///< hangs in the pot.
  bool calls = false;             ///< Water, or charcoal, would help now: its button blinks.
  bool onward = false;   ///< Done is what a visitor wants most: the clay was touched, and neither
                         ///< the lesson nor a drawer wants something else.
  bool restore = false;  ///< A stroke can be undone.
  Button show = {};
  bool skip = false;  ///< A lesson can be skipped.
  Drawer drawer = Drawer::closed;
  std::size_t held = 0;  ///< Index in the tray: 0 is the hands.
  bool coil = false;     ///< A coil is held: "Show me" lays a ring of it.
  bool paddle = false;   ///< A paddle is held: "Show me" beats the wall once up.
  Mishap mishap = Mishap::none;
  const StrokeBoard* board = nullptr;  ///< Strokes by buttons, and the questions about them.
  std::vector<PartOff> parts = {};
  bool working = false;
  bool by_keys = false;   ///< The visitor last used the keyboard.
  std::string news = {};  ///< Language key of a notice that replaces the hint; "": none.
};

/// The control that a key presses at the wheel, visible or not; null: none. `repeats`: again and
/// again while the key is held.
struct KeyedControl {
  const char* control = nullptr;
  bool repeats = false;
};
KeyedControl control_of(view::Key key);

/// Divides the page so that the pot gets all the space that words and controls do not need,
/// whichever drawer is open. In portrait they are below the pot, in landscape in a narrow column
/// beside it.
void give_the_pot_its_room(Page& page, const Desk& desk, const ThrowingControls& now);

/// Lays out the words' part of the page, from its head and from its foot.
void lay_out_throwing(Page& page, const Desk& desk, const ThrowingControls& now, const ShowMe& show,
                      const Hint& hint);

}  // namespace onggi::screens
