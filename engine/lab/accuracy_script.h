#pragma once

#include <string>
#include <vector>

#include "engine/lab/plain_wall.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi::lab {

/// A piece of a potter's work for balls on a bare wall, the same at any tick and on any grid. It
/// keeps off rim and floor, so that what it leaves can be had without an engine.
struct AccuracyScript {
  std::string name;      ///< "press"
  std::string words;     ///< What is done, for a person.
  SceneDef def;          ///< Without effects; its grid is whoever measures'. The guard is open.
  double seconds = 1.0;  ///< A multiple of kForceWindow.
  double wheel = 12.0;   ///< rad/s, reached at def.wheel.acceleration.
  double low = 0.0, high = 0.0;  ///< Heights between which clay is touched, and a little, m.

  struct Hand {
    WallSide side = WallSide::outside;
    double angle = 0.0;              ///< Studio frame, rad.
    double clear = 0.0, deep = 0.0;  ///< Of the ball's middle from the axis, m.
    double from = 0.0, to = 0.0;     ///< Height, m.
    double belly = 0.0;              ///< How much less deep it goes where the pot's belly is, m.
    double in_by = 0.4, out_from = 0.65;  ///< Shares of the time; 1 or more: it stays in.
  };
  std::vector<Hand> balls;  ///< One or two.

  /// Where ball `n` is at `t` seconds, studio frame, m.
  Vec3 place(std::size_t n, double t) const;
  Hands hands(double t) const;
  /// How far the wheel has turned by then, rad: as Scene turns it.
  double wheel_angle(double t) const;
  /// Which faces are worked.
  bool works(WallSide side) const;
};

/// Forces are compared as means over this many seconds: a tick of the slowest rate.
inline constexpr double kForceWindow = 0.002;

/// press: a fingertip on the turning wall. pull: two hands, one on either face, rise together.
/// groove: a fingertip held for seven turns. collar: both hands outside, opposite each other.
/// centre: two palms on a solid lump at 300 rpm. near_axis: a narrow hole is opened, the ball
/// about the axis. throw: a vase, by one slow rise of a knuckle.
std::vector<AccuracyScript> accuracy_scripts();

}  // namespace onggi::lab
