#include "kiosk/visit/screens/water_button.h"

#include <utility>

namespace onggi::screens {

namespace {
constexpr double kDryClay = 0.05;  // of wetness
}

void WaterButton::hold(double now) {
  down_at_ = now;
  was_wet_ = std::exchange(wet_, true);
}

void WaterButton::press(double now) {
  const double since = std::exchange(down_at_, -1);
  wet_ = since < 0 ? !wet_ : now - since <= kSoakHold && !was_wet_;
}

void WaterButton::look(bool rubs, double wetness, double dt) {
  if (rubs) dry_ = wetness < kDryClay ? dry_ + dt : 0;
  if (wet_) dry_ = 0;
}

}  // namespace onggi::screens
