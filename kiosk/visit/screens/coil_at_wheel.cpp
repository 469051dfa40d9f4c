#include "kiosk/visit/screens/coil_at_wheel.h"

#include <algorithm>
#include <utility>

namespace onggi::screens {

namespace {
constexpr double kSurelyLays = 0.8;  // of the pace at which the rim takes a coil
}  // namespace

const Profile* CoilAtWheel::target() const {
  const ShelfCard* card = desk_.shelf_card(desk_.card);
  return card != nullptr && !card->target.points.empty() ? &card->target : nullptr;
}

const script::RingPlan* CoilAtWheel::plan() const {
  const Profile* const vessel = built() ? target() : nullptr;
  if (vessel == nullptr) return nullptr;
  const Planned now{desk_.card, vessel->height(), vessel->max_radius(), diameter(),
                    desk_.wheel().beating.has_value()};
  if (!plan_ || planned_ != now) {
    planned_ = now;
    BuildingDef law;
    law.coil = diameter();
    plan_.emplace(*vessel, desk_.wheel().floor, law, desk_.wheel().beating);
  }
  return &*plan_;
}

bool CoilAtWheel::lacks_a_ring() const {
  return plan() != nullptr && plan()->lacks_a_ring(desk_.world.wheel->clay);
}

bool CoilAtWheel::wall_is_there_now() {
  const bool lacks = lacks_a_ring();
  return std::exchange(lacked_, lacks) && !lacks;
}

void CoilAtWheel::hold(bool on, WheelSpeed& speed) {
  hand_ = on ? std::optional<CoilHand>(diameter()) : std::nullopt;
  desk_.world.wheel_commands->hold(on ? loop::InHand::coil : loop::InHand::tool);
  if (!on) return speed.fast(desk_);
  const double widest = target() != nullptr ? target()->max_radius() : 0.0;
  speed.slow(WheelSpeed::Slowly::laying,
             widest > 0 ? kSurelyLays * desk_.wheel().pace / widest : 0.0, desk_);
}

void CoilAtWheel::follow(double dt) {
  const ClayView& clay = desk_.world.wheel->clay;
  hand_->follow(clay, dt,
                plan() != nullptr ? std::optional(plan()->next_ring(clay)) : std::nullopt);
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
