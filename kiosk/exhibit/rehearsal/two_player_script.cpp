#include "kiosk/exhibit/rehearsal/two_player_script.h"

#include <algorithm>
#include <cmath>

namespace onggi::rehearsal {

using view::InputEvent;

namespace {

constexpr double kWall = 0.007;              // m, the wall that they want
constexpr double kFrom = 0.1, kUpTo = 0.97;  // of the pot's height

InputEvent finger_at(InputEvent::Kind kind, int finger, const screens::WheelSnapshot& sight,
                     double radius, double height) {
  Vec3 right, up, back;
  sight.camera.basis(right, up, back);
  InputEvent e;
  e.kind = kind;
  e.finger = static_cast<std::uint8_t>(finger);
  e.glass = true;
  if (const auto at = sight.camera.project({right.x * radius, height, right.z * radius})) {
    e.x = static_cast<float>(at->first);
    e.y = static_cast<float>(at->second);
  }
  return e;
}

}  // namespace

std::vector<InputEvent> TwoPlayerScript::step(double now, const screens::WheelSnapshot& sight) {
  const double in_turn = std::fmod(now, kStroke + kRest);
  const bool works = now < kSeconds && in_turn < kStroke;
  if (!works && !down_) return {};
  const auto kind = !works  ? InputEvent::Kind::pointer_up
                    : down_ ? InputEvent::Kind::pointer_move
                            : InputEvent::Kind::pointer_down;
  down_ = works;
  const double share = works ? in_turn / kStroke : 1.0;
  const double height = (kFrom + (kUpTo - kFrom) * share) * sight.made->height();
  const double outer = sight.target->outer_at(height);
  // A stroke covers half of the remaining way, so that neither visitor tears the wall.
  const auto towards = [](double from, double to) { return from + 0.5 * (to - from); };
  const double outside = towards(sight.made->outer_at(height), outer);
  const double inside = towards(sight.made->inner_at(height), std::max(outer - kWall, 0.012));
  return {finger_at(kind, 0, sight, outside, height), finger_at(kind, 1, sight, -inside, height)};
}

}  // namespace onggi::rehearsal
