#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kiosk/picture/view/input.h"

namespace onggi::view {

/// Which finger is which on a glass that many may touch: up to kMost at once, each with a place of
/// its own from its going down to its lifting (InputEvent::finger, the least that is free). Every
/// down is followed by exactly one up, whatever the glass reports: fingers that are told twice,
/// never, or no more. Plain values; knows no clock.
class Fingers {
 public:
  static constexpr int kMost = 10;
  /// s without news after which a finger is taken to be gone: even one that rests trembles.
  static constexpr double kLost = 20.0;

  /// What a glass reports of the touch `id` at `now` (s, never going back), in pixels. Appends what
  /// it means to `out`. A finger beyond kMost is let be until it lifts.
  void down(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out);
  void move(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out);
  void up(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out);
  /// Once a frame: lets those go that are lost.
  void look_after(double now, std::vector<InputEvent>& out);
  /// The glass is gone, or another window has it: all lift where they were.
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
