#include "kiosk/visit/screens/wire_cut.h"

namespace onggi::screens {

namespace {
// m/s: slower than a hand in clay (PointerHandDef); otherwise it would stop inside a broad foot.
constexpr double kWireSpeed = 0.06;
constexpr double kWireHigh = 0.0015;  // m over the wheel head
constexpr double kClear = 0.03;       // m beyond the foot, where it begins and ends
}  // namespace

bool WireCut::update(double dt, const loop::WheelView& wheel, Vec3 right,
                     loop::WheelCommands& wheel_commands) {
  const double beyond = wheel.clay.radius_at(0.01, WallSide::outside) + kClear;
  if (!begun_) at_ = beyond;
  begun_ = true;
  at_ -= kWireSpeed * dt;
  HandInput hand;
  hand.active = at_ > -beyond;
  hand.side = SideWish::outside;
  hand.tool = tool_;
  hand.position = {right.x * at_, kWireHigh, right.z * at_};
  hand.handle = {-right.z, 0, right.x};
  wheel_commands.hand(0, hand);
  return !hand.active;
}

}  // namespace onggi::screens
