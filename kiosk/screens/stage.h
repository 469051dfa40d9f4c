#pragma once

#include "kiosk/screens/desk.h"
#include "kiosk/screens/page.h"

namespace onggi::screens {

/// The pot on the wheel as a screen shows it: camera, tools, cut-away. Everything eases; nothing
/// jumps unless motion is reduced, and then it is simply there.
class Stage {
 public:
  /// `target` may be nullptr. `hold` keeps the camera still (a finger is on the clay).
  void update(const Desk& desk, double dt, const Profile* target, bool cut, bool hold);
  view::PotView view(const Desk& desk, const Page& page) const;
  /// The pot as large as its place allows, with the wheel head clear of the words.
  view::Camera camera(const Page& page) const;
  /// The clay as it is now, at most some 8 times a second. Empty before the first pot.
  const Profile& made() const { return made_; }

 private:
  Profile made_;
  double made_at_ = -1;
  std::uint32_t serial_ = 0;
  double height_ = 0, radius_ = 0, wheel_radius_ = 0;
  double cut_ = 0, shown_ = 0;
};

/// The target as a thin line at both silhouettes, in the plane through the axis that faces the
/// camera. Where `made` is too wide: warm, solid and stronger; too narrow: cool and dashed; near
/// enough: thin. `made` may be empty.
void draw_ghost(Page& page, const view::Camera& camera, const Profile& target, const Profile& made);

/// An arrow at `height` on the right of `target`'s outline: `inward` presses towards the axis from
/// outside, else outwards from inside.
void draw_press(Page& page, const view::Camera& camera, const Profile& target, double height,
                bool inward);

/// How far `made` may be from `target`'s outer radius and still be called alike, metres.
double tolerance(const Profile& target);

}  // namespace onggi::screens
