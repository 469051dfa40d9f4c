#include "kiosk/visit/decorating/example.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/decorating/every_tool.h"

namespace onggi::decorating::example_test {
namespace {

struct Showing : testing::Test {
  decoration::Way way = every_tool();
  std::unique_ptr<DecoratedPot> pot = *DecoratedPot::begin(a_jar(), way);
  Example example;

  /// Until it is over: how long it took, s, and whether anything was seen.
  std::pair<double, bool> run() {
    const std::uint64_t before = pot->surface().hash();
    bool seen = false;
    double time = 0.0;
    for (; example.shows(); time += 1.0 / 60) {
      example.step(1.0 / 60, 0.25, *pot);
      pot->update(1.0 / 60, example.hurries());
      seen = seen || pot->surface().hash() != before;
    }
    return {time, seen};
  }
  void flood_it() {
    pot->choose_tool(flood);
    pot->put({0.08, 0.3});
    pot->finish();
    pot->choose_tool(glaze);
    pot->put({0.08, 0.3});
    pot->finish();
  }
};

TEST_F(Showing, EachToolDrawsOnceInThreeToSixSecondsAndNothingOfItStays) {
  flood_it();
  const std::uint64_t before = pot->surface().hash();
  const auto paint = pot->picture().paint();
  const int steps = pot->surface().steps();
  for (int tool = 0; tool < static_cast<int>(way.tools.size()); ++tool) {
    pot->choose_tool(tool);
    example.begin(*pot);
    ASSERT_TRUE(example.shows()) << tool;
    const auto [time, seen] = run();
    EXPECT_TRUE(seen) << tool;
    EXPECT_GE(time, 3.0) << tool;
    EXPECT_LE(time, Example::kLongest + 0.1) << tool;
    EXPECT_EQ(pot->surface().hash(), before) << tool;
    EXPECT_EQ(pot->surface().steps(), steps) << tool;
    pot->finish();
    EXPECT_TRUE(pot->picture().paint() == paint) << tool;
  }
  EXPECT_EQ(pot->did().size(), 2u);
}

TEST_F(Showing, ItCountsForNothingWhileItIsSeen) {
  pot->choose_tool(flood);
  example.begin(*pot);
  for (int n = 0; n < 80; ++n) {
    example.step(1.0 / 60, 0.25, *pot);
    pot->update(1.0 / 60);
    EXPECT_TRUE(pot->bare());
    EXPECT_FALSE(pot->can_undo());
    EXPECT_TRUE(pot->waits(scrape));
    EXPECT_TRUE(pot->did().empty());
  }
}

TEST_F(Showing, ItStopsAtOnceAtAnyMoment) {
  const std::uint64_t bare = pot->surface().hash();
  for (int frames = 1; frames < 300; frames += 23) {
    pot->choose_tool(frames % 2 == 0 ? band : cut);
    example.begin(*pot);
    for (int n = 0; n < frames && example.shows(); ++n) {
      example.step(1.0 / 60, 0.25, *pot);
      pot->update(1.0 / 60);
    }
    example.stop(*pot);
    EXPECT_EQ(pot->surface().hash(), bare) << frames;
    EXPECT_FALSE(pot->busy());
    EXPECT_FALSE(example.finger());
  }
}

// An example of many strokes makes the undo forget the oldest steps; they are the visitor's.
TEST_F(Showing, AVisitorsStepsCanStillBeTakenBackAfterIt) {
  const std::uint64_t bare = pot->surface().hash();
  pot->choose_tool(smoke);
  for (int n = 0; n < surface::Surface::kMostSteps; ++n) pot->put({0.15 - 0.001 * n, 0.3});
  pot->choose_tool(flood);
  example.begin(*pot);
  run();
  while (pot->can_undo()) pot->undo();
  EXPECT_EQ(pot->surface().hash(), bare);
}

TEST_F(Showing, AToolThatWaitsForAnotherHasNoExample) {
  pot->choose_tool(scrape);
  example.begin(*pot);
  EXPECT_FALSE(example.shows());
}

}  // namespace
}  // namespace onggi::decorating::example_test
