#include "engine/effects/propagation.h"

#include <algorithm>

#include "engine/effects/effect_list.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

// Nothing follows where less than e^-3 of a pull is left. The rest allows for rounding and the
// error of fading_over().
constexpr double kReaches = 3.01;

// e^-x, x >= 0. Rows are close, and 100 of them differ in height. Pade's (2, 2): error x^5/720,
// 4e-5 at 0.5.
double fading_over(double x) {
  if (x > 0.5) return portable::exp(-x);
  const double even = 1.0 + x * x / 12.0;
  return (even - 0.5 * x) / (even + 0.5 * x);
}

}  // namespace

std::span<const DefField<PropagationDef>> PropagationDef::fields() {
  static constexpr DefField<PropagationDef> kFields[] = {
      {"reach", &PropagationDef::reach, 0.0005, 0.05, "m"},
  };
  return kFields;
}

namespace effects {

Propagation::Propagation(int rows) {
  const auto n = static_cast<std::size_t>(rows);
  for (std::vector<float>* part : {&fading_, &outermost_, &innermost_}) part->resize(n);
  give_.resize(n);
  more_.resize(column_kernels::kMostBlocks * Displacements::kBlock * n);
  lost_.resize(n);
}

bool Propagation::wanted(const Effects& def) { return def.propagation.has_value(); }

void Propagation::run(const StageWork& work) noexcept {
  drag(*work.def.propagation, work.clay, work.side, work.along(work.side));
}

// Two sweeps over the pressed rows, one up and one down. Each carries the strongest pull of the
// rows behind it, so a row is visited twice, not once per pressed row. The work list is the
// displacements' list of blocks that contact touched: a fingertip 2 mm deep covers 12 elements of
// 360, two or three blocks of 45.
void Propagation::drag(const PropagationDef& def, Clay& clay, WallSide side,
                       double along) noexcept {
  Displacements& displacements = *clay.displacements(side == WallSide::inside);
  if (!displacements.any()) return;
  const bool outside = side == WallSide::outside;
  const double beyond = kReaches * def.reach;
  // Inside, the floor does not move: its rows have no inner face.
  const int bottom = outside ? 0 : clay.floor_rows();
  int low = displacements.first_row();
  for (const double y = clay.row_height(low); low > bottom; --low)
    if (y - clay.row_height(low) > beyond) break;
  int high = displacements.end_row();
  for (const double y = clay.row_height(high - 1); high < clay.rows(); ++high)
    if (clay.row_height(high) - y > beyond) break;
  const int count = high - low;

  // Rows of equal height share one fading factor. Most of a lump's rows are equal.
  double last = -1.0;
  float fading = 1.0f;
  for (int k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const int j = low + k;
    const double apart = 0.5 * (clay.row_thickness(j) + clay.row_thickness(k > 0 ? j - 1 : j));
    if (apart != last) fading = static_cast<float>(fading_over(apart / def.reach));
    last = apart;
    fading_[n] = fading;
    lost_[n] = 0.0;
    outermost_[n] = 0.0f;
    innermost_[n] = 1e9f;
  }
  RowAreas& areas = *clay.areas();
  const bool held = areas.any_firm();
  for (int k = 0; held && k < count; ++k)
    give_[static_cast<std::size_t>(k)] = areas.rigid(low + k)  ? column_kernels::Give::rigid
                                         : areas.firm(low + k) ? column_kernels::Give::firm
                                                               : column_kernels::Give::free;

  const row_kernels::FaceMove limits = limits_of(clay, side, along);
  float* const outer = clay.stored_outer(0);
  float* const inner = clay.stored_inner(0);
  column_kernels::Drag work{{outside, 0, count, clay.stride(), clay.stored().data() + low, nullptr,
                             nullptr, limits.wall_min},
                            displacements.first_row() - low,
                            displacements.end_row() - low,
                            clay.floor_rows() - low,
                            nullptr,
                            fading_.data(),
                            held ? give_.data() : nullptr,
                            limits.along,
                            limits.near,
                            limits.far,
                            limits.back_near,
                            limits.back_far,
                            more_.data(),
                            lost_.data(),
                            outermost_.data(),
                            innermost_.data()};
  const column_kernels::Table& kernels = column_kernels::of(clay.vectors());
  column_kernels::Dragged reached{count, 0};
  for (BlockRun run = displacements.run_from(0); run.any(); run = displacements.run_from(run.end))
    for (int block = run.begin; block < run.end; block += column_kernels::kMostBlocks) {
      const int i = block * Displacements::kBlock;
      work.at.blocks = std::min(run.end - block, column_kernels::kMostBlocks);
      work.at.face = (outside ? outer : inner) + i;
      work.at.other = (outside ? inner : outer) + i;
      work.moved = displacements.row(0) + i;
      const column_kernels::Dragged rows = kernels.drag(work);
      reached = {std::min(reached.from, rows.from), std::max(reached.to, rows.to)};
    }
  for (const int k : {reached.from, reached.to - 1}) displacements.mark(low + k, {0, 0});
  for (int k = reached.from; k < reached.to; ++k) {
    const auto n = static_cast<std::size_t>(k);
    if (outermost_[n] > 0.0f)
      was_moved(clay, low + k, {static_cast<float>(lost_[n]), outermost_[n], innermost_[n]});
  }
}

}  // namespace effects
}  // namespace onggi
