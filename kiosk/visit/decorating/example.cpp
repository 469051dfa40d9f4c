#include "kiosk/visit/decorating/example.h"

#include <algorithm>
#include <cmath>

namespace onggi::decorating {

using decoration::WayTool;

namespace {

constexpr double kComes = 0.6;     // s until the finger touches
constexpr double kOnThePot = 1.8;  // s on it,
constexpr double kGoes = 0.4;      // and until it is gone
constexpr double kSeen = 1.2;      // s that the result stands
// Shares of the outside: where a tool shows itself.
constexpr double kRing = 0.7, kFigure = 0.56, kLineFrom = 0.36, kLineTo = 0.6, kUp = 0.62;
constexpr double kSwing = 0.03;  // turns that a line swings to either side

double eased(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

void Example::begin(DecoratedPot& pot) {
  stop(pot);
  if (pot.waits(pot.tool())) return;
  pot.begin_example();
  since_ = 0.0;
}

void Example::stop(DecoratedPot& pot) {
  if (!shows()) return;
  pot.end_example();
  *this = {};
}

/// Where the finger is after a share of its time on the pot.
Place Example::place(double share, double front, const DecoratedPot& pot) const {
  const double whole = pot.outside();
  switch (pot.held().hand) {
    case WayTool::ring:
      return {kRing * whole, front};
    case WayTool::line:
      // As a leaf of grass.
      return {(kLineFrom + (kLineTo - kLineFrom) * eased(share)) * whole,
              front + kSwing * std::sin(6.283185307179586 * eased(share))};
    case WayTool::up:
      return {kUp * whole, front};
    case WayTool::figure:
    case WayTool::all:
      break;
  }
  return {kFigure * whole, front};
}

void Example::step(double dt, double front, DecoratedPot& pot) {
  if (!shows()) return;
  since_ += dt;
  const double on = since_ - kComes, share = on / kOnThePot;
  const Place at = place(std::clamp(share, 0.0, 1.0), front, pot);
  if (on < 0.0) {
    finger_ = Finger{at, 1.0 - eased(since_ / kComes)};
    return;
  }
  if (!down_) {
    down_ = true;
    pot.press(at);
  }
  if (!lifted_) pot.move(at);
  if (share >= 1.0 && !lifted_) {
    lifted_ = true;
    pot.lift();
  }
  const double gone = (on - kOnThePot) / kGoes;
  finger_.reset();
  if (gone < 1.0) finger_ = Finger{at, eased(gone)};
  if (!lifted_) return;
  if (!pot.busy() && stands_since_ < 0.0) stands_since_ = since_;
  const bool seen = stands_since_ >= 0.0 && since_ - stands_since_ > kSeen;
  if (seen || since_ > kLongest) stop(pot);
}

}  // namespace onggi::decorating
