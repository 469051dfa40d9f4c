#include "kiosk/visit/screens/show_me.h"

#include <utility>

#include "kiosk/visit/screens/target_line.h"

namespace onggi::screens {

using device::Stroke;

void ShowMe::begin(const Desk& desk, const Profile& target, double side,
                   device::PointerLead& hands) {
  const ClayView& clay = desk.world.wheel->clay;
  if (!desk.pot_ready() || clay.rows() == 0) return;
  asked_ = false;
  auto stroke = device::next_stroke(clay, target, 0.5 * tolerance(target));
  finger_.begin(stroke ? std::move(*stroke) : device::last_stroke(clay, target), side, hands, clay);
}

void ShowMe::hold(const Desk& desk, const Profile& target, double side,
                  device::PointerLead& hands) {
  held_since_ = desk.now;
  ended_ = showing();
  if (ended_)
    stop(hands);
  else
    begin(desk, target, side, hands);
}

void ShowMe::press(const Desk& desk, const Profile& target, double side,
                   device::PointerLead& hands) {
  const double since = std::exchange(held_since_, -1);
  if (since < 0) {  // by a key, which cannot hold
    if (showing()) return stop(hands);
    return begin(desk, target, side, hands);
  }
  if (!std::exchange(ended_, false) && desk.now - since > kHold) stop(hands);
}

void ShowMe::draw(double dt, device::PointerLead& hands, const ClayView& clay) {
  finger_.draw(dt, hands, clay);
}

void ShowMe::make(Stroke stroke, const ClayView& clay, double side, device::PointerLead& hands) {
  stop(hands);
  asked_ = true;
  finger_.begin(std::move(stroke), side, hands, clay);
}

void ShowMe::stop(device::PointerLead& hands) { finger_.stop(hands); }

Button ShowMe::button(const Desk& desk, bool away) const {
  return {away ? "" : "throw.show", desk.say("throw.show"),
          away                   ? Look::plain
          : showing() && !asked_ ? Look::chosen
                                 : Look::outline};
}

std::string ShowMe::key() const {
  return finger_.stroke() ? kKeys[static_cast<std::size_t>(finger_.stroke()->kind)] : "";
}

content::HandsDrawn ShowMe::drawing() const {
  using content::HandsDrawn;
  if (!finger_.stroke()) return HandsDrawn::up;
  switch (finger_.stroke()->kind) {
    case Stroke::Kind::open:
      return HandsDrawn::inside;
    case Stroke::Kind::belly:
    case Stroke::Kind::collar:
      return HandsDrawn::along;
    case Stroke::Kind::smooth:
      break;
  }
  return HandsDrawn::up;
}

}  // namespace onggi::screens
