#include "kiosk/visit/screens/water_button.h"

#include <utility>

namespace onggi::screens {

void WaterButton::hold(double now) {
  down_at_ = now;
  was_wet_ = std::exchange(wet_, true);
}

void WaterButton::press(double now) {
  const double since = std::exchange(down_at_, -1);
  wet_ = since < 0 ? !wet_ : now - since <= kSoakHold && !was_wet_;
}

}  // namespace onggi::screens
