#include "engine/effects/slump.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kGravity = 9.81;
constexpr double kRoot3 = 1.7320508075688772;
constexpr double kSweep = 0.025;       // s: one down, one up, 20 times a second
constexpr int kElementBudget = 32768;  // a tick, on the finest grids
constexpr double kMostStrain = 0.1;    // a sweep: a fall takes a few of them
constexpr double kLeastStrain = 1e-6;  // a sweep: what yields less, stands
constexpr double kWheelStirs = 0.2;    // rad/s
constexpr double kWaterStirs = 0.01;

// Mean radius of the wall's middle, from eight places round the row.
double middle_of(const Clay& clay, int j) {
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

namespace effects {

// What the row would do if it stood alone.
Slump::Flow Slump::wanted(const SlumpDef& def, const Clay& clay, const Volume& volume,
                          const Around& around, int j) const noexcept {
  const double area = clay.areas()->of(j);
  const double load = def.density * kGravity * (above_ + 0.5 * volume.of_row(j));
  const double weight = load / area;
  double hoop = 0.0;
  if (around.wheel_speed != 0.0 && j >= clay.floor_rows()) {
    const double rim_speed = around.wheel_speed * middle_of(clay, j);
    hoop = def.density * rim_speed * rim_speed;
  }
  const double weak =
      around.moisture != nullptr ? strength(*around.moisture_def, around.moisture->of_row(j)) : 1.0;
  const double yield = kRoot3 * def.yield_stress * weak;
  const double over = weight + hoop - yield;
  if (over <= 0.0) return {};

  // Flow as the deviator of the two stresses (Levy and Mises): under weight alone the ring becomes
  // wider and thicker alike; a hoop's pull makes it wider and thinner.
  const double rate = over / (3.0 * def.viscosity * weak);
  const double both = 2.0 * (weight + hoop);
  const double shorter = (2.0 * weight + hoop) / both * rate * seconds_;
  double strain = std::min(shorter, kMostStrain);
  // As the row widens, the weight on it spreads: it stops where that carries, and never beyond.
  if (hoop < yield) strain = std::min(strain, portable::log(weight / (yield - hoop)));
  if (strain <= kLeastStrain) return {};
  const double share = strain / (2.0 * weight + hoop);
  return {(2.0 * hoop + weight) * share, (weight - hoop) * share};
}

// A ring of a shell drags its neighbours along over sqrt(R t) (Timoshenko & Woinowsky-Krieger,
// chapter 15: within a fifth of it), and the row's area is 2 pi R t. Down and up again, the share
// falls with distance alike on both sides.
const Slump::Flow& Slump::share(const Clay& clay, int j, const Flow& next) noexcept {
  const double reach = std::sqrt(clay.areas()->of(j) / (2.0 * portable::kPi));
  const double part = clay.row_thickness(j) / (clay.row_thickness(j) + reach);
  shared_.girth += part * (next.girth - shared_.girth);
  shared_.thickness += part * (next.thickness - shared_.thickness);
  return shared_;
}

void Slump::begin(const Clay& clay) noexcept {
  sweep_ = Sweep::down;
  next_ = clay.rows() - 1;
  above_ = sunk_ = 0.0;
  seconds_ = gathered_;
  gathered_ = 0.0;
  yielded_ = stirred_ = false;
}

void Slump::end(const SlumpDef& def, const Clay& clay) noexcept {
  sweep_ = Sweep::ended;
  speed_ = seconds_ > 0.0 ? sunk_ / seconds_ : 0.0;
  sagged_ = sagged_ * portable::exp(-seconds_ / kFallTime) + sunk_;
  const double fall = def.fall * (clay.rim_height() + sagged_);
  fallen_ = fallen_ || sagged_ > fall;
  stands_ = sagged_ < 0.1 * fall;
  asleep_ = !yielded_ && !stirred_;
  if (asleep_) gathered_ = 0.0;
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
  if (sweep_ == Sweep::ended) begin(clay);
  const double share_of_rows = std::ceil(clay.rows() * around.seconds / kSweep);
  int rows = std::min(static_cast<int>(share_of_rows), std::max(1, kElementBudget / clay.stride()));
  for (; rows > 0 && next_ >= 0 && sweep_ == Sweep::down; --rows, --next_) {
    const Flow alone = wanted(def, clay, volume, around, next_);
    yielded_ = yielded_ || alone.shorter() > 0.0;
    if (next_ == clay.rows() - 1) shared_ = alone;
    flow_[static_cast<std::size_t>(next_)] = share(clay, next_, alone);
    above_ += volume.of_row(next_);
  }
  if (sweep_ == Sweep::down && next_ < 0) {
    if (!yielded_) return end(def, clay);
    sweep_ = Sweep::up;
    next_ = 0;
    shared_ = flow_.front();
  }
  for (; rows > 0 && next_ < clay.rows() && sweep_ == Sweep::up; --rows, ++next_) {
    const Flow flow = share(clay, next_, flow_[static_cast<std::size_t>(next_)]);
    if (flow.shorter() <= kLeastStrain) continue;
    const double wider =
        reshape_row(clay, next_, portable::exp(flow.girth), portable::exp(flow.thickness));
    sunk_ += clay.row_thickness(next_) * (1.0 - 1.0 / wider);
  }
  if (next_ < clay.rows()) return;
  yielded_ = sunk_ > kLeastStrain * clay.row_thickness(0);
  end(def, clay);
}

void Slump::forget_fall() noexcept {
  sagged_ = 0.0;
  fallen_ = false;
  stands_ = true;
  sweep_ = Sweep::ended;
  gathered_ = 0.0;
}

void Slump::add_to(StateHash& hash) const {
  for (const Flow& flow : flow_)
    for (const double v : {flow.girth, flow.thickness}) hash.add(v);
  for (const double v : {shared_.girth, shared_.thickness, above_, seconds_, gathered_, sunk_,
                         speed_, calm_speed_, calm_wetness_, sagged_})
    hash.add(v);
  hash.add(static_cast<std::uint64_t>(next_ + 1) << 7 | static_cast<std::uint64_t>(sweep_) << 5 |
           std::uint64_t{fallen_} << 4 | std::uint64_t{stands_} << 3 |
           std::uint64_t{yielded_} << 2 | std::uint64_t{stirred_} << 1 | std::uint64_t{asleep_});
}

}  // namespace effects
}  // namespace onggi
