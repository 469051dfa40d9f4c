#include "kiosk/visit/screens/coil_hand.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

using view::InputEvent;

namespace {
constexpr double kPressed = 0.04;  // coils into the rim: it rests on an uneven one too
constexpr double kAside = 0.5;     // coils: as far as a finger moves the coil from its place
constexpr double kGently = 0.02;   // m/s: so a hurried finger makes no corner in a ring
// Of the rim's radius: a finger that goes so far may go round. Coils inside the rim's middle: a
// finger there is in front of the pot.
constexpr double kRound = 0.25, kBefore = 0.75;
constexpr double kRisen = 0.5;        // coils that the rim rises as a ring closes
constexpr double kOnTop = 0.0005;     // m inside the wall's edge: farther out it would slip off
constexpr double kRoundEdge = 0.003;  // m: the rim's edges are so round (rim_touched)
// A hand whose coil became a ring has no coil until it lies so lightly on the new rim, coils. It is
// up there within so many s.
constexpr double kLightly = 0.01, kNextCoil = 0.35;

/// The wall's top where a hand is.
struct Rim {
  double outer = 0, inner = 0;

  /// The rim around `way` from the axis, studio frame.
  static Rim at(const ClayView& clay, Vec3 way) {
    const int top = clay.rows() - 1;
    const double turn = (std::atan2(way.z, way.x) - clay.angle) / (2 * 3.14159265358979);
    const auto n = static_cast<double>(clay.sectors());
    const auto i = static_cast<std::size_t>(std::min((turn - std::floor(turn)) * n, n - 1));
    return {double{clay.outer(top)[i]}, double{clay.inner(top)[i]}};
  }
  bool solid() const { return inner <= 0.0; }
  /// Where a coil lies without a lean, m from the axis.
  double middle(double coil) const {
    return solid() ? std::max(outer - 0.5 * coil, 0.0) : 0.5 * (outer + inner);
  }
  double within(double radius, double coil) const {
    const double least = solid() ? 0.5 * coil : inner + kOnTop, most = outer - kOnTop;
    return least < most ? std::clamp(radius, least, most) : middle(coil);
  }
  /// How far a coil at `radius` lies lower than on the flat of the rim, m.
  double sinks(double radius, double coil) const {
    const double edge = std::min(kRoundEdge, 0.5 * (outer - inner)), reach = 0.5 * coil + edge;
    const double inside = solid() ? 0.0 : inner + edge - radius;
    const double over = std::min(std::max({radius - outer + edge, inside, 0.0}), reach);
    return reach - std::sqrt(reach * reach - over * over);
  }
};
}  // namespace

double CoilHand::middle_of_rim(const ClayView& clay, double diameter) {
  const int top = clay.rows() - 1;
  return Rim{clay.mean_outer(top), clay.mean_inner(top)}.middle(diameter);
}

bool CoilHand::pointer(const InputEvent& e, const view::Camera& camera, const ClayView& clay) {
  if (e.finger != 0) return false;
  const Vec2 at = camera.on_axis_plane(e.x, e.y);
  const double x = at.x, middle = middle_of_rim(clay, diameter_);
  switch (e.kind) {
    case InputEvent::Kind::pointer_down:
      lift();
      active_ = grabbed_ = true;
      round_ = false;
      began_ = x;
      side_ = x < 0 ? -1.0 : 1.0;
      break;
    case InputEvent::Kind::pointer_move:
      if (!grabbed_) return false;
      // In front of the pot, not ahead of the rim on the vessel's line; or across the axis.
      round_ = round_ || (std::abs(x - began_) > kRound * middle &&
                          (x * began_ < 0 || (std::abs(x) < middle - kBefore * diameter_ &&
                                              at.y < clay.rim_height() + diameter_)));
      break;
    case InputEvent::Kind::pointer_up:
      if (!grabbed_) return false;
      lift();
      return true;
    default:
      return false;
  }
  px_ = e.x, py_ = e.y;
  wish_ = std::clamp(side_ * (x - began_), -kAside * diameter_, kAside * diameter_);
  return true;
}

void CoilHand::move_by_keys(double side, double outward) {
  if (!active_) {
    active_ = true;
    round_ = false;
    side_ = side;
  } else {
    wish_ = std::clamp(wish_ + outward, -kAside * diameter_, kAside * diameter_);
  }
}

void CoilHand::lay_a_ring(double side, const ClayView& clay) {
  lift();
  active_ = true;
  round_ = false;
  side_ = side;
  ends_ = clay.rim_height() + kRisen * diameter_;
}

void CoilHand::follow(const ClayView& clay, double dt, std::optional<double> belongs) {
  belongs_ = belongs;
  aside_ += std::clamp(wish_ - aside_, -kGently * dt, kGently * dt);
  const double rim = clay.rim_height();
  lightly_ = !active_                          ? 0.0
             : rim > rim_ + kRisen * diameter_ ? kNextCoil
                                               : std::max(0.0, lightly_ - dt);
  rim_ = rim;
  if (ends_ && rim >= *ends_) lift();
}

HandInput CoilHand::input(const view::Camera& camera, const ClayView& clay) const {
  HandInput hand;
  hand.active = active_ && clay.rows() > 0;
  if (!hand.active) return hand;
  const double height =
      clay.rim_height() + (0.5 - (lightly_ > 0 ? kLightly : kPressed)) * diameter_;
  Vec3 way, up, back;
  camera.basis(way, up, back);
  way = side_ * way;
  const auto there = round_ ? camera.on_level(px_, py_, height) : std::nullopt;
  if (there && axis_distance(*there) > 1e-6)
    way = (1.0 / axis_distance(*there)) * Vec3{there->x, 0.0, there->z};
  const Rim rim = Rim::at(clay, way);
  const double radius = rim.within(
      (belongs_ ? *belongs_ : rim.middle(diameter_)) + (there ? 0.0 : aside_), diameter_);
  hand.position = radius * way;
  hand.position.y = height - rim.sinks(radius, diameter_);
  return hand;
}

}  // namespace onggi::screens
