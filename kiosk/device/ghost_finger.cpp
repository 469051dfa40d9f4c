#include "kiosk/device/ghost_finger.h"

#include <utility>

namespace onggi::device {

void GhostFinger::begin(Stroke stroke, double sign, PointerLead& hands, const ClayView& clay) {
  if (stroke.path.empty()) return;
  stroke_ = std::move(stroke);
  sign_ = sign;
  waits_ = kRest;
  next_ = 1;
  at_ = stroke_->path.front();
  hands.lift();
  hands.grab({sign_ * at_.x, at_.y}, clay, stroke_->grip);
}

void GhostFinger::draw(double dt, PointerLead& hands) {
  if (!stroke_) return;
  if (waits_ > 0) {
    waits_ -= dt;
    if (waits_ > 0 || next_ < stroke_->path.size()) return;
    hands.release();
    stroke_.reset();
    return;
  }
  double way = stroke_->speed * dt;
  while (next_ < stroke_->path.size() && way > 0) {
    const Vec2 to = stroke_->path[next_], rest = to - at_;
    const double left = length(rest);
    if (left > way) {
      at_ = at_ + (way / left) * rest;
      hands.drag({sign_ * at_.x, at_.y});
      return;
    }
    way -= left;
    at_ = to;
    ++next_;
    hands.drag({sign_ * at_.x, at_.y});
  }
  if (next_ >= stroke_->path.size()) waits_ = kRest;
}

void GhostFinger::stop(PointerLead& hands) {
  if (!stroke_) return;
  stroke_.reset();
  hands.lift();
}

}  // namespace onggi::device
