#pragma once

#include "kiosk/device/wall_hold.h"
#include "kiosk/screens/desk.h"
#include "kiosk/screens/mishap.h"
#include "kiosk/screens/page.h"

namespace onggi::screens {

/// How the throwing screen's controls stand.
struct ThrowingControls {
  double speed = 0;  ///< Asked of the wheel, rad/s.
  device::Grip grip = device::Grip::both;
  bool water = false, cut = false;
  bool restore = false;  ///< There is a stroke to take back.
  Button show = {};      ///< "Show me".
  bool skip = false;     ///< There is a lesson to be skipped.
};

/// From the foot of `column` up: done, the clay, the wheel, what a device pushes with, the hands.
void lay_out_controls(Page& page, Column& column, const Desk& desk, const ThrowingControls& now);

/// What has happened to the pot, in words, and the way back.
void lay_out_mishap(Column& column, const TypeScale& t, const Desk& desk, Mishap what);

}  // namespace onggi::screens
