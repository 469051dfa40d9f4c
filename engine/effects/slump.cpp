#include "engine/effects/slump.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/effects/effect_list.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kGravity = 9.81;
constexpr double kRoot3 = 1.7320508075688772;
constexpr double kSweep = 0.025;       // s: one down, one up, 20 times a second
constexpr double kMostStrain = 0.1;    // per sweep: a fall takes a few sweeps
constexpr double kStands = 1e-6;       // share: a row overloaded by less counts as standing
constexpr double kLeastStrain = 3e-6;  // smallest strain worth moving: a float radius resolves 6e-8
constexpr double kRounded = 0.1;       // share of a strain: a larger remainder is not rounding
constexpr double kNearest = 1e-3;      // of a row's height
constexpr double kWheelStirs = 0.2;    // rad/s
constexpr double kWaterStirs = 0.01;

double seconds_up(const Clay& clay) {
  return effects::Round::lasting(kSweep, 1.0 * clay.rows() * clay.stride());
}

// Of a turning row, the mean pull across a cut through the axis, over density omega^2, m^2: what
// holds its halves together, whatever the clay's law. (Ro^2 + Ro Ri + Ri^2) / 3, from eight places
// round the row.
double pull_of(const Clay& clay, int j) {
  constexpr int kPlaces = 8;
  if (j < clay.floor_rows()) return clay.areas()->of(j) / (3.0 * portable::kPi);
  double sum = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const auto i = static_cast<std::size_t>(k * clay.sectors() / kPlaces);
    const double outer = double{clay.outer(j)[i]}, inner = double{clay.inner(j)[i]};
    sum += outer * outer + outer * inner + inner * inner;
  }
  return sum / (3.0 * kPlaces);
}

// log(1 + x), x >= 0, without cancellation: four terms of its series, relative error 1e-14.
double log_1_plus(double x) {
  return x < 1e-3 ? x * (1.0 - x * (0.5 - x * (1.0 / 3.0 - 0.25 * x))) : portable::log(1.0 + x);
}

}  // namespace

std::span<const DefField<SlumpDef>> SlumpDef::fields() {
  static constexpr DefField<SlumpDef> kFields[] = {
      {"yield_stress", &SlumpDef::yield_stress, 100.0, 1e6, "Pa"},
      {"viscosity", &SlumpDef::viscosity, 10.0, 1e8, "Pa s"},
      {"density", &SlumpDef::density, 500.0, 4000.0, "kg/m^3"},
      {"fall", &SlumpDef::fall, 0.01, 0.9, ""},
  };
  return kFields;
}

namespace effects {

// The row's flow if it stood alone.
Slump::Ring Slump::flow_alone(const SlumpDef& def, const Clay& clay, const Volume& volume,
                              const Around& around, int j) const noexcept {
  const double area = clay.areas()->of(j);
  const double load = def.density * kGravity * (above_ + 0.5 * volume.of_row(j));
  const double weight = load / area;
  const bool solid = j < clay.floor_rows();
  const double hoop = def.density * around.wheel_speed * around.wheel_speed * pull_of(clay, j);
  const double weak = around.moisture != nullptr
                          ? strength(*around.moisture_def, around.moisture->of_row(clay.stored(j)))
                          : 1.0;
  const double joined = around.building != nullptr
                            ? around.building->strength(*around.building_def, clay.stored(j))
                            : 1.0;
  const double yield = kRoot3 * def.yield_stress * weak * joined;
  const double over = weight + hoop - yield;
  if (over <= 0.0) return {{}, 0.0, over / yield};

  // Flow follows the deviator of the two stresses (Levy-Mises). Weight alone makes the ring wider
  // and thicker alike; a hoop's pull makes it wider and thinner. A disc is pulled alike in all
  // directions of its plane, and only becomes wider.
  const double rate = over / (3.0 * def.viscosity * weak);
  const double ways = solid ? 1.0 : (2.0 * weight + hoop) / (2.0 * (weight + hoop));
  double strain = ways * rate * seconds_;
  double room = kMostStrain;
  if (hoop < yield) {
    // As the row widens, the weight w on it spreads: w' = -ways w (w - bears) / 3 eta. The
    // unsupported share f = 1 - bears / w falls at an even rate. The row stops where it carries its
    // load, never beyond.
    const double bears = yield - hoop;
    const double share = over / weight;
    if (share <= kStands) return {{}, 0.0, -share};
    const double falls = -portable::expm1(-ways * bears * seconds_ / (3.0 * def.viscosity * weak));
    strain = log_1_plus(share * falls * weight / bears);
    room = log_1_plus(over / bears);
  }
  strain = std::min(strain, kMostStrain);
  if (solid) return {{0.5 * strain, 0.5 * strain}, 0.0, room};
  const double each = strain / (2.0 * weight + hoop);
  return {{(2.0 * hoop + weight) * each, (weight - hoop) * each}, 0.0, room};
}

// A ring of a shell is coupled to its neighbours over sqrt(R t) (Timoshenko & Woinowsky-Krieger,
// chapter 15: within a fifth of it), and the row's area is 2 pi R t. e is the row's flow and f its
// flow alone. Between rows that yield, e - R t e'' = f. A row that stands does not flow, and holds
// its neighbours. Where a wall ends (rim, floor, wheel head), e = f, so an even rise of f is
// unchanged. Independent of the grid. This is the downward half of Thomas' algorithm.
Slump::Ring Slump::coupled(Clay& clay, int j, Ring ring) const noexcept {
  if (ring.room <= 0.0) return ring;
  const int foot = clay.floor_rows();
  if (j <= foot || j + 1 >= clay.rows()) return ring;
  const auto hangs = [&](int lower) {
    const double both = known_area(clay, lower) + clay.areas()->of(lower + 1);
    const double apart = 0.5 * (clay.row_thickness(lower) + clay.row_thickness(lower + 1));
    return both / (4.0 * portable::kPi * apart);
  };
  const Ring& above = ring_[static_cast<std::size_t>(j + 1)];
  // The spare strength of a standing row shows how near to this row the clay begins to stand.
  const double beyond = above.room > 0.0 ? 1.0 : ring.room / (ring.room - above.room);
  const double up = hangs(j) / std::max(beyond, kNearest), down = hangs(j - 1);
  const double own = clay.row_thickness(j);
  const double part = 1.0 / (own + up * (1.0 - above.below) + down);
  ring.flow = {part * (own * ring.flow.girth + up * above.flow.girth),
               part * (own * ring.flow.thickness + up * above.flow.thickness)};
  ring.below = part * down;
  return ring;
}

bool Slump::wanted(const Effects& def) { return def.slump.has_value(); }

void Slump::run(const StageWork& work) noexcept {
  const MoistureDef* moisture = work.def.moisture ? &*work.def.moisture : nullptr;
  const RowTick& tick = work.tick;
  sink(*work.def.slump, work.clay, *work.volume,
       {tick.moisture, moisture, tick.wheel_speed, tick.seconds, tick.touched || work.laid,
        work.building, work.def.building ? &*work.def.building : nullptr});
}

void Slump::begin(const Clay& clay) noexcept {
  sweep_ = Sweep::down;
  round_.begin();
  next_ = clay.rows() - 1;
  above_ = sunk_ = 0.0;
  seconds_ = kSweep + seconds_up(clay);
  yielded_ = stirred_ = false;
}

void Slump::sweep_down(const SlumpDef& def, Clay& clay, const Volume& volume, const Around& around,
                       int till) noexcept {
  for (; clay.rows() - 1 - next_ < till; --next_) {
    known_area(clay, next_);  // another effect may have moved the row since it was measured
    const Ring ring = flow_alone(def, clay, volume, around, next_);
    yielded_ = yielded_ || ring.room > 0.0;
    ring_[static_cast<std::size_t>(next_)] = coupled(clay, next_, ring);
    above_ += volume.of_row(next_);
  }
}

void Slump::sweep_up(Clay& clay, int till) noexcept {
  for (; next_ < till; ++next_) {
    const Ring& ring = ring_[static_cast<std::size_t>(next_)];
    Flow flow = {ring.flow.girth + ring.below * passed_.girth,
                 ring.flow.thickness + ring.below * passed_.thickness};
    passed_ = flow;
    if (!(flow.shorter() > 0.0)) continue;
    // Neighbours with farther to go do not take a row beyond where it stands.
    const double part = std::min(1.0, ring.room / flow.shorter());
    flow = {part * flow.girth, part * flow.thickness};
    sunk_ += clay.row_thickness(next_) * -portable::expm1(-flow.shorter());
    move(clay, next_, flow);
  }
}

void Slump::move(Clay& clay, int j, const Flow& flow) noexcept {
  Flow& owed = owed_[static_cast<std::size_t>(j)];
  owed.girth += flow.girth;
  owed.thickness += flow.thickness;
  const double asked = owed.shorter();
  if (asked < kLeastStrain) return;
  known_area(clay, j);
  const double wider =
      reshape_row(clay, j, portable::exp(owed.girth), portable::exp(owed.thickness));
  // What floats rounded off stays owed. What the clay's limits prevented is forgotten.
  const double left = (asked - portable::log(wider)) / asked;
  const double keep = std::fabs(left) < kRounded ? left : 0.0;
  owed = {keep * owed.girth, keep * owed.thickness};
}

void Slump::end(const SlumpDef& def, const Clay& clay) noexcept {
  sweep_ = Sweep::ended;
  speed_ = sunk_ / seconds_;
  sagged_ = sagged_ * portable::exp(-seconds_ / kFallTime) + sunk_;
  const double fall = def.fall * (clay.rim_height() + sagged_);
  fallen_ = fallen_ || sagged_ > fall;
  stands_ = sagged_ < 0.1 * fall;
  asleep_ = !yielded_ && !stirred_;
}

void Slump::sink(const SlumpDef& def, Clay& clay, Volume& volume, const Around& around) noexcept {
  const double wetness = around.moisture != nullptr ? around.moisture->mean() : 0.0;
  const double soaked = around.moisture != nullptr ? around.moisture->soaked() : 0.0;
  const bool stirred = around.touched ||
                       std::fabs(around.wheel_speed - calm_speed_) > kWheelStirs ||
                       std::fabs(wetness - calm_wetness_) > kWaterStirs ||
                       std::fabs(soaked - calm_soaked_) > kWaterStirs;
  if (asleep_ && !stirred) return;
  asleep_ = false;
  if (stirred) {
    stirred_ = true;
    calm_speed_ = around.wheel_speed;
    calm_wetness_ = wetness;
    calm_soaked_ = soaked;
  }
  for (double left = around.seconds; left > 0.0 && !asleep_;) {
    if (sweep_ == Sweep::ended) begin(clay);
    if (sweep_ == Sweep::down) {
      sweep_down(def, clay, volume, around, round_.go_on(left, kSweep, clay.rows()));
      if (!round_.over()) return;
      if (!yielded_) {
        seconds_ = kSweep;
        end(def, clay);
        continue;
      }
      sweep_ = Sweep::up;
      round_.begin();
      next_ = 0;
      passed_ = {};
    }
    sweep_up(clay, round_.go_on(left, seconds_up(clay), clay.rows()));
    if (round_.over()) end(def, clay);
  }
}

// A sweep under way passes the new row by; the next one weighs it.
void Slump::row_added(const Clay&, const RowAdded& added) noexcept {
  ring_[static_cast<std::size_t>(added.row)] = {};
  owed_[static_cast<std::size_t>(added.row)] = {};
  asleep_ = false;
}

// The sweep continues where it was, between the same rows.
void Slump::row_divided(const Clay&, const RowDivided& divided) noexcept {
  const int j = divided.row;
  clay::open_place(ring_, j + 1, ring_[static_cast<std::size_t>(j)]);
  clay::open_place(owed_, j + 1, owed_[static_cast<std::size_t>(j)]);
  if (sweep_ == Sweep::down ? j <= next_ : j < next_) ++next_;
}

void Slump::rows_joined(const Clay&, const RowsJoined& joined) noexcept {
  const int j = joined.row;
  clay::close_place(ring_, j + 1);
  clay::close_place(owed_, j + 1);
  if (sweep_ == Sweep::down && j == next_)
    above_ -= joined.upper;  // it is weighed again, together with the lower row
  if (j + 1 <= (sweep_ == Sweep::down ? next_ : next_ - 1)) --next_;
}

void Slump::forget(Clay&, const Laid&) noexcept {
  sagged_ = 0.0;
  fallen_ = false;
  stands_ = true;
  sweep_ = Sweep::ended;
  std::ranges::fill(owed_, Flow{});
}

void Slump::add_to(StateHash& hash, const Clay& clay) const {
  const auto rows = static_cast<std::size_t>(clay.rows());
  for (const Ring& ring : std::span(ring_).first(rows))
    for (const double v : {ring.flow.girth, ring.flow.thickness, ring.below, ring.room})
      hash.add(v);
  for (const Flow& flow : std::span(owed_).first(rows))
    for (const double v : {flow.girth, flow.thickness}) hash.add(v);
  for (const double v : {passed_.girth, passed_.thickness, above_, seconds_, sunk_, speed_,
                         calm_speed_, calm_wetness_, calm_soaked_, sagged_})
    hash.add(v);
  round_.add_to(hash);
  hash.add(static_cast<std::uint64_t>(next_ + 1) << 7 | static_cast<std::uint64_t>(sweep_) << 5 |
           std::uint64_t{fallen_} << 4 | std::uint64_t{stands_} << 3 |
           std::uint64_t{yielded_} << 2 | std::uint64_t{stirred_} << 1 | std::uint64_t{asleep_});
}

}  // namespace effects
}  // namespace onggi
