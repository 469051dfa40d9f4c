#pragma once

#include <string>
#include <vector>

#include "engine/lab/plain_wall.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi::lab {

/// A piece of a potter's work for balls on a bare wall, the same at any tick and on any grid. It
/// keeps off rim and floor, so a program without them can repeat it.
struct AccuracyScript {
  std::string name;              ///< "press"
  std::string words;             ///< The action, for a person.
  SceneDef def;                  ///< Without effects, with an open guard; the caller sets the grid.
  double seconds = 1.0;          ///< A multiple of kForceWindow.
  double wheel = 12.0;           ///< rad/s, reached at def.wheel.acceleration.
  double low = 0.0, high = 0.0;  ///< Heights that are touched, with a little margin, m.

  struct Hand {
    WallSide side = WallSide::outside;
    double angle = 0.0;                   ///< Studio frame, rad.
    double clear = 0.0, deep = 0.0;       ///< Distance of the ball's middle from the axis, m.
    double from = 0.0, to = 0.0;          ///< Height, m.
    double belly = 0.0;                   ///< How much less deep the ball goes at the belly, m.
    double in_by = 0.4, out_from = 0.65;  ///< Shares of the time; 1 or more: it stays in.
  };
  std::vector<Hand> balls;  ///< One or two.

  /// Where ball `n` is at `t` seconds, studio frame, m.
  Vec3 place(std::size_t n, double t) const;
  Hands hands(double t) const;
  /// How far the wheel has turned by then, rad, computed as Scene does.
  double wheel_angle(double t) const;
  /// True for each face that is worked.
  bool works(WallSide side) const;
};

/// Forces are compared as means over this many seconds, a tick of the slowest rate.
inline constexpr double kForceWindow = 0.002;

/// press: a fingertip on the turning wall. pull: two hands, one on either face, rise together.
/// groove: a fingertip held for seven turns. collar: both hands outside, opposite each other.
/// centre: two palms on a solid lump at 300 rpm. near_axis: a narrow hole is opened, the ball
/// about the axis. throw: a vase, by one slow rise of a knuckle.
std::vector<AccuracyScript> accuracy_scripts();

}  // namespace onggi::lab
