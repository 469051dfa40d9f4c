#include "kiosk/picture/view/fingers.h"

#include <gtest/gtest.h>

#include <array>

#include "engine/math/random.h"

namespace onggi::view::fingers_test {
namespace {

using Kind = InputEvent::Kind;

TEST(Fingers, EachHasAPlaceOfItsOwnFromDownToUp) {
  Fingers fingers;
  std::vector<InputEvent> out;
  fingers.down(40, 1, 2, 0, out);
  fingers.down(41, 3, 4, 0, out);
  fingers.move(41, 5, 6, 0.1, out);
  fingers.up(40, 7, 8, 0.2, out);
  fingers.down(42, 9, 9, 0.3, out);
  ASSERT_EQ(out.size(), 5u);
  EXPECT_EQ(out[0].finger, 0);
  EXPECT_EQ(out[1].finger, 1);
  EXPECT_EQ(out[2].finger, 1);
  EXPECT_EQ(out[2].kind, Kind::pointer_move);
  EXPECT_EQ(out[2].x, 5);
  EXPECT_EQ(out[3].kind, Kind::pointer_up);
  EXPECT_EQ(out[3].x, 7);
  EXPECT_EQ(out[4].finger, 0);  // the least that is free
}

TEST(Fingers, AFingerOfWhomNothingIsHeardLiftsWhereItWas) {
  Fingers fingers;
  std::vector<InputEvent> out;
  fingers.down(1, 10, 20, 0, out);
  fingers.move(1, 11, 21, 5, out);
  fingers.look_after(5 + Fingers::kLost - 0.1, out);
  EXPECT_TRUE(fingers.any());
  fingers.look_after(5 + Fingers::kLost + 0.1, out);
  EXPECT_FALSE(fingers.any());
  EXPECT_EQ(out.back().kind, Kind::pointer_up);
  EXPECT_EQ(out.back().x, 11);
}

TEST(Fingers, OneThatIsToldTwiceWasLiftedUnheard) {
  Fingers fingers;
  std::vector<InputEvent> out;
  fingers.down(7, 1, 2, 0, out);
  fingers.down(7, 3, 4, 1, out);
  ASSERT_EQ(out.size(), 3u);
  EXPECT_EQ(out[1].kind, Kind::pointer_up);
  EXPECT_EQ(out[2].kind, Kind::pointer_down);
  EXPECT_EQ(out[2].finger, 0);
}

TEST(Fingers, AnEleventhIsLetBe) {
  Fingers fingers;
  std::vector<InputEvent> out;
  for (std::uint32_t id = 0; id < 11; ++id) fingers.down(id, 0, 0, 0, out);
  EXPECT_EQ(out.size(), 10u);
  fingers.move(10, 5, 5, 0, out);
  fingers.up(10, 5, 5, 0, out);
  EXPECT_EQ(out.size(), 10u);
}

// Whatever a glass reports: lost lifts, doubled downs, moves of nobody, a glass unplugged.
TEST(Fingers, InAHundredThousandRandomStreamsNoneSticks) {
  for (std::uint64_t seed = 1; seed <= 100'000; ++seed) {
    Random random(seed);
    Fingers fingers;
    std::array<bool, Fingers::kMost> down{};
    std::vector<InputEvent> out;
    double now = 0;
    const auto pick = [&random](int n) { return static_cast<std::uint32_t>(random.uniform() * n); };
    for (int step = 0; step < 40; ++step) {
      now += random.uniform() < 0.02 ? 25.0 : 0.02;
      const std::uint32_t id = pick(14);
      const auto x = static_cast<float>(pick(1000)), y = static_cast<float>(pick(1000));
      switch (pick(8)) {
        case 0:
        case 1:
        case 2:
          fingers.down(id, x, y, now, out);
          break;
        case 3:
        case 4:
          fingers.move(id, x, y, now, out);
          break;
        case 5:
        case 6:
          fingers.up(id, x, y, now, out);
          break;
        default:
          if (pick(10) == 0) fingers.let_go(out);
          fingers.look_after(now, out);
      }
    }
    fingers.look_after(now + Fingers::kLost + 1, out);
    for (const InputEvent& e : out) {
      ASSERT_LT(e.finger, Fingers::kMost) << "seed " << seed;
      bool& there = down[e.finger];
      ASSERT_EQ(there, e.kind != Kind::pointer_down) << "seed " << seed;
      there = e.kind != Kind::pointer_up;
    }
    for (const bool there : down) ASSERT_FALSE(there) << "seed " << seed;
    ASSERT_FALSE(fingers.any());
  }
}

}  // namespace
}  // namespace onggi::view::fingers_test
