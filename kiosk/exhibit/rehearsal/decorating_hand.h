#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/picture/view/camera.h"
#include "kiosk/visit/decorating/decorated_pot.h"

namespace onggi::rehearsal {

/// A scripted hand on the screen where a pot is decorated: each tool of its way once or a few
/// times, in the makers' order, at quiet places of the pot. The same pot gives the same touches.
class DecoratingHand {
 public:
  explicit DecoratingHand(const decorating::DecoratedPot& pot);

  /// What the visitor does now: a control to touch, a place where a finger is, or nothing.
  struct Act {
    std::string control;
    std::optional<std::pair<float, float>> finger;  ///< Pixels; absent: it is off the glass.
  };
  /// Once a frame; `now`: s, on the visit's clock.
  Act step(double now, const decorating::DecoratedPot& pot, const view::Camera& camera);
  bool done() const { return next_ >= touches_.size(); }

 private:
  /// A tool's stroke from one place to another: shares of the outside's length, and turns from the
  /// front.
  struct Touch {
    int tool = 0;
    double from = 0, to = 0, across = 0;
  };

  std::vector<Touch> touches_;
  std::size_t next_ = 0;
  int held_ = -1;
  double began_ = -1;
};

}  // namespace onggi::rehearsal
