#include "kiosk/wheel/loop/stepped_wheel.h"

#include "kiosk/wheel/loop/pacer.h"

namespace onggi::loop {

void SteppedWheel::advance(int ticks) {
  for (int i = 0; i < ticks; ++i) core_.tick(Pacer::kTick);
}

}  // namespace onggi::loop
