#include "kiosk/picture/render/outputs.h"

#include <gtest/gtest.h>

namespace onggi::render::outputs_test {
namespace {

constexpr std::uint64_t kHdmi = 61, kPort = 62, kFullHd = 101, kWide = 102, kOdd = 103;

Output monitor(std::uint64_t id, std::uint64_t shows, int x = 0) {
  Output output{.id = id, .connected = true, .monitor = id * 7, .modes = {kFullHd, kWide}};
  output.mode = shows;
  if (shows != 0) output.x = x, output.width = 1920, output.height = 1080;
  return output;
}
Output empty(std::uint64_t id, std::uint64_t shows = 0) {
  Output output{.id = id};
  output.mode = shows;
  return output;
}
Outputs of(std::vector<Output> all, std::uint64_t primary = 0) {
  return {1920, 1080, primary, all};
}

TEST(Outputs, AMonitorThatIsPluggedInIsLitAsItWouldChooseItself) {
  const Outputs before = of({empty(kHdmi)}), now = of({monitor(kHdmi, 0)});
  EXPECT_EQ(relight(before, now), (Relighting{kHdmi, kFullHd, {}}));
  EXPECT_EQ(relight(now, now), Relighting{}) << "one that a script keeps dark stays so";
}

TEST(Outputs, AnotherMonitorOnTheSameCableIsLitAnewAndTheSameOneKeepsTheModeThatItWasGiven) {
  const Outputs before = of({monitor(kHdmi, kWide)});
  Outputs now = before;
  EXPECT_EQ(relight(before, now), Relighting{});
  now.all[0].monitor = 12345;
  EXPECT_EQ(relight(before, now), (Relighting{kHdmi, kFullHd, {}}));
  now.all[0].monitor = 0;
  EXPECT_EQ(relight(before, now), Relighting{})
      << "one that says nothing of itself may be the same";
}

TEST(Outputs, AModeThatTheMonitorCannotShowGivesWay) {
  const Outputs now = of({monitor(kHdmi, kOdd)});
  EXPECT_EQ(relight(now, now), (Relighting{kHdmi, kFullHd, {}}));
}

TEST(Outputs, TheSocketThatTheMonitorWasMovedFromGoesDark) {
  const Outputs before = of({monitor(kHdmi, kFullHd), empty(kPort)}, kHdmi),
                now = of({empty(kHdmi, kFullHd), monitor(kPort, 0)}, kHdmi);
  EXPECT_EQ(relight(before, now), (Relighting{kPort, kFullHd, {kHdmi}}));
  EXPECT_EQ(relight(before, of({empty(kHdmi, kFullHd), empty(kPort)}, kHdmi)), Relighting{})
      << "without any monitor all stays, and is right when it comes back";
}

TEST(Outputs, AtTheStartOnlyAKioskThatNobodySeesIsLit) {
  EXPECT_EQ(relight({}, of({monitor(kHdmi, 0)})), (Relighting{kHdmi, kFullHd, {}}));
  EXPECT_EQ(relight({}, of({monitor(kHdmi, kWide)})), Relighting{});
  EXPECT_EQ(relight({}, of({monitor(kHdmi, kWide), monitor(kPort, 0)}, kPort)), Relighting{});
  EXPECT_EQ(relight({}, of({empty(kHdmi)})), Relighting{});
}

/// Where the corners of the glass, as it is held upright, fall on the screen.
std::array<float, 4> corners(const std::array<float, 9>& m) {
  const auto at = [&](float u, float v) {
    return std::make_pair(m[0] * u + m[1] * v + m[2], m[3] * u + m[4] * v + m[5]);
  };
  return {at(0, 0).first, at(0, 0).second, at(1, 0).first, at(1, 0).second};
}

TEST(Outputs, AFingerFallsOnTheMonitorThatItTouchesHoweverItHangs) {
  Outputs outputs{.width = 4000, .height = 2000};
  Output right{.id = kPort, .connected = true};
  right.x = 1000, right.y = 500, right.width = 2000, right.height = 1000;
  // Its top left corner, and then its top right one, as shares of the whole screen.
  EXPECT_EQ(corners(touch_map(outputs, right)), (std::array<float, 4>{0.25f, 0.25f, 0.75f, 0.25f}));
  // Turned left, the glass's own top left shows the picture's top right.
  right.turned = Output::Turned::left;
  EXPECT_EQ(corners(touch_map(outputs, right)), (std::array<float, 4>{0.75f, 0.25f, 0.75f, 0.75f}));
  right.turned = Output::Turned::upside_down;
  EXPECT_EQ(corners(touch_map(outputs, right)), (std::array<float, 4>{0.75f, 0.75f, 0.25f, 0.75f}));
  right.turned = Output::Turned::right;
  EXPECT_EQ(corners(touch_map(outputs, right)), (std::array<float, 4>{0.25f, 0.75f, 0.25f, 0.25f}));
}

}  // namespace
}  // namespace onggi::render::outputs_test
