#include "engine/surface/station.h"

#include <algorithm>
#include <cmath>

namespace onggi::surface {

namespace {

std::uint16_t as_share(double value) {
  return static_cast<std::uint16_t>(std::clamp(value, 0.0, 1.0) * kWhole + 0.5);
}

HandPlace between(const HandPlace& a, const HandPlace& b, double t) {
  return {a.along + t * (b.along - a.along), a.turns + t * (b.turns - a.turns),
          a.pressure + t * (b.pressure - a.pressure), a.age + t * (b.age - a.age)};
}

}  // namespace

void Tracer::put(const HandPlace& at, double across_along, double across_round) {
  Station station;
  station.along = static_cast<std::int32_t>(std::floor(at.along * 1e6));
  station.round = static_cast<std::int32_t>(std::floor(at.turns * kTurn));
  station.across_along = static_cast<std::int16_t>(std::floor(across_along * kUnit + 0.5));
  station.across_round = static_cast<std::int16_t>(std::floor(across_round * kUnit + 0.5));
  station.pressure = as_share(at.pressure);
  station.load = as_share(1.0 - gone_ / reach_);
  station.age = static_cast<std::uint32_t>(std::clamp(at.age, 0.0, 1e6) * 1e3);
  stations_.push_back(station);
}

void Tracer::go(const HandPlace& place) {
  HandPlace to = place;
  to.along = std::clamp(to.along, 0.0, surface_->rows() * kRowHeight * 1e-6);
  to.turns = std::clamp(to.turns, -1e3, 1e3);
  if (!began_) {
    began_ = true;
    last_ = to;
    return;
  }
  const double middle = 0.5 * (last_.along + to.along) * 1e6 / kRowHeight;
  const int row = std::clamp(static_cast<int>(middle), 0, surface_->rows() - 1);
  const double girth = surface_->row(row).width * 1e-9 * kSectors;
  const double up = to.along - last_.along, on = (to.turns - last_.turns) * girth;
  const double way = std::sqrt(up * up + on * on);
  if (!(way > 0.0)) {
    last_ = to;
    return;
  }
  across_along_ = -on / way;
  across_round_ = up / way;
  if (stations_.empty()) put(last_, across_along_, across_round_);
  double done = 0.0;
  const double before = gone_;
  while (kStationWay - since_ <= way - done) {
    done += kStationWay - since_;
    since_ = 0.0;
    gone_ = before + done;
    put(between(last_, to, done / way), across_along_, across_round_);
  }
  since_ += way - done;
  gone_ = before + way;
  last_ = to;
}

void Tracer::lift() {
  if (!began_ || (!stations_.empty() && !(since_ > 0.0))) return;
  put(last_, across_along_, across_round_);
  since_ = 0.0;
}

}  // namespace onggi::surface
