#pragma once

#include <array>
#include <optional>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The picture of the pot on the wheel: camera, hands, cut-away. Everything moves smoothly; with
/// reduced motion it changes at once.
class PotPicture {
 public:
  /// `target` may be nullptr. `hold` keeps the camera still (a finger is on the clay).
  void update(const Desk& desk, double dt, const Profile* target, bool cut, bool hold);
  /// Shows a resting pot from all sides: wheel and pot turn, from the wheel's last speed to `speed`
  /// (rad/s, positive towards the visitor's right hand).
  void show_round(const Desk& desk, double dt, double speed);
  /// Shadows fall away from the words.
  view::PotView view(const Desk& desk, const Page& page) const;
  /// Makes the pot as large as its place allows, with the wheel head clear of the words.
  view::Camera camera(const Page& page) const;
  /// The outline of the clay, updated at most about 8 times a second. Empty before the first pot.
  const Profile& made() const { return made_; }
  /// True if `at` (x right of the axis, y height, metres) is on the clay, or a finger's width
  /// beside it.
  bool on_clay(Vec2 at) const;

 private:
  view::Camera frame(const Page& page) const;

  Profile made_;
  double made_at_ = -1;
  std::uint32_t serial_ = 0;
  double height_ = 0, radius_ = 0, wheel_radius_ = 0;
  double cut_ = 0, shown_ = 0;
  /// The last camera and its input. Searching for one takes a third of a frame's work.
  struct Framed {
    std::array<double, 14> of{};
    view::Camera camera;
  };
  mutable std::optional<Framed> framed_;
  double turned_ = 0;                 ///< Turned by show_round(), rad,
  std::optional<double> turn_speed_;  ///< and its speed, rad/s.
};

}  // namespace onggi::screens
