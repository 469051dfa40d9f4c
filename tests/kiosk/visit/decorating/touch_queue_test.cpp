#include "kiosk/visit/decorating/touch_queue.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/decorating/every_tool.h"

namespace onggi::decorating::touch_queue_test {
namespace {

struct Touching : testing::Test {
  decoration::Way way = every_tool();
  std::unique_ptr<DecoratedPot> pot = *DecoratedPot::begin(a_jar(), way);
  TouchQueue touches{*pot};

  int frames_until_free() {
    int frames = 0;
    for (; pot->busy() || touches.waits(); ++frames) touches.update(1.0 / 60);
    return frames;
  }
  int slip(double along, double turns) const {
    return pot->surface()
        .slip(static_cast<int>(along * 4000), static_cast<int>(turns * surface::kSectors))
        .thickness();
  }
};

TEST_F(Touching, ATouchWhileARingClosesIsKeptAndTheRingHurries) {
  pot->choose_tool(band);
  touches.press({0.05, 0.3});
  touches.lift();
  const int alone = frames_until_free();
  touches.press({0.08, 0.3});
  touches.lift();
  ASSERT_TRUE(pot->busy());
  touches.press({0.12, 0.1});
  EXPECT_TRUE(touches.waits());
  int frames = 0;
  for (; touches.waits(); ++frames) touches.update(1.0 / 60);
  EXPECT_LT(frames, alone / 4);
  EXPECT_TRUE(pot->pressed());
  touches.move({0.12, 0.2});
  touches.lift();
  frames_until_free();
  pot->finish();
  for (const double along : {0.05, 0.08, 0.12}) {
    EXPECT_GT(slip(along, 0.1), 0) << along;
    EXPECT_GT(slip(along, 0.6), 0) << along;
  }
  EXPECT_EQ(pot->did()[0].times, 3);
}

TEST_F(Touching, AWholeStrokeThatIsMadeMeanwhileComesOutAsItWasMade) {
  const auto line = [](TouchQueue& hand) {
    hand.press({0.1, 0.0});
    for (int n = 1; n <= 10; ++n) hand.move({0.1 + 0.001 * n, 0.003 * n});
    hand.lift();
  };
  pot->choose_tool(band);
  touches.press({0.05, 0.3});
  touches.lift();
  pot->end_work();
  pot->choose_tool(cut);
  line(touches);
  const std::uint64_t apart = pot->surface().hash();

  const auto other = *DecoratedPot::begin(a_jar(), way);
  TouchQueue hurried(*other);
  other->choose_tool(band);
  hurried.press({0.05, 0.3});
  hurried.lift();
  other->choose_tool(cut);
  ASSERT_TRUE(other->busy());
  line(hurried);
  while (hurried.waits()) hurried.update(1.0 / 60);
  EXPECT_EQ(other->surface().hash(), apart);
}

TEST_F(Touching, WhoTakesAnotherToolMeanwhileLosesNothing) {
  pot->choose_tool(band);
  touches.press({0.05, 0.3});
  touches.lift();
  touches.press({0.12, 0.3});
  touches.lift();
  touches.put({0.08, 0.3});
  touches.settle();
  pot->choose_tool(cut);
  pot->finish();
  for (const double along : {0.05, 0.08, 0.12}) EXPECT_GT(slip(along, 0.8), 0) << along;
}

TEST_F(Touching, AFingerThatWasNotMeantLeavesNothing) {
  pot->choose_tool(cut);
  const std::uint64_t bare = pot->surface().hash();
  touches.press({0.05, 0.0});
  touches.move({0.07, 0.01});
  EXPECT_NE(pot->surface().hash(), bare);
  touches.cancel();
  touches.lift();
  EXPECT_EQ(pot->surface().hash(), bare);
  EXPECT_TRUE(pot->bare());
  // One that is only kept, too.
  pot->choose_tool(band);
  touches.press({0.05, 0.0});
  touches.lift();
  touches.press({0.12, 0.0});
  touches.cancel();
  frames_until_free();
  EXPECT_GT(slip(0.05, 0.5), 0);
  EXPECT_EQ(slip(0.12, 0.5), 0);
}

}  // namespace
}  // namespace onggi::decorating::touch_queue_test
