#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/random.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::rehearsal {

/// Somebody's hands who never threw a pot, on a screen: what they see are the pot, the line to meet
/// and the hint; what they do are strokes in pixels. Nothing of the engine is known here. Written
/// from how people move: a stroke begins and ends slowly (Flash & Hogan 1985), trembles with some 9
/// Hz (physiological tremor, Stiles 1976), wanders off the line and cuts corners (Accot & Zhai
/// 1997). Deterministic in the seed. Main thread.
class NaiveHands {
 public:
  /// What they hold. A finger is shakier, hides what it touches, and is lifted more often.
  enum class Pointer { mouse, finger };
  /// `seconds`: until they call the pot done, 5 to 600.
  NaiveHands(std::uint64_t seed, double seconds, Pointer pointer);

  struct Move {
    std::vector<view::InputEvent> events;  ///< In order, for this frame.
    std::string control;                   ///< To be touched afterwards; empty for none.
  };
  /// What is done in the frame at `now`, in seconds since they began; rising. `width`: of the
  /// screen, px, by which what they move is scaled (speeds are said for 1280).
  Move step(double now, const screens::Sight& sight, int width);
  bool done() const { return done_; }

 private:
  struct Point {
    double x = 0, y = 0;  ///< Pixels.
  };
  void choose(const screens::Sight& sight);
  void trace(const screens::Sight& sight, double from, double to);
  void push(const screens::Sight& sight, double height, bool inward);
  void poke(const screens::Sight& sight, double height);
  void scrub(const screens::Sight& sight, double height);
  void begin_stroke(std::vector<Point> path, double speed);
  Point line_at(const screens::Sight& sight, double height) const;
  Point clay_at(const screens::Sight& sight, double height) const;
  Point on_path(double along) const;
  Point tremble(double dt);
  double hand_speed();

  Random random_;
  Pointer pointer_;
  double seconds_, last_ = 0, side_ = 1, scale_ = 1;
  double wait_until_ = 0;         ///< Looking on until then.
  double wrong_side_since_ = -1;  ///< The hint has asked for the other side since then.
  std::vector<Point> path_;       ///< Of the stroke under way; empty for none.
  double length_ = 0, along_ = 0, speed_ = 0;
  bool down_ = false, done_ = false;
  Point shake_{}, shake_speed_{}, wander_{};
  int strokes_ = 0;
};

}  // namespace onggi::rehearsal
