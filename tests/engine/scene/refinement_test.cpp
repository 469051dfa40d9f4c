#include "tests/support/convergence.h"

#include <gtest/gtest.h>

// The clock and the grid must not matter: what engine/docs/convergence.md has as a table.
namespace onggi::refinement::refinement_test {
namespace {

void expect_order(const Refined& r, const Apart& least, const std::string& what) {
  EXPECT_TRUE(r.order.shape > least.shape || r.finest.shape < kFloor.shape)
      << what << ": shape, order " << r.order.shape << ", " << r.finest.shape << " m";
  // The rim is felt through the coil until the ring closes, which is at a sector and at a tick.
  if (what.starts_with("building")) return;
  EXPECT_TRUE(r.order.force > least.force || r.finest.force < kFloor.force)
      << what << ": force, order " << r.order.force << ", " << r.finest.force << " N";
  EXPECT_TRUE(r.order.impulse > least.impulse || r.finest.impulse < kFloor.impulse)
      << what << ": impulse, order " << r.order.impulse << ", " << r.finest.impulse;
}

TEST(Refinement, OfTicksEveryEffectDrawsTogetherAndAnImpulseIsTheSameFromHalfToFiveMilliseconds) {
  for (const Work& work : effect_works()) {
    const Refined ticks = refine_ticks(work);
    expect_order(ticks, {0.9, 0.9, 0.9}, work.name);
    EXPECT_LT(ticks.impulse_off, 0.01) << work.name;
  }
}

TEST(Refinement, OfGridsEveryEffectDrawsTogether) {
  for (const Work& work : effect_works()) {
    const Refined grids = refine_grids(work);
    expect_order(grids, {0.9, 0.9, 0.9}, work.name);
    EXPECT_LT(grids.impulse_off, 0.01) << work.name;
  }
}

TEST(Refinement, ContactAndWallsAreOfSecondOrderInTheTick) {
  for (const Work& work : effect_works()) {
    if (work.name != "contact" && !work.name.starts_with("walls")) continue;
    const Refined ticks = refine_ticks(work);
    EXPECT_GT(ticks.order.shape, 1.7) << work.name;
    EXPECT_GT(ticks.order.force, 1.7) << work.name;
    EXPECT_GT(ticks.order.impulse, 1.7) << work.name;
  }
}

}  // namespace
}  // namespace onggi::refinement::refinement_test
