#include "tests/bench/floor_loop.h"

#include <algorithm>

#include "engine/contact/window.h"
#include "engine/math/lanes.h"

namespace onggi::bench {
namespace {

template <WallSide side>
std::int64_t floor_side(Clay& clay, Vec3 at, double radius, double decay) {
  constexpr bool outside = side == WallSide::outside;
  const Window window(clay, at, at, radius);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();
  const Float8 x(static_cast<float>(at.x));
  const Float8 z(static_cast<float>(at.z));
  const Float8 left(static_cast<float>(decay));
  const Float8 wall_min(static_cast<float>(clay.def().wall_min));
  const Float8 zero(0.0f);
  std::int64_t visited = 0;
  const int first = outside ? window.first_row() : std::max(window.first_row(), clay.floor_rows());
  for (int j = first; j < window.end_row(); ++j) {
    const double section = cross_section(radius, at.y - clay.row_height(j));
    const Float8 r(static_cast<float>(section));
    float* face = outside ? clay.outer_mut(j).data() : clay.inner_mut(j).data();
    float* behind = outside ? clay.inner_mut(j).data() : clay.outer_mut(j).data();
    BlockRange ranges[2];
    const int used = window.blocks(section, ranges);
    for (int n = 0; n < used; ++n) {
      for (int i = ranges[n].begin * kLanes; i < ranges[n].end * kLanes; i += kLanes) {
        const Float8 c = Float8::load(ray_cos + i);
        const Float8 s = Float8::load(ray_sin + i);
        const Float8 surface = Float8::load(face + i);
        const Float8 along = x * c + z * s;
        const Float8 off = z * c - x * s;
        const Float8 square = (r - off) * (r + off);
        const Float8 half_chord = sqrt(larger(square, zero));
        const Float8 end = outside ? along - half_chord : along + half_chord;
        const Float8 press = outside ? surface - end : end - surface;
        const Mask8 touch = (square > zero) & (press > zero);
        if (!any(touch)) continue;
        const Float8 kept = press * left;
        const Float8 now = select(touch, outside ? end + kept : end - kept, surface);
        now.store(face + i);
        const Float8 back = Float8::load(behind + i);
        (outside ? smaller(back, now - wall_min) : larger(back, now + wall_min)).store(behind + i);
      }
      visited += (ranges[n].end - ranges[n].begin) * kLanes;
    }
  }
  return visited;
}

}  // namespace

std::int64_t floor_loop(Clay& clay, WallSide side, Vec3 at, double radius, double decay) noexcept {
  return side == WallSide::outside ? floor_side<WallSide::outside>(clay, at, radius, decay)
                                   : floor_side<WallSide::inside>(clay, at, radius, decay);
}

}  // namespace onggi::bench
