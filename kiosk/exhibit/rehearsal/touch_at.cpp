#include "kiosk/exhibit/rehearsal/touch_at.h"

#include "kiosk/visit/screens/throwing_controls.h"

namespace onggi::rehearsal {

void touch_at(screens::Visit& visit, float x, float y, double now) {
  for (const auto kind :
       {view::InputEvent::Kind::pointer_down, view::InputEvent::Kind::pointer_up}) {
    view::InputEvent event;
    event.kind = kind;
    event.x = x;
    event.y = y;
    visit.input(event, now);
  }
}

std::optional<view::Rect> way_to(const screens::Visit& visit, const std::string& control) {
  if (visit.control(control) || visit.screen() != screens::ScreenId::throwing) return std::nullopt;
  const auto open = visit.control(screens::way_into_drawer(control));
  return open ? open : visit.control("throw.less");
}

}  // namespace onggi::rehearsal
