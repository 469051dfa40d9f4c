#pragma once

#include <span>
#include <string_view>

#include "engine/clay/wall_side.h"
#include "engine/scene/scene.h"

namespace onggi {

/// A named, endless piece of work for the tick, the same in tests, benchmarks, instruction counts
/// and on every grid: a tool (sometimes two) that rises along the turning wall faster than its own
/// groove is high, so that the clay under it is always fresh. Pure data; metres, seconds, radians.
struct TickScript {
  std::string_view name;    ///< A short id: "inside_29_mm".
  std::string_view says;    ///< What the hands do.
  double inner_radius = 0;  ///< Of the lump.
  double outer_radius = 0;  ///< Of the lump.
  double distance = 0;      ///< The tool's centre from the axis.
  double rise = 0;          ///< Speed along the wall, m/s.
  double wheel_speed = 0;   ///< rad/s.
  WallSide side = WallSide::outside;
  double second_distance = 0;  ///< A second tool, inside, at the same place; 0: there is none.
  bool touches = true;

  /// The default scene on a grid of `rows` x `sectors`, with this script's lump.
  SceneDef scene(int rows, int sectors) const;
  /// The hands at tick `n` (>= 0) of a pass, of 1 ms each. A pass is `pass()` ticks; after it the
  /// clay is to be renewed, and n is 0 again.
  Hands hands(int n) const;
  int pass() const;
};

inline constexpr double kTickSeconds = 0.001;

/// All of them, lightest first.
std::span<const TickScript> tick_scripts();
/// The one of that name. A name that is not there ends the program.
const TickScript& tick_script(std::string_view name);

/// Puts fresh clay on, with the hands lifted and the wheel going on: the ticks that it takes.
/// Gives how many they were.
int renew_clay(Scene& scene, double wheel_speed);

}  // namespace onggi
