#include "engine/force/leather_hand.h"

#include <cmath>

#include "engine/math/portable.h"

namespace onggi::force {

Touch LeatherHand::meet(const LeatherOutline& wall, const DecoratingTool& tool, Vec3 at,
                        double share, const LeatherTurn& turn) noexcept {
  if (!wall.stands() || !is_finite(at)) {
    release();
    return {};
  }
  const NearWall met = place_.contact ? wall.near(at, place_.along, kReach) : wall.near(at);
  if (met.depth > kThrough) cleared_ = false;
  if (met.depth < kClear) cleared_ = true;
  const double round = (portable::atan2(at.z, at.x) - turn.angle) / (2.0 * portable::kPi);
  place_.near = tool.law != DecoratingLaw::none;
  place_.along = met.along;
  place_.turns = round - std::floor(round);
  place_.depth = met.depth;
  place_.contact = cleared_ && place_.near && met.depth > 0.0;
  if (!place_.contact) return {};
  const ToolPress press = press_of(tool, met.depth);
  Touch touch;
  touch.push = share * press.push * met.out;
  touch.stiffness = share * press.stiffness;
  touch.grip = share * press.grip;
  touch.clay = turn.speed * Vec3{-at.z, 0.0, at.x};
  return touch;
}

}  // namespace onggi::force
