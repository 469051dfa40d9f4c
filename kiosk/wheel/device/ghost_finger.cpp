#include "kiosk/wheel/device/ghost_finger.h"

#include <algorithm>
#include <utility>

namespace onggi::device {

namespace {
constexpr double kApart = 0.02;  // m between two fingers that do not squeeze yet
// s of a stroke at once: where frames are few, a finger that leapt would leave ring upon ring.
constexpr double kLongestAtOnce = 0.1;
}  // namespace

void GhostFinger::begin(Stroke stroke, double sign, PointerLead& hands, const ClayView& clay) {
  if (stroke.path.empty()) return;
  stroke_ = std::move(stroke);
  sign_ = sign;
  waits_ = kRest;
  next_ = 1;
  at_ = stroke_->path.front();
  hands.lift();
  hands.grab({sign_ * at_.x, at_.y}, clay, stroke_->grip);
  if (stroke_->squeeze < 1) hands.pinch(Vec2{sign_ * (at_.x - kApart), at_.y}, clay);
}

// Put a second finger beside the first, which squeezes the wall between the hands.
void GhostFinger::drag(PointerLead& hands, const ClayView& clay) {
  hands.drag({sign_ * at_.x, at_.y});
  if (stroke_->squeeze < 1)
    hands.pinch(Vec2{sign_ * (at_.x - kApart * stroke_->squeeze), at_.y}, clay);
}

void GhostFinger::draw(double dt, PointerLead& hands, const ClayView& clay) {
  if (!stroke_) return;
  if (waits_ > 0) {
    waits_ -= dt;
    if (waits_ > 0 || next_ < stroke_->path.size()) return;
    hands.release();
    stroke_.reset();
    return;
  }
  double way = stroke_->speed * std::min(dt, kLongestAtOnce);
  while (next_ < stroke_->path.size() && way > 0) {
    const Vec2 to = stroke_->path[next_], rest = to - at_;
    const double left = length(rest);
    if (left > way) {
      at_ = at_ + (way / left) * rest;
      drag(hands, clay);
      return;
    }
    way -= left;
    at_ = to;
    ++next_;
    drag(hands, clay);
  }
  if (next_ >= stroke_->path.size()) waits_ = kRest;
}

void GhostFinger::stop(PointerLead& hands) {
  if (!stroke_) return;
  stroke_.reset();
  hands.lift();
}

}  // namespace onggi::device
