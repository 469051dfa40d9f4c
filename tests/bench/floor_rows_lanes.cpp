#include "engine/math/lanes.h"
#include "tests/bench/floor_rows.h"

namespace onggi::ONGGI_LANES {
namespace {

using bench::FloorRow;
using bench::FloorStep;

template <WallSide side>
void press_rows(const FloorStep& step, const FloorRow* rows, int count) {
  constexpr bool outside = side == WallSide::outside;
  const Float8 x = all(step.x);
  const Float8 z = all(step.z);
  const Float8 gone = all(step.gone);
  const Float8 wall_min = all(step.wall_min);
  const Float8 zero = all(0.0f);
  for (const FloorRow* row = rows; row != rows + count; ++row) {
    const Float8 r = all(row->section);
    for (int n = 0; n < row->used; ++n) {
      for (int i = row->ranges[n].begin * kLanes; i < row->ranges[n].end * kLanes; i += kLanes) {
        const Float8 c = load(step.ray_cos + i);
        const Float8 s = load(step.ray_sin + i);
        const Float8 surface = load(row->face + i);
        const Float8 along = x * c + z * s;
        const Float8 off = z * c - x * s;
        const Float8 square = (r - off) * (r + off);
        const Float8 half_chord = sqrt(larger(square, zero));
        const Float8 end = outside ? along - half_chord : along + half_chord;
        const Float8 press = outside ? surface - end : end - surface;
        const Mask8 touch = (square > zero) & (press > zero);
        if (none(touch)) continue;
        const Float8 given = only(touch, press) * gone;
        const Float8 now = outside ? surface - given : surface + given;
        store(now, row->face + i);
        const Float8 back = load(row->behind + i);
        const Float8 least = outside ? now - wall_min : now + wall_min;
        const Mask8 pushed = touch & (outside ? least < back : least > back);
        if (!none(pushed)) store(select(pushed, least, back), row->behind + i);
      }
    }
  }
}

void press(WallSide side, const FloorStep& step, const FloorRow* rows, int count) {
  side == WallSide::outside ? press_rows<WallSide::outside>(step, rows, count)
                            : press_rows<WallSide::inside>(step, rows, count);
}

}  // namespace

extern const bench::FloorLoop kFloorLoop{press};

}  // namespace onggi::ONGGI_LANES
