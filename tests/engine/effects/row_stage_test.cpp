#include "engine/effects/row_stage.h"

#include <gtest/gtest.h>

#include "engine/effects/effect_list.h"

namespace onggi::effects::row_stage_test {
namespace {

// A stage that says everything, and the same of which each leaves out one thing.
struct Whole : KeepsNoRows {
  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects&) { return true; }
  static Whole make(const Effects&, Clay&) { return {}; }
  void run(const StageWork&) noexcept {}
};
struct NotMade : Whole {
  static void make(const Effects&, Clay&) = delete;
};
struct NotRun : Whole {
  static NotRun make(const Effects&, Clay&) { return {}; }
  void run(const StageWork&) = delete;
};
struct NotToldOfAdded : Whole {
  static NotToldOfAdded make(const Effects&, Clay&) { return {}; }
  void row_added(const Clay&, const RowAdded&) = delete;
};
struct NotToldOfDivided : Whole {
  static NotToldOfDivided make(const Effects&, Clay&) { return {}; }
  void row_divided(const Clay&, const RowDivided&) = delete;
};
struct NotToldOfJoined : Whole {
  static NotToldOfJoined make(const Effects&, Clay&) { return {}; }
  void rows_joined(const Clay&, const RowsJoined&) = delete;
};
struct NeverForgets : Whole {
  static NeverForgets make(const Effects&, Clay&) { return {}; }
  void forget(Clay&, const Laid&) = delete;
};
struct NotInTheHash : Whole {
  static NotInTheHash make(const Effects&, Clay&) { return {}; }
  void add_to(StateHash&, Clay&) const = delete;
};
struct MayThrow : Whole {
  static MayThrow make(const Effects&, Clay&) { return {}; }
  void run(const StageWork&) {}
};

TEST(Stage, OneThatForgetsToSayWhatARowMeansToItIsNone) {
  static_assert(Stage<Whole>);
  static_assert(!Stage<NotMade>);
  static_assert(!Stage<NotRun>);
  static_assert(!Stage<NotToldOfAdded>);
  static_assert(!Stage<NotToldOfDivided>);
  static_assert(!Stage<NotToldOfJoined>);
  static_assert(!Stage<NeverForgets>);
  static_assert(!Stage<NotInTheHash>);
  static_assert(!Stage<MayThrow>);
}

TEST(StageWork, AFaceMovedByNoPressGoesWithTheHandOnItAndWhereThereIsNoneWithTheWall) {
  const ClayDef def;
  Clay clay = std::move(*Clay::create(def));
  Effects effects;
  RowTick tick;
  const StageWork work{effects, clay, tick};
  EXPECT_EQ(work.along(WallSide::inside), 0.0);
  effects.walls.emplace();
  EXPECT_EQ(work.along(WallSide::inside), 1.0);
  tick.hand[1] = {{}, 1.0, true, WallSide::inside, 0.25, 0.0};
  EXPECT_EQ(work.along(WallSide::inside), 0.25);
  EXPECT_EQ(work.along(WallSide::outside), 1.0);
}

}  // namespace
}  // namespace onggi::effects::row_stage_test
