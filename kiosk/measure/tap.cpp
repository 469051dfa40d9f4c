#include "kiosk/measure/tap.h"

namespace onggi::measure {

void tap(screens::Visit& visit, float x, float y, double now) {
  for (const auto kind :
       {view::InputEvent::Kind::pointer_down, view::InputEvent::Kind::pointer_up}) {
    view::InputEvent event;
    event.kind = kind;
    event.x = x;
    event.y = y;
    visit.input(event, now);
  }
}

}  // namespace onggi::measure
