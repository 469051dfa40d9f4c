#include "tests/bench/floor_rows.h"

#include "engine/math/vector_choice.h"

namespace onggi {

ONGGI_CHOICE_OF(bench::FloorLoop, kFloorLoop)

const bench::FloorLoop& bench::floor_rows(Vectors kind) noexcept { return choose_kFloorLoop(kind); }

}  // namespace onggi
