#include "engine/effects/wobble.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr int kElementBudget = 2048;  // a tick
constexpr int kLeastRows = 4;         // on the finest grids
constexpr double kRest = 1e-6;        // m: centred

// The face of a circle `radius` about (off, 0), along a ray whose cosine and sine are given.
double circle_along(double radius, double off, double cosine, double sine) {
  const double beside = off * sine;
  return off * cosine + std::sqrt(std::max((radius - beside) * (radius + beside), 0.0));
}

// Both faces of row `j` by what `face` says of a ray and a radius; held to what the clay may be.
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
    outer[i] = std::clamp(static_cast<float>(face(c, s, double{outer[i]})), inner[i] + wall, most);
    out_most = std::max(out_most, outer[i]);
    in_least = std::min(in_least, inner[i]);
  }
  clay.set_extent(j, out_most, in_least);
  if (clay.areas() != nullptr) clay.areas()->forget(j);
  clay.mark_dirty(j);
}

}  // namespace

std::span<const EffectField<WobbleDef>> WobbleDef::fields() {
  static constexpr EffectField<WobbleDef> kFields[] = {
      {"off_centre", &WobbleDef::off_centre, 0.0, 0.03, "m"},
      {"centring_time", &WobbleDef::centring_time, 0.002, 60.0, "s"},
      {"reach", &WobbleDef::reach, 0.001, 1.0, "m"},
  };
  return kFields;
}

OffCentre off_centre_of(const Clay& clay, int j) noexcept {
  const row_kernels::Harmonic sum = row_kernels::harmonic(
      clay.stride(), clay.outer(j).data(), clay.ray_cos().data(), clay.ray_sin().data());
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

void Wobble::centre(const WobbleDef& def, Clay& clay, const CentringHand& hand,
                    double seconds) noexcept {
  const double far = axis_distance(hand.at);
  const int first = clay.first_row_above(hand.at.y - def.reach);
  const int rows = clay.first_row_above(hand.at.y + def.reach) - first;
  if (hand.normal <= 0.0 || far <= 0.0 || rows <= 0) return;
  const double ux = hand.at.x / far;
  const double uz = hand.at.z / far;
  const int budget = std::min(rows, std::max(kLeastRows, kElementBudget / clay.stride()));
  // A row's turn comes every rows / budget ticks, and counts for all of them.
  const double pressed = hand.normal * seconds * rows / budget / def.centring_time;
  for (int n = 0; n < budget; ++n) {
    const int j = first + static_cast<int>(turn_++ % static_cast<unsigned>(rows));
    const OffCentre off = off_centre_of(clay, j);
    const double towards = off.x * ux + off.z * uz;
    const double beyond = hand.side == WallSide::outside ? towards : -towards;
    if (beyond <= kRest) continue;
    const double apart = std::fabs(clay.row_height(j) - hand.at.y) / def.reach;
    const double fade = std::max(1.0 - apart * apart, 0.0);
    const double share = -portable::expm1(-pressed * fade);
    const double back = -towards * share;
    const row_kernels::RowPush how{j >= clay.floor_rows(),
                                   static_cast<float>(back * ux),
                                   static_cast<float>(back * uz),
                                   static_cast<float>(clay.def().radius_min),
                                   static_cast<float>(clay.def().radius_max),
                                   static_cast<float>(clay.def().wall_min)};
    const row_kernels::FaceMoved moved =
        row_kernels::push(how, clay.stride(), clay.ray_cos().data(), clay.ray_sin().data(),
                          clay.pressable_outer(j).data(), clay.pressable_inner(j).data());
    clay.set_extent(j, moved.outermost, moved.innermost);
    if (clay.areas() != nullptr) clay.areas()->forget(j);
    clay.mark_dirty(j);
  }
}

void Wobble::add_to(StateHash& hash) const { hash.add(std::uint64_t{turn_}); }

}  // namespace onggi
