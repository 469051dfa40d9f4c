#include "kiosk/visit/decorating/touch_queue.h"

namespace onggi::decorating {

namespace {
constexpr std::size_t kMostKept = 2000;  // a hurried pot is busy for less than 30 of them
}  // namespace

void TouchQueue::take(const Touch& touch) {
  if (kept_.empty() && !pot_.busy()) return hand_over(touch);
  // A lift is always kept: else the finger would stay on the pot.
  if (kept_.size() < kMostKept || touch.kind == Touch::up) kept_.push_back(touch);
}

void TouchQueue::hand_over(const Touch& touch) {
  switch (touch.kind) {
    case Touch::down:
      return pot_.press(touch.at);
    case Touch::moved:
      return pot_.move(touch.at);
    case Touch::up:
      return pot_.lift();
    case Touch::button:
      return pot_.put(touch.at);
  }
}

void TouchQueue::hand_over_kept() {
  while (!kept_.empty() && !pot_.busy()) {
    const Touch next = kept_.front();
    kept_.pop_front();
    hand_over(next);
  }
}

void TouchQueue::update(double dt, bool hurry) {
  pot_.update(dt, hurry || waits());
  hand_over_kept();
}

void TouchQueue::cancel() {
  // What is kept of this finger begins with its press.
  for (bool pressed = false; !kept_.empty() && !pressed; kept_.pop_back())
    pressed = kept_.back().kind == Touch::down;
  pot_.cancel();
}

void TouchQueue::settle() {
  while (waits()) {
    pot_.end_work();
    hand_over_kept();
  }
}

}  // namespace onggi::decorating
