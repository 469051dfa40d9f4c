#pragma once

#include "engine/clay/clay_view.h"
#include "engine/math/vec.h"
#include "engine/scene/hands.h"

namespace onggi::device {

/// A straight rib laid along the outside of a wall and drawn up it: leaning as the wall leans, it
/// takes off what stands out between the two places that bear it, and leaves hollows alone. Reads
/// the clay as it stands. Main thread; allocates nothing.
class RibPass {
 public:
  static constexpr double kRise = 0.012;   ///< m/s
  static constexpr double kDeep = 0.0003;  ///< m: so far it presses at the most.
  static constexpr double kClear = 0.006;  ///< m off the wall it sets in and comes away,
  static constexpr double kAway = 0.008;   ///< m/s there.

  /// `tool`: HandInput::tool of a flat rib of this length and thickness, m.
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
