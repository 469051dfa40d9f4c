#include "engine/effects/propagation.h"

#include <algorithm>

#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

// e^-x, x >= 0: rows are close, and 100 of them differ in height. Pade's (2, 2) is off by x^5/720,
// 4e-5 at a half.
double fading_over(double x) {
  if (x > 0.5) return portable::exp(-x);
  const double even = 1.0 + x * x / 12.0;
  return (even - 0.5 * x) / (even + 0.5 * x);
}

}  // namespace

std::span<const EffectField<PropagationDef>> PropagationDef::fields() {
  static constexpr EffectField<PropagationDef> kFields[] = {
      {"reach", &PropagationDef::reach, 0.0005, 0.05, "m"},
  };
  return kFields;
}

namespace effects {

Propagation::Propagation(int stride)
    : pull_{std::vector<float>(static_cast<std::size_t>(stride)),
            std::vector<float>(static_cast<std::size_t>(stride))},
      more_(static_cast<std::size_t>(stride)) {}

// False where nothing was dragged.
bool Propagation::drag_row(Clay& clay, WallSide side, int j, BlockRun run, float faded,
                           double along) noexcept {
  float* own = clay.displacements(side == WallSide::inside)->row(clay.stored(j));
  if (row_kernels::of(clay.vectors())
          .pull(run, faded, own, pull_.source.data(), pull_.carried.data(), more_.data()) <= 0.0f)
    return false;
  move_face(clay, side, j, run, more_.data(), along);
  return true;
}

// Two sweeps over the pressed rows, one up and one down, each carrying the strongest pull of the
// rows behind it: so a row is looked at twice, not once for every row that was pressed. The work
// list is that of the displacements, runs of blocks that contact touched: a fingertip 2 mm deep is
// over 12 elements of 360, two or three blocks of 45.
void Propagation::drag(const PropagationDef& def, Clay& clay, WallSide side,
                       double along) noexcept {
  Displacements& displacements = *clay.displacements(side == WallSide::inside);
  if (!displacements.any()) return;
  const int first = displacements.first_row();
  const int end = displacements.end_row();
  // Inside, the floor holds: its rows have no inner face.
  const int bottom = side == WallSide::inside ? clay.floor_rows() : 0;
  // Rows of one height have one fading: most of a lump's.
  double last = -1.0;
  float last_fading = 1.0f;
  const auto fading = [&](int from, int to) {
    const double apart = 0.5 * (clay.row_thickness(to) + clay.row_thickness(from));
    if (apart != last) last_fading = static_cast<float>(fading_over(apart / def.reach));
    last = apart;
    return last_fading;
  };
  for (BlockRun run = displacements.run_from(0); run.any(); run = displacements.run_from(run.end)) {
    const auto forget_pull = [&] {
      for (std::vector<float>* part : {&pull_.source, &pull_.carried})
        std::fill(part->begin() + run.begin * Displacements::kBlock,
                  part->begin() + run.end * Displacements::kBlock, 0.0f);
    };
    forget_pull();
    for (int j = first; j < clay.rows(); ++j) {
      const float faded = j > first ? fading(j - 1, j) : 0.0f;
      const bool dragged = drag_row(clay, side, j, run, faded, along);
      // Above them nothing moved by itself, and a pull only fades: where it drags nothing, it will
      // drag nothing farther up.
      if (j >= end && !dragged) break;
      if (dragged) displacements.mark(j, run);
    }
    forget_pull();
    for (int j = end - 1; j >= bottom; --j) {
      const float faded = j < end - 1 ? fading(j + 1, j) : 0.0f;
      const bool dragged = drag_row(clay, side, j, run, faded, along);
      if (j < first && !dragged) break;
      if (dragged) displacements.mark(j, run);
    }
  }
}

}  // namespace effects
}  // namespace onggi
