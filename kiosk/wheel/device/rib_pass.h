#pragma once

#include "engine/clay/clay_view.h"
#include "engine/math/vec.h"
#include "engine/scene/hands.h"

namespace onggi::device {

/// Draws a straight rib up the outside of a wall, leaning like the wall. It removes the bumps
/// between the two places that carry it, and leaves hollows. Reads the current clay. Main thread;
/// allocates nothing.
class RibPass {
 public:
  static constexpr double kRise = 0.012;   ///< m/s
  static constexpr double kDeep = 0.0003;  ///< m: largest press.
  static constexpr double kClear = 0.006;  ///< m off the wall where it starts and ends,
  static constexpr double kAway = 0.008;   ///< m/s there.

  /// `tool`: HandInput::tool of a flat rib with this length and thickness, m.
  RibPass(std::uint8_t tool, double length, double thickness)
      : tool_(tool), length_(length), thickness_(thickness) {}

  void begin(const ClayView& clay);
  /// Once a frame.
  void follow(const ClayView& clay, double dt);
  bool done() const { return stage_ == Stage::off; }
  /// `right`: as PointerLead::input.
  HandInput input(Vec3 right) const;

 private:
  enum class Stage : std::uint8_t { setting, rising, leaving, off };
  void lay(const ClayView& clay);

  std::uint8_t tool_;
  double length_, thickness_;
  Stage stage_ = Stage::off;
  double height_ = 0, top_ = 0, clear_ = 0;
  double radius_ = 0, lean_ = 0;  ///< Of the rib's middle; run over rise.
};

}  // namespace onggi::device
