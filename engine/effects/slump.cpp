#include "engine/effects/slump.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kGravity = 9.81;
constexpr double kRoot3 = 1.7320508075688772;
constexpr double kSweep = 0.025;       // s: 40 sweeps a second
constexpr int kElementBudget = 32768;  // a tick, on the finest grids
constexpr double kMostStrain = 0.1;    // a sweep: a fall takes a few of them
constexpr double kLeastStrain = 1e-6;  // a sweep: what yields less, stands
constexpr double kWheelStirs = 0.2;    // rad/s
constexpr double kWaterStirs = 0.01;

// Mean radius of the wall's middle, from eight places round the row.
double radius_of(const Clay& clay, int j) {
  constexpr int kPlaces = 8;
  double sum = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const auto i = static_cast<std::size_t>(k * clay.sectors() / kPlaces);
    sum += double{clay.outer(j)[i] + clay.inner(j)[i]};
  }
  return 0.5 * sum / kPlaces;
}

}  // namespace

std::span<const EffectField<SlumpDef>> SlumpDef::fields() {
  static constexpr EffectField<SlumpDef> kFields[] = {
      {"yield_stress", &SlumpDef::yield_stress, 100.0, 1e6, "Pa"},
      {"viscosity", &SlumpDef::viscosity, 10.0, 1e8, "Pa s"},
      {"density", &SlumpDef::density, 500.0, 4000.0, "kg/m^3"},
      {"fall", &SlumpDef::fall, 0.01, 0.9, ""},
  };
  return kFields;
}

double standing_height(const SlumpDef& def) noexcept {
  return kRoot3 * def.yield_stress / (def.density * kGravity);
}

bool Slump::sink_row(const SlumpDef& def, Clay& clay, Volume& volume, const Around& around, int j,
                     double above) noexcept {
  const double area = clay.areas()->of(j);
  const double load = def.density * kGravity * (above + 0.5 * volume.of_row(j));
  const double weight = load / area;
  double hoop = 0.0;
  if (around.wheel_speed != 0.0 && j >= clay.floor_rows()) {
    const double rim_speed = around.wheel_speed * radius_of(clay, j);
    hoop = def.density * rim_speed * rim_speed;
  }
  const double weak =
      around.moisture != nullptr ? strength(*around.moisture_def, around.moisture->of_row(j)) : 1.0;
  const double yield = kRoot3 * def.yield_stress * weak;
  const double over = weight + hoop - yield;
  if (over <= 0.0) return false;

  // Flow as the deviator of the two stresses (Levy and Mises): under weight alone the ring becomes
  // wider and thicker alike; a hoop's pull makes it wider and thinner.
  const double rate = over / (3.0 * def.viscosity * weak);
  const double both = 2.0 * (weight + hoop);
  const double shorter = (2.0 * weight + hoop) / both * rate * seconds_;
  double strain = std::min(shorter, kMostStrain);
  // As the row widens, the weight on it spreads: it stops where that carries, and never beyond.
  if (hoop < yield) strain = std::min(strain, portable::log(weight / (yield - hoop)));
  if (strain <= kLeastStrain) return false;
  const double share = strain / (2.0 * weight + hoop);
  const double girth = portable::exp((2.0 * hoop + weight) * share);
  const double thickness = portable::exp((weight - hoop) * share);
  const double wider = reshape_row(clay, j, girth, thickness);
  sunk_ += clay.row_thickness(j) * (1.0 - 1.0 / wider);
  return wider > 1.0 + kLeastStrain;
}

void Slump::sink(const SlumpDef& def, Clay& clay, Volume& volume, const Around& around) noexcept {
  const double wetness = around.moisture != nullptr ? around.moisture->mean() : 0.0;
  const bool stirred = around.touched ||
                       std::fabs(around.wheel_speed - calm_speed_) > kWheelStirs ||
                       std::fabs(wetness - calm_wetness_) > kWaterStirs;
  if (asleep_ && !stirred) return;
  asleep_ = false;
  if (stirred) {
    stirred_ = true;
    calm_speed_ = around.wheel_speed;
    calm_wetness_ = wetness;
  }
  gathered_ += around.seconds;
  if (next_ < 0) {
    next_ = clay.rows() - 1;
    above_ = sunk_ = 0.0;
    seconds_ = gathered_;
    gathered_ = 0.0;
    yielded_ = stirred_ = false;
  }
  const double share = std::ceil(clay.rows() * around.seconds / kSweep);
  const int most = std::max(1, kElementBudget / clay.stride());
  const int end = std::max(-1, next_ - std::min(static_cast<int>(share), most));
  for (; next_ > end; --next_) {
    if (sink_row(def, clay, volume, around, next_, above_)) yielded_ = true;
    above_ += volume.of_row(next_);
  }
  if (next_ >= 0) return;
  speed_ = seconds_ > 0.0 ? sunk_ / seconds_ : 0.0;
  sagged_ = sagged_ * portable::exp(-seconds_ / kFallTime) + sunk_;
  const double fall = def.fall * (clay.rim_height() + sagged_);
  fallen_ = fallen_ || sagged_ > fall;
  stands_ = sagged_ < 0.1 * fall;
  asleep_ = !yielded_ && !stirred_;
  if (asleep_) gathered_ = 0.0;
}

void Slump::forget_fall() noexcept {
  sagged_ = 0.0;
  fallen_ = false;
  stands_ = true;
}

void Slump::add_to(StateHash& hash) const {
  for (const double v :
       {above_, seconds_, gathered_, sunk_, speed_, calm_speed_, calm_wetness_, sagged_})
    hash.add(v);
  hash.add(static_cast<std::uint64_t>(next_ + 1) << 5 | std::uint64_t{fallen_} << 4 |
           std::uint64_t{stands_} << 3 | std::uint64_t{yielded_} << 2 |
           std::uint64_t{stirred_} << 1 | std::uint64_t{asleep_});
}

}  // namespace onggi
