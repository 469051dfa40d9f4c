#pragma once

#include "engine/contact/tool_contact.h"

namespace onggi {

/// One step of a ball of radius `radius` (m) that is at `at` (clay frame) in the step's middle.
inline Press press_sphere(Clay& clay, WallSide side, Vec3 at, double radius, double seconds,
                          const Yielding& yielding) {
  return find_tool_shape("sphere")->press(clay, side, {at}, {radius, 0.0, 0.0}, seconds, yielding);
}

/// A ball's way through one tick of 1 ms, studio frame, while the wheel goes on by `turn` (rad).
inline ToolSweep sweep_sphere(Vec3 from, Vec3 to, double radius, double angle = 0.0,
                              double turn = 0.0, SideWish wish = SideWish::by_position) {
  ToolSweep sweep;
  sweep.shape = find_tool_shape("sphere");
  sweep.size = {radius, 0.0, 0.0};
  sweep.from = from;
  sweep.to = to;
  sweep.angle_from = angle;
  sweep.angle_to = angle + turn;
  sweep.seconds = 0.001;
  sweep.wish = wish;
  return sweep;
}

}  // namespace onggi
