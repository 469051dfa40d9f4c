#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"
#include "engine/scene/hands.h"

namespace onggi::script {

/// Place and action of the hand from `time` on; between two keys it moves on a straight line.
struct Key {
  double time = 0.0;         ///< s
  Vec2 place;                ///< x: distance from the axis, y: height; the tool's centre, m
  double wheel_speed = 0.0;  ///< rad/s
  bool active = false;
  bool water = false;
  WallSide side = WallSide::outside;
  double grip = 0.0;       ///< Above 0: the other hand works too, opposite and inside, with this
                           ///< distance between the two tools, m. 0: the other hand is away.
  std::string_view phase;  ///< Points to static storage.
};

/// Records one hand's moves in order: lifted moves, presses, rests. A hand on the clay never jumps.
/// Allocates.
class Choreography {
 public:
  /// `pace` multiplies every speed of the hand, and the wheel's up to 1.5 times and to
  /// `most_wheel_speed`. `seed`: small unevenness of a human hand.
  Choreography(double pace, double most_wheel_speed, std::uint64_t seed);

  void phase(std::string_view name) { now_.phase = name; }
  void wheel(double speed);  ///< rad/s from here on.
  void water(bool on) { now_.water = on; }
  /// Independent of pace, because wet clay and a spinning wheel need their time.
  void wait(double seconds);
  void wait_turns(double turns);  ///< Of the wheel at its asked speed.

  /// Lifts the hand (straight away from the wall, if it was on it) and carries it, clear of the
  /// pot, to `place` on `side`. `rim` and `widest` are the pot's rim height and largest radius, m.
  void carry(WallSide side, Vec2 place, double rim, double widest, double radius);
  /// Puts the hand to the clay here and moves it along `path` at about `speed` m/s. `rooms`, if as
  /// many as places, give the grip at each place (m; 0: the other hand is away).
  void glide(std::span<const Vec2> path, double speed, std::span<const double> rooms = {});
  /// Closes or opens the grip of both hands to `room` metres within `seconds`, about its middle.
  /// The hands come onto the clay by this, so nothing may be between them before.
  void grip(double room, double seconds);
  /// Lifts the hand straight up by `way` metres, off the rim or out of the pot, at about `speed`.
  void raise(double way, double speed);
  void lift();

  double time() const { return now_.time; }
  double time_on_clay() const { return glide_time_; }
  std::vector<Key> finish();

 private:
  void put() { keys_.push_back(now_); }
  void go(Vec2 place, double speed);
  double sway(double length) const;

  double pace_, wheel_pace_, most_wheel_;
  double sway_phase_[3];
  double glide_time_ = 0.0;
  double glided_ = 0.0;  // metres on the clay so far, the argument of the unevenness
  Key now_;
  std::vector<Key> keys_;
};

}  // namespace onggi::script
