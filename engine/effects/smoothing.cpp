#include "engine/effects/smoothing.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi {
namespace {

double square(float v) { return double{v} * double{v}; }

}  // namespace

std::span<const EffectField<SmoothingDef>> SmoothingDef::fields() {
  static constexpr EffectField<SmoothingDef> kFields[] = {
      {"pace", &SmoothingDef::pace, 1e-6, 1e-2, "m^2/s"},
  };
  return kFields;
}

namespace effects {

Smoothing::Smoothing(int rows) {
  const auto n = static_cast<std::size_t>(rows);
  for (std::vector<double>* part : {&weight_, &flow_, &up_, &pivot_, &gained_}) part->resize(n);
  rows_.resize(n);
  extent_.resize(n);
}

// Thomas' algorithm on (w_j + f_j + f_j-1) q_j - f_j q_j+1 - f_j-1 q_j-1 = w_j q_j before.
bool Smoothing::even_block(Clay& clay, WallSide side, int first, int count, int block) noexcept {
  const bool outside = side == WallSide::outside;
  const auto at = static_cast<std::size_t>(block * Displacements::kBlock);
  const auto face = [&](int k) {
    return (outside ? clay.pressable_outer(first + k) : clay.pressable_inner(first + k)).data() +
           at;
  };
  const auto other = [&](int k) {
    return (outside ? clay.inner(first + k) : clay.outer(first + k)).data() + at;
  };
  const int width = std::min(Displacements::kBlock, clay.sectors() - static_cast<int>(at));
  for (int k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    for (int i = 0; i < width; ++i) {
      const double below = k > 0 ? flow_[n - 1] * rows_[n - 1].square[i] : 0.0;
      rows_[n].square[i] = (weight_[n] * square(face(k)[i]) + below) / pivot_[n];
    }
  }
  for (int k = count - 2; k >= 0; --k) {
    const auto n = static_cast<std::size_t>(k);
    for (int i = 0; i < width; ++i) rows_[n].square[i] += up_[n] * rows_[n + 1].square[i];
  }
  // A column where the wall would get too thin goes only as far as it may, all of it alike: then
  // it has lost nothing, and is still between what it was and what it would be.
  double share[Displacements::kBlock];
  std::fill_n(share, Displacements::kBlock, 1.0);
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < width; ++i) {
      const double was = square(face(k)[i]);
      const double then = rows_[static_cast<std::size_t>(k)].square[i];
      const double limit = outside ? double{other(k)[i]} + clay.def().wall_min
                                   : std::max(double{other(k)[i]} - clay.def().wall_min, 0.0);
      const double room = limit * limit - was;
      const double way = then - was;
      if (outside ? way < room : way > room)
        share[i] = std::min(share[i], way != 0.0 ? std::clamp(room / way, 0.0, 1.0) : 0.0);
    }
  }
  bool changed = false;
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < width; ++i) {
      const double was = square(face(k)[i]);
      const double way = share[i] * (rows_[static_cast<std::size_t>(k)].square[i] - was);
      const auto now = static_cast<float>(std::sqrt(was + way));
      if (now == face(k)[i]) continue;
      const auto n = static_cast<std::size_t>(k);
      gained_[n] += square(now) - was;
      extent_[n] = outside ? std::max(extent_[n], now) : std::min(extent_[n], now);
      face(k)[i] = now;
      changed = true;
    }
  }
  return changed;
}

void Smoothing::even(const SmoothingDef& def, Clay& clay, WallSide side, double bottom, double top,
                     double seconds) noexcept {
  const Displacements& displacements = *clay.displacements(side == WallSide::inside);
  if (!displacements.any()) return;
  const bool outside = side == WallSide::outside;
  const int lowest = outside ? 0 : clay.floor_rows();
  const int first = std::max({displacements.first_row(), clay.first_row_above(bottom), lowest});
  const int count = std::min(displacements.end_row(), clay.first_row_above(top)) - first;
  if (count < 2) return;
  const double pace = def.pace * seconds;
  for (int k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    weight_[n] = clay.row_thickness(first + k);
    const double apart = clay.row_height(first + k + 1 < clay.rows() ? first + k + 1 : first + k) -
                         clay.row_height(first + k);
    flow_[n] = k + 1 < count ? pace / apart : 0.0;
    const double below = k > 0 ? flow_[n - 1] : 0.0;
    pivot_[n] = weight_[n] + flow_[n] + below - (k > 0 ? below * up_[n - 1] : 0.0);
    up_[n] = flow_[n] / pivot_[n];
    gained_[n] = 0.0;
    extent_[n] = outside ? 0.0f : 1e9f;
  }
  bool changed = false;
  for (BlockRun run = displacements.run_from(0); run.any(); run = displacements.run_from(run.end))
    for (int block = run.begin; block < run.end; ++block)
      changed |= even_block(clay, side, first, count, block);
  if (!changed) return;
  // Rows trade clay: what a row gained in area is its own now. What rounding left over stays with
  // the first, so that the whole has not changed by a bit.
  const double each = portable::kPi / clay.sectors() * (outside ? 1.0 : -1.0);
  double left = 0.0;
  for (int k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    clay.areas()->trade(first + k, each * gained_[n]);
    left += each * gained_[n] * weight_[n];
    clay.widen_extent(first + k, outside ? extent_[n] : 0.0f, outside ? 1e9f : extent_[n]);
    clay.mark_dirty(first + k);
  }
  clay.areas()->keep_for(first, left / weight_[0]);
}

}  // namespace effects
}  // namespace onggi
