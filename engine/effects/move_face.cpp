#include "engine/effects/move_face.h"

#include <utility>

#include "engine/math/portable.h"

namespace onggi::effects {

row_kernels::FaceMove limits_of(const Clay& clay, WallSide side, double along) noexcept {
  const ClayDef& def = clay.def();
  const bool outside = side == WallSide::outside;
  const auto least = static_cast<float>(def.radius_min);
  const auto most = static_cast<float>(def.radius_max);
  const auto wall = static_cast<float>(def.wall_min);
  row_kernels::FaceMove how{
      outside, true, least + wall, most, wall, static_cast<float>(along), least, most - wall};
  if (!outside) {
    std::swap(how.near, how.back_near);
    std::swap(how.far, how.back_far);
  }
  return how;
}

bool may_move(const Clay& clay, WallSide side, int j, double along,
              row_kernels::FaceMove& how) noexcept {
  const bool hollow = j >= clay.floor_rows();
  if ((side == WallSide::inside && !hollow) || clay.areas()->rigid(j)) return false;
  how = limits_of(clay, side, clay.areas()->firm(j) ? 1.0 : along);
  how.hollow = hollow;
  return true;
}

void was_moved(Clay& clay, int j, const row_kernels::FaceMoved& moved) noexcept {
  clay.areas()->lose(j, portable::kPi / clay.sectors() * double{moved.lost});
  clay.widen_extent(j, moved.outermost, moved.innermost);
  clay.mark_dirty(j);
}

}  // namespace onggi::effects
