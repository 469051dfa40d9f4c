#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kiosk/picture/view/input.h"

namespace onggi::view {

/// Numbers the fingers on a touch screen that many people may touch: up to kMost at once, each with
/// its own number from touch to lift (InputEvent::finger, the least free one). Every down is
/// followed by exactly one up, even if the touch screen reports a finger twice, never, or no more.
/// Plain values; knows no clock.
class Fingers {
 public:
  static constexpr int kMost = 10;
  /// s without a report after which a finger counts as gone: even a resting finger trembles.
  static constexpr double kLost = 20.0;

  /// Handles a report about the touch `id` at `now` (s, never going back), in pixels. Appends the
  /// resulting events to `out`. A finger beyond kMost is ignored until it lifts.
  void down(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out);
  void move(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out);
  void up(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out);
  /// Call once a frame: lifts lost fingers.
  void look_after(double now, std::vector<InputEvent>& out);
  /// The touch screen is gone, or another window has it: all fingers lift where they were.
  void let_go(std::vector<InputEvent>& out);

  bool any() const;

 private:
  struct Finger {
    bool there = false;
    std::uint32_t id = 0;
    float x = 0, y = 0;
    double heard = 0;
  };
  int place_of(std::uint32_t id) const;
  void lift(int place, std::vector<InputEvent>& out);

  std::array<Finger, kMost> fingers_{};
};

}  // namespace onggi::view
