#include "engine/effects/smoothing.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi {

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
  squares_.resize(static_cast<std::size_t>(Displacements::kBlock) * n);
  extent_.resize(n);
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
  float* const face = outside ? clay.stored_outer(0) : clay.stored_inner(0);
  const float* const other = outside ? clay.stored_inner(0) : clay.stored_outer(0);
  row_kernels::Columns columns{outside,         count,
                               clay.stride(),   clay.stored().data() + first,
                               nullptr,         nullptr,
                               weight_.data(),  flow_.data(),
                               up_.data(),      pivot_.data(),
                               squares_.data(), gained_.data(),
                               extent_.data(),  clay.def().wall_min};
  const row_kernels::Table& kernels = row_kernels::of(clay.vectors());
  bool changed = false;
  for (BlockRun run = displacements.run_from(0); run.any(); run = displacements.run_from(run.end))
    for (int block = run.begin; block < run.end; ++block) {
      columns.face = face + block * Displacements::kBlock;
      columns.other = other + block * Displacements::kBlock;
      changed |= kernels.even(columns);
    }
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
