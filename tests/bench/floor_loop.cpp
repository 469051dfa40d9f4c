#include "tests/bench/floor_loop.h"

#include <algorithm>
#include <bit>

#include "engine/contact/ball_window.h"
#include "tests/bench/floor_rows.h"

namespace onggi::bench {

std::int64_t floor_loop(Clay& clay, WallSide side, Vec3 at, double radius, double decay) noexcept {
  const bool outside = side == WallSide::outside;
  const contact::BallWindow window(clay, at, radius);
  const FloorStep step{clay.ray_cos().data(),           clay.ray_sin().data(),
                       static_cast<float>(at.x),        static_cast<float>(at.z),
                       static_cast<float>(1.0 - decay), static_cast<float>(clay.def().wall_min)};
  const FloorLoop& loop = floor_rows(clay.vectors());
  std::int64_t visited = 0;
  contact::BallWindows planned;
  FloorRow rows[contact::kPlannedRows];
  const int begin = outside ? window.first_row : std::max(window.first_row, clay.floor_rows());
  for (int first = begin; first < window.end_row; first += contact::kPlannedRows) {
    const int count = std::min(contact::kPlannedRows, window.end_row - first);
    plan_rows(clay, window, side, first, count, planned);
    int used = 0;
    for (std::uint32_t left = planned.reached; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      float* outer = clay.pressable_outer(first + k).data();
      float* inner = clay.pressable_inner(first + k).data();
      FloorRow& row = rows[used++];
      row.face = outside ? outer : inner;
      row.behind = outside ? inner : outer;
      row.section = planned.section[k];
      row.used = blocks_of(contact::RowShape(clay), planned, k, row.ranges);
      visited += contact::elements_in(row.ranges, row.used);
    }
    loop.press(side, step, rows, used);
  }
  return visited;
}

}  // namespace onggi::bench
