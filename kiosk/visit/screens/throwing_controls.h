#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/mishap.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/show_me.h"
#include "kiosk/visit/screens/stroke_board.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::screens {

/// What is one touch away at the wheel: what a hand works with, or wheel, clay and force.
enum class Drawer { closed, tools, wheel };

/// Which control opens the drawer that `control` is in; "": it is in none.
std::string way_into_drawer(const std::string& control);

/// How the throwing screen's words and controls stand. What is used most is always there: water,
/// stepping back, being shown, done. All else is in two drawers.
struct ThrowingControls {
  double speed = 0;  ///< Asked of the wheel, rad/s.
  device::Grip grip = device::Grip::both;
  bool water = false, cut = false;
  bool restore = false;  ///< There is a stroke to take back.
  Button show = {};      ///< "Show me".
  bool skip = false;     ///< There is a lesson to be skipped.
  Drawer drawer = Drawer::closed;
  std::size_t held = 0;  ///< Of the tray: 0 the hands.
  Mishap mishap = Mishap::none;
  const StrokeBoard* board = nullptr;  ///< Strokes by buttons, and what they are told of.
  std::vector<PartOff> parts = {};
  bool working = false;
};

/// What a key presses at the wheel, on the screen or not; null: nothing of itself. `repeats`: as
/// long as it is held.
struct KeyedControl {
  const char* control = nullptr;
  bool repeats = false;
};
KeyedControl control_of(view::Key key);

/// Divides the page so that the pot has all that words and controls do not need, whichever drawer
/// is open: upright they lie below it, across they are a narrow column beside it.
void give_the_pot_its_room(Page& page, const Desk& desk, const ThrowingControls& now);

/// What stands in the part of the page that is the words', from its head and from its foot.
void lay_out_throwing(Page& page, const Desk& desk, const ThrowingControls& now, const ShowMe& show,
                      const Hint& hint);

}  // namespace onggi::screens
