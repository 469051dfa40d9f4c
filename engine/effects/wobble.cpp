#include "engine/effects/wobble.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/effects/effect_list.h"
#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kRound = 0.02;  // s
constexpr double kLeastShare =
    2e-5;                         // share of the offset: a smaller one is below a float's digits
constexpr double kRest = 1e-6;    // m: closer counts as centred
constexpr double kStrip = 0.002;  // m: lower than the part of a tool that touches
constexpr double kAside = 1e-7;   // m: keeps rounding from deciding a row's strip
constexpr double kTurn = 0.001;   // s
constexpr double kGolden = 0.6180339887498949;

// The face of a circle of `radius` centred on (off, 0), along the ray with this cosine and sine.
double circle_along(double radius, double off, double cosine, double sine) {
  const double beside = off * sine;
  return off * cosine + std::sqrt(std::max((radius - beside) * (radius + beside), 0.0));
}

// The nearest of kDirections compass directions to a unit vector.
std::size_t direction_of(double x, double z) {
  constexpr double kTan[] = {0.198912367379658, 0.668178637919299};  // of 11.25 and 33.75 degrees
  const double ax = std::fabs(x);
  const double az = std::fabs(z);
  const double low = std::min(ax, az);
  const double high = std::max(ax, az);
  std::size_t octant = low > kTan[1] * high ? 2 : low > kTan[0] * high ? 1 : 0;  // from the axis
  if (az > ax) octant = 4 - octant;
  if (x < 0.0) octant = 8 - octant;
  if (z < 0.0) octant = 16 - octant;
  return octant % 16;
}

std::size_t slot(int k) { return static_cast<std::size_t>(k); }

// Sets both faces of row `j` to face(ray, radius), within the clay's limits.
template <class Face>
void shape_row(Clay& clay, int j, const Face& face) {
  const ClayDef& def = clay.def();
  const bool hollow = j >= clay.floor_rows();
  const auto least = static_cast<float>(def.radius_min);
  const auto most = static_cast<float>(def.radius_max);
  const auto wall = static_cast<float>(def.wall_min);
  const std::span<float> outer = clay.pressable_outer(j);
  const std::span<float> inner = clay.pressable_inner(j);
  float out_most = 0.0f;
  float in_least = 1e9f;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const double c = double{clay.ray_cos()[i]};
    const double s = double{clay.ray_sin()[i]};
    if (hollow)
      inner[i] = std::clamp(static_cast<float>(face(c, s, double{inner[i]})), least, most - wall);
    // A solid row keeps room for a hole that may be opened later.
    const float hole = hollow ? inner[i] : least;
    outer[i] = std::clamp(static_cast<float>(face(c, s, double{outer[i]})), hole + wall, most);
    out_most = std::max(out_most, outer[i]);
    in_least = std::min(in_least, inner[i]);
  }
  clay.set_extent(j, out_most, in_least);
  if (clay.areas() != nullptr) clay.areas()->forget(j);
  clay.mark_dirty(j);
}

}  // namespace

std::span<const DefField<WobbleDef>> WobbleDef::fields() {
  static constexpr DefField<WobbleDef> kFields[] = {
      {"off_centre", &WobbleDef::off_centre, 0.0, 0.03, "m"},
      {"centring_time", &WobbleDef::centring_time, 0.002, 60.0, "s"},
      {"reach", &WobbleDef::reach, 0.001, 1.0, "m"},
  };
  return kFields;
}

namespace effects {

OffCentre off_centre_of(const Clay& clay, int j) noexcept {
  const row_kernels::Harmonic sum = row_kernels::of(clay.vectors())
                                        .harmonic(clay.stride(), clay.outer(j).data(),
                                                  clay.ray_cos().data(), clay.ray_sin().data());
  const double each = 2.0 / clay.sectors();
  return {each * double{sum.x}, each * double{sum.z}};
}

void lay_off_centre(Clay& clay, int j, OffCentre off) noexcept {
  const double away = std::sqrt(off.x * off.x + off.z * off.z);
  if (away == 0.0) return;
  const double ux = off.x / away;
  const double uz = off.z / away;
  shape_row(clay, j, [&](double c, double s, double radius) {
    return circle_along(radius, away, c * ux + s * uz, s * ux - c * uz);
  });
}

bool Wobble::wanted(const Effects& def) { return def.wobble.has_value(); }

void Wobble::lay_row(const Effects& def, Clay& clay, int j) noexcept {
  lay_off_centre(clay, j, {def.wobble->off_centre, 0.0});
}

void Wobble::run(const StageWork& work) noexcept {
  for (std::size_t n = 0; n < kMostHands; ++n)
    if (const HandThere& hand = work.tick.hand[n]; hand.on_wall)
      press(n, {hand.at, hand.normal, hand.side}, work.tick.seconds);
  centre(*work.def.wobble, work.clay, work.tick.seconds);
}

void Wobble::press(std::size_t n, const CentringHand& hand, double seconds) noexcept {
  const double far = axis_distance(hand.at);
  if (hand.normal <= 0.0 || far <= 0.0) return;
  const double to = hand.side == WallSide::outside ? 1.0 / far : -1.0 / far;
  const double x = to * hand.at.x;
  const double z = to * hand.at.z;
  const double impulse = hand.normal * seconds;
  Gathered& gathered = sweeps_[n].next;
  // Kept apart by direction: a ring pushed all round is off to another side at each push.
  Push& push = gathered.push[direction_of(x, z)];
  push.x += x * impulse;
  push.z += z * impulse;
  push.impulse += impulse;
  gathered.impulse += impulse;
  gathered.raised += impulse * hand.at.y;
}

void Wobble::begin(const WobbleDef& def, const Clay& clay, Sweep& sweep) noexcept {
  sweep.now = std::exchange(sweep.next, {});
  sweep.height = sweep.now.raised / sweep.now.impulse;
  // Strips depend on heights alone, so that the grid does not decide when a row has its turn. Rows
  // and hands stand at round figures; the offset keeps rounding from deciding.
  const double low = std::max(sweep.height - def.reach, 0.0) + kAside;
  const double high = std::max(std::min(sweep.height + def.reach, clay.rim_height()) - low, 0.0);
  sweep.strips = std::clamp(static_cast<int>(high / kStrip), 1, kMostStrips);
  for (int k = 0; k <= sweep.strips; ++k)
    sweep.bound[slot(k)] = clay.first_row_above(low + high * k / sweep.strips);
  for (int k = 0; k < sweep.strips; ++k) sweep.edge[slot(k)] = sweep.bound[slot(k + k % 2)];
  sweep.round.begin();
}

void Wobble::centre_row(const WobbleDef& def, Clay& clay, const Sweep& sweep, int j) noexcept {
  const double apart = (clay.row_height(j) - sweep.height) / def.reach;
  const double fade = std::max(1.0 - apart * apart, 0.0);
  const OffCentre before = off_centre_of(clay, j);
  OffCentre off = before;
  for (const Push& push : sweep.now.push) {
    const double length = std::sqrt(push.x * push.x + push.z * push.z);
    if (length == 0.0) continue;
    const double beyond = (off.x * push.x + off.z * push.z) / length;
    if (beyond <= kRest) continue;
    const double share = -portable::expm1(-fade * push.impulse / def.centring_time);
    off.x -= beyond * share * push.x / length;
    off.z -= beyond * share * push.z / length;
  }
  if (off.x == before.x && off.z == before.z) return;
  const row_kernels::RowPush how{j >= clay.floor_rows(),
                                 static_cast<float>(off.x - before.x),
                                 static_cast<float>(off.z - before.z),
                                 static_cast<float>(clay.def().radius_min),
                                 static_cast<float>(clay.def().radius_max),
                                 static_cast<float>(clay.def().wall_min)};
  const row_kernels::FaceMoved moved =
      row_kernels::of(clay.vectors())
          .push(how, clay.stride(), clay.ray_cos().data(), clay.ray_sin().data(),
                clay.pressable_outer(j).data(), clay.pressable_inner(j).data());
  clay.set_extent(j, moved.outermost, moved.innermost);
  if (clay.areas() != nullptr) clay.areas()->forget(j);
  clay.mark_dirty(j);
}

void Wobble::centre(const WobbleDef& def, Clay& clay, double seconds) noexcept {
  for (double left = seconds; left > 0.0;) {
    if (beat_.over()) {
      beat_.begin();
      for (Sweep& sweep : sweeps_)
        if (sweep.round.over() && sweep.next.impulse >= kLeastShare * def.centring_time)
          begin(def, clay, sweep);
    }
    const double before = left;
    beat_.go_on(left, kRound, 1);
    for (Sweep& sweep : sweeps_) go_on(def, clay, sweep, before - left);
  }
}

void Wobble::go_on(const WobbleDef& def, Clay& clay, Sweep& sweep, double seconds) noexcept {
  if (sweep.round.over()) return;
  const int rows = sweep.bound[slot(sweep.strips)] - sweep.bound[0];
  const double whole = Round::lasting(kRound, 1.0 * rows * clay.stride());
  // Turns happen at whole milliseconds, whatever the tick.
  const int turns = static_cast<int>(whole / kTurn + 0.5);
  const double share = 1.0 * static_cast<int>(sweep.round.go_on(seconds, whole) * turns) / turns;
  for (int k = 0; k < sweep.strips; ++k) {
    const int from = sweep.bound[slot(k)], to = sweep.bound[slot(k + 1)];
    // Each strip starts at a different part of a row; else all would take their turns in one tick.
    const double ahead = kGolden * k - static_cast<int>(kGolden * k);
    const int done = share < 1.0 ? static_cast<int>(share * (to - from) + ahead) : to - from;
    int& edge = sweep.edge[slot(k)];
    if (k % 2 == 0) {
      for (; edge < from + done; ++edge) centre_row(def, clay, sweep, edge);
    } else {
      while (edge > to - done) centre_row(def, clay, sweep, --edge);
    }
  }
}

void Wobble::row_divided(const Clay&, const RowDivided& divided) noexcept {
  const int j = divided.row;
  for (Sweep& sweep : sweeps_) {
    for (int& row : sweep.bound) row += j < row ? 1 : 0;
    for (int& row : sweep.edge) row += j < row ? 1 : 0;
  }
}

void Wobble::rows_joined(const Clay&, const RowsJoined& joined) noexcept {
  const int j = joined.row;
  for (Sweep& sweep : sweeps_) {
    for (int& row : sweep.bound) row -= j + 1 < row ? 1 : 0;
    for (int& row : sweep.edge) row -= j + 1 < row ? 1 : 0;
  }
}

void Wobble::add_to(StateHash& hash, Clay&) const {
  beat_.add_to(hash);
  for (const Sweep& sweep : sweeps_) {
    for (const Gathered* gathered : {&sweep.next, &sweep.now}) {
      for (const Push& push : gathered->push)
        for (const double v : {push.x, push.z, push.impulse}) hash.add(v);
      hash.add(gathered->impulse);
      hash.add(gathered->raised);
    }
    hash.add(sweep.height);
    for (int k = 0; k < sweep.strips; ++k)
      for (const int row : {sweep.bound[slot(k)], sweep.bound[slot(k + 1)], sweep.edge[slot(k)]})
        hash.add(static_cast<std::uint64_t>(row));
    sweep.round.add_to(hash);
  }
}

}  // namespace effects
}  // namespace onggi
