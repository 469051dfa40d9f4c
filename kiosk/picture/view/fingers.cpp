#include "kiosk/picture/view/fingers.h"

#include <algorithm>

namespace onggi::view {
namespace {

InputEvent event(InputEvent::Kind kind, int place, float x, float y) {
  InputEvent e;
  e.kind = kind;
  e.x = x;
  e.y = y;
  e.glass = true;
  e.finger = static_cast<std::uint8_t>(place);
  return e;
}

}  // namespace

int Fingers::place_of(std::uint32_t id) const {
  for (int i = 0; i < kMost; ++i) {
    const Finger& f = fingers_[static_cast<std::size_t>(i)];
    if (f.there && f.id == id) return i;
  }
  return -1;
}

void Fingers::lift(int place, std::vector<InputEvent>& out) {
  Finger& f = fingers_[static_cast<std::size_t>(place)];
  out.push_back(event(InputEvent::Kind::pointer_up, place, f.x, f.y));
  f.there = false;
}

void Fingers::down(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out) {
  // reported twice: its lift was lost
  if (const int before = place_of(id); before >= 0) lift(before, out);
  const auto free =
      std::find_if(fingers_.begin(), fingers_.end(), [](const Finger& f) { return !f.there; });
  if (free == fingers_.end()) return;
  *free = {true, id, x, y, now};
  out.push_back(
      event(InputEvent::Kind::pointer_down, static_cast<int>(free - fingers_.begin()), x, y));
}

void Fingers::move(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out) {
  const int place = place_of(id);
  if (place < 0) return;
  Finger& f = fingers_[static_cast<std::size_t>(place)];
  f.heard = now;
  if (f.x == x && f.y == y) return;
  f.x = x;
  f.y = y;
  out.push_back(event(InputEvent::Kind::pointer_move, place, x, y));
}

void Fingers::up(std::uint32_t id, float x, float y, double now, std::vector<InputEvent>& out) {
  const int place = place_of(id);
  if (place < 0) return;
  Finger& f = fingers_[static_cast<std::size_t>(place)];
  f = {true, id, x, y, now};
  lift(place, out);
}

void Fingers::look_after(double now, std::vector<InputEvent>& out) {
  for (int i = 0; i < kMost; ++i) {
    const Finger& f = fingers_[static_cast<std::size_t>(i)];
    if (f.there && now - f.heard > kLost) lift(i, out);
  }
}

void Fingers::let_go(std::vector<InputEvent>& out) {
  for (int i = 0; i < kMost; ++i)
    if (fingers_[static_cast<std::size_t>(i)].there) lift(i, out);
}

bool Fingers::any() const {
  return std::any_of(fingers_.begin(), fingers_.end(), [](const Finger& f) { return f.there; });
}

}  // namespace onggi::view
