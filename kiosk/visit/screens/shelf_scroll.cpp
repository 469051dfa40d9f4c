#include "kiosk/visit/screens/shelf_scroll.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

namespace {
constexpr double kBeyond = 1.0 / 3;  // share of the finger's motion, beyond the ends
// s: after release it travels as far as its speed would in this time
constexpr double kRunsOn = 0.25;
constexpr double kFlick = 1.0;    // columns/s: a faster release is a flick, however short
constexpr double kSettle = 0.16;  // s
constexpr double kThere = 0.003;  // columns: an invisible rest
}  // namespace

int ShelfScroll::within(double column) const {
  return static_cast<int>(std::lround(std::clamp(column, 0.0, static_cast<double>(last()))));
}

void ShelfScroll::bound(int columns, int shown) {
  columns_ = std::max(1, columns);
  shown_ = std::max(1, shown);
  if (held_) return;
  const int to = within(to_);
  if (to != to_) at_ = to_ = to;
}

void ShelfScroll::hold() { held_ = true; }

void ShelfScroll::drag(double columns) {
  const bool beyond = (at_ < 0 && columns < 0) || (at_ > last() && columns > 0);
  at_ += beyond ? kBeyond * columns : columns;
}

void ShelfScroll::release(double speed) {
  held_ = false;
  to_ = within(at_ + kRunsOn * speed);
  if (std::abs(speed) < kFlick) return;
  // A flick that ends within half a column still moves the shelf by one.
  const int onward = within(speed > 0 ? std::floor(at_) + 1 : std::ceil(at_) - 1);
  to_ = speed > 0 ? std::max(to_, onward) : std::min(to_, onward);
}

void ShelfScroll::step(int columns) {
  held_ = false;
  to_ = within(to_ + columns);
}

void ShelfScroll::show(int column) {
  held_ = false;
  if (column < to_) to_ = within(column);
  if (column >= to_ + shown_) to_ = within(column - shown_ + 1);
  at_ = to_;
}

void ShelfScroll::update(double dt, bool still) {
  if (held_) return;
  at_ = still ? to_ : to_ + (at_ - to_) * std::exp(-std::max(0.0, dt) / kSettle);
  if (std::abs(at_ - to_) < kThere) at_ = to_;
}

}  // namespace onggi::screens
