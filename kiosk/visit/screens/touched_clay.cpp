#include "kiosk/visit/screens/touched_clay.h"

#include <utility>

namespace onggi::screens {

namespace {
constexpr double kAskedFor = 6;  // s
}  // namespace

void TouchedClay::look(Desk& desk, bool contact) {
  if (!desk.pot_ready()) return;  // the hand is at a pot that is gone
  if (contact) {
    desk.touch_pot();
    undoes_ = false;
    asked_until_ = -1;
  } else if (undoes_ && !desk.status.can_restore) {
    desk.touched = undoes_ = false;
  }
}

void TouchedClay::renewed(Desk& desk) {
  renewed_ = desk.touched || renewed_;
  desk.fresh_clay();
}

void TouchedClay::undone(Desk& desk) {
  desk.touched = std::exchange(renewed_, false) || desk.touched;
  undoes_ = true;
}

bool TouchedClay::comes_first(const Desk& desk) {
  if (!desk.touched) asked_until_ = desk.now + kAskedFor;
  return desk.touched;
}

}  // namespace onggi::screens
