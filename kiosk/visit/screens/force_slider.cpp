#include "kiosk/visit/screens/force_slider.h"

#include <algorithm>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

std::vector<Button> ForceSlider::buttons(const Desk& desk) const {
  if (desk.world.devices == nullptr || !desk.world.devices->pushes()) return {};
  const auto percent = [&](int step) {
    return desk.say("throw.force_share", {{"percent", std::to_string(100 * step / kSteps)}});
  };
  const std::string now = step_ > 0 ? percent(step_) : desk.say("throw.force_off");
  return {{"throw.softer", desk.say("throw.softer"), Look::outline},
          {"", now, Look::plain, percent(kSteps)},
          {"throw.stronger", desk.say("throw.stronger"), Look::outline}};
}

bool ForceSlider::press(const std::string& control) {
  const bool softer = control == "throw.softer";
  if (!softer && control != "throw.stronger") return false;
  step_ = std::clamp(step_ + (softer ? -1 : 1), 0, kSteps);
  return true;
}

}  // namespace onggi::screens
