#include "kiosk/wheel/loop/stepped_potter.h"

#include "kiosk/wheel/loop/pacer.h"

namespace onggi::loop {

void SteppedPotter::advance(int ticks) {
  for (int i = 0; i < ticks; ++i) core_.tick(Pacer::kTick);
}

}  // namespace onggi::loop
