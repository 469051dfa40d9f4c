#include "engine/effects/smoothing.h"

#include <algorithm>

#include "engine/effects/column_kernels.h"
#include "engine/effects/effect_list.h"
#include "engine/math/portable.h"

namespace onggi {

std::span<const DefField<SmoothingDef>> SmoothingDef::fields() {
  static constexpr DefField<SmoothingDef> kFields[] = {
      {"pace", &SmoothingDef::pace, 1e-6, 1e-2, "m^2/s"},
  };
  return kFields;
}

namespace effects {

Smoothing::Smoothing(int rows) {
  const auto n = static_cast<std::size_t>(rows);
  gained_.resize(n);
  for (std::vector<float>* part : {&weight_, &flow_, &up_, &inverse_, &extent_}) part->resize(n);
  change_.resize(column_kernels::kMostBlocks * Displacements::kBlock * n);
}

bool Smoothing::wanted(const Effects& def) { return def.smoothing.has_value(); }

void Smoothing::run(const StageWork& work) noexcept {
  for (const HandThere& hand : work.tick.hand)
    if (hand.on_wall && hand.smooths > 0.0 && hand.side == work.side)
      even(*work.def.smoothing, work.clay, hand.side, hand.at.y - hand.smooths,
           hand.at.y + hand.smooths, work.side_seconds);
}

void Smoothing::even(const SmoothingDef& def, Clay& clay, WallSide side, double bottom, double top,
                     double seconds) noexcept {
  Displacements& displacements = *clay.displacements(side == WallSide::inside);
  if (!displacements.any()) return;
  const bool outside = side == WallSide::outside;
  const int lowest = outside ? 0 : clay.floor_rows();
  const int first = std::max({displacements.first_row(), clay.first_row_above(bottom), lowest});
  const int count = std::min(displacements.end_row(), clay.first_row_above(top)) - first;
  if (count < 2) return;
  const double pace = def.pace * seconds;
  double below = 0.0;  // flow from the row below, and its share in this row's pivot
  double up = 0.0;
  double total = 0.0;
  for (int k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const double weight = clay.row_thickness(first + k);
    total += weight;
    const double flow =
        k + 1 < count ? pace / (clay.row_height(first + k + 1) - clay.row_height(first + k)) : 0.0;
    const double inverse = 1.0 / (weight + flow + below * (1.0 - up));
    up = flow * inverse;
    below = flow;
    weight_[n] = static_cast<float>(weight);
    flow_[n] = static_cast<float>(flow);
    inverse_[n] = static_cast<float>(inverse);
    up_[n] = static_cast<float>(up);
    gained_[n] = 0.0;
    extent_[n] = outside ? 0.0f : 1e9f;
  }
  float* const outer = clay.stored_outer(0);
  float* const inner = clay.stored_inner(0);
  column_kernels::Even work{{outside, 0, count, clay.stride(), clay.stored().data() + first,
                             nullptr, nullptr, static_cast<float>(clay.def().wall_min)},
                            nullptr,
                            weight_.data(),
                            static_cast<float>(1.0 / total),
                            flow_.data(),
                            inverse_.data(),
                            up_.data(),
                            change_.data(),
                            gained_.data(),
                            nullptr,
                            extent_.data(),
                            static_cast<float>(clay.def().radius_min)};
  const column_kernels::Table& kernels = column_kernels::of(clay.vectors());
  bool changed = false;
  for (BlockRun run = displacements.run_from(0); run.any(); run = displacements.run_from(run.end))
    for (int block = run.begin; block < run.end; block += column_kernels::kMostBlocks) {
      const int i = block * Displacements::kBlock;
      work.at.blocks = std::min(run.end - block, column_kernels::kMostBlocks);
      work.at.face = (outside ? outer : inner) + i;
      work.at.other = (outside ? inner : outer) + i;
      work.moved = displacements.row(0) + i;
      work.rounded = displacements.rounded() != nullptr ? displacements.rounded() + i : nullptr;
      changed |= kernels.even(work);
    }
  if (!changed) return;
  // Rows trade clay: a row keeps the area it gained. The first row takes the rounding error, so
  // that the total does not change by a bit.
  const double each = portable::kPi / clay.sectors() * (outside ? 1.0 : -1.0);
  double left = 0.0;
  for (int k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    clay.areas()->trade(first + k, each * gained_[n]);
    left += each * gained_[n] * clay.row_thickness(first + k);
    clay.widen_extent(first + k, outside ? extent_[n] : 0.0f, outside ? 1e9f : extent_[n]);
    clay.mark_dirty(first + k);
  }
  clay.areas()->keep_for(first, left / clay.row_thickness(first));
}

}  // namespace effects
}  // namespace onggi
