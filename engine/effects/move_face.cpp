#include "engine/effects/move_face.h"

#include <utility>

#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi::effects {

void move_face(Clay& clay, WallSide side, int j, BlockRun run, const float* by,
               double along) noexcept {
  const ClayDef& def = clay.def();
  const bool outside = side == WallSide::outside;
  const bool hollow = j >= clay.floor_rows();
  if (!outside && !hollow) return;
  const auto least = static_cast<float>(def.radius_min);
  const auto most = static_cast<float>(def.radius_max);
  const auto wall = static_cast<float>(def.wall_min);
  if (clay.areas()->rigid(j)) return;
  if (clay.areas()->firm(j)) along = 1.0;
  row_kernels::FaceMove how{
      outside, hollow, least + wall, most, wall, static_cast<float>(along), least, most - wall};
  if (!outside) {
    std::swap(how.near, how.back_near);
    std::swap(how.far, how.back_far);
  }
  float* outer = clay.pressable_outer(j).data();
  float* inner = clay.pressable_inner(j).data();
  const row_kernels::FaceMoved moved =
      row_kernels::of(clay.vectors())
          .move(how, run, by, outside ? outer : inner, outside ? inner : outer);
  clay.areas()->lose(j, portable::kPi / def.sectors * double{moved.lost});
  clay.widen_extent(j, moved.outermost, moved.innermost);
  clay.mark_dirty(j);
}

}  // namespace onggi::effects
