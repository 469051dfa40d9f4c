#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/random.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::rehearsal {

/// The hands of a beginner at a screen. They see the pot, the line to meet and the hint, and they
/// make strokes in pixels. They know nothing of the engine. The model follows research on movement:
/// a stroke begins and ends slowly (Flash & Hogan 1985), trembles at about 9 Hz (physiological
/// tremor, Stiles 1976), drifts off the line and cuts corners (Accot & Zhai 1997). Deterministic in
/// the seed. Main thread.
class NaiveHands {
 public:
  /// The pointer. A finger is shakier, hides what it touches, and is lifted more often.
  enum class Pointer { mouse, finger };
  /// `seconds`: when they call the pot done, 5 to 600.
  NaiveHands(std::uint64_t seed, double seconds, Pointer pointer);

  struct Move {
    std::vector<view::InputEvent> events;  ///< In order, for this frame.
    std::string control;                   ///< The control to touch afterwards; empty for none.
  };
  /// The actions in the frame at `now`, in seconds since they began; rising. `width` of the screen,
  /// px, scales their motion (speeds are for 1280).
  Move step(double now, const screens::WheelSnapshot& sight, int width);
  bool done() const { return done_; }

 private:
  struct Point {
    double x = 0, y = 0;  ///< Pixels.
  };
  void choose(const screens::WheelSnapshot& sight);
  void trace(const screens::WheelSnapshot& sight, double from, double to);
  void push(const screens::WheelSnapshot& sight, double height, bool inward);
  void poke(const screens::WheelSnapshot& sight, double height);
  void scrub(const screens::WheelSnapshot& sight, double height);
  void lay(const screens::WheelSnapshot& sight);
  void beat(const screens::WheelSnapshot& sight);
  std::string asked_for(double now, const screens::WheelSnapshot& sight);
  std::string finish();
  void begin_stroke(std::vector<Point> path, double speed);
  Point line_at(const screens::WheelSnapshot& sight, double height) const;
  Point clay_at(const screens::WheelSnapshot& sight, double height) const;
  Point on_path(double along) const;
  Point tremble(double dt);
  double hand_speed();

  Random random_;
  Pointer pointer_;
  double seconds_, last_ = 0, side_ = 1, scale_ = 1;
  double wait_until_ = 0;      ///< They only look until then.
  double asked_since_ = -1;    ///< Since when the hint has asked for a button.
  std::string asked_key_;      ///< That hint.
  std::string works_by_;       ///< The hint at the beginning of a stroke with coil or paddle,
  double changed_since_ = -1;  ///< and since when there has been another.
  bool tray_open_ = false;
  std::vector<Point> path_;  ///< The current stroke; empty for none.
  double length_ = 0, along_ = 0, speed_ = 0;
  bool down_ = false, done_ = false;
  Point shake_{}, shake_speed_{}, wander_{};
  int strokes_ = 0;
};

}  // namespace onggi::rehearsal
