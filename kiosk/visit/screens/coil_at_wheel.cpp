#include "kiosk/visit/screens/coil_at_wheel.h"

#include <algorithm>
#include <utility>

#include "kiosk/visit/screens/hint.h"

namespace onggi::screens {

namespace {
constexpr double kSurelyLays = 0.8;  // of the pace at which the rim takes a coil
}  // namespace

const Profile* CoilAtWheel::target() const {
  const ShelfCard* card = desk_.shelf_card(desk_.card);
  return card != nullptr && !card->target.points.empty() ? &card->target : nullptr;
}

bool CoilAtWheel::lacks_a_ring() const {
  return built() && target() != nullptr &&
         screens::lacks_a_ring(desk_.world.wheel->clay.rim_height(), target()->height(),
                               diameter());
}

bool CoilAtWheel::wall_is_there_now() {
  const bool lacks = lacks_a_ring();
  return std::exchange(lacked_, lacks) && !lacks;
}

void CoilAtWheel::hold(bool on, WheelSpeed& speed) {
  hand_ = on ? std::optional<CoilHand>(diameter()) : std::nullopt;
  desk_.world.wheel_commands->hold(on ? loop::InHand::coil : loop::InHand::tool);
  const double widest = target() != nullptr ? target()->max_radius() : 0.0;
  speed.lay(on, widest > 0 ? kSurelyLays * desk_.wheel().pace / widest : 0.0, desk_);
}

void CoilAtWheel::lay_a_ring(const Profile& target, double side) {
  const ClayView& clay = desk_.world.wheel->clay;
  const double top = std::min(clay.rim_height() + diameter(), target.height());
  hand_->lay_a_ring(side, target.outer_at(top) - 0.5 * diameter(), clay);
}

void CoilAtWheel::send(const view::Camera& camera) const {
  desk_.world.wheel_commands->hand(0, hand_->input(camera, desk_.world.wheel->clay));
  desk_.world.wheel_commands->hand(1, {});
}

Button CoilAtWheel::button(Button show) const {
  if (by_itself())
    show.look = Look::chosen;
  else if (held() && !lacks_a_ring())
    show.id.clear();
  return show;
}

}  // namespace onggi::screens
