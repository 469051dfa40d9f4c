#include "kiosk/device/codecs/surface_dial.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

namespace onggi::device::surface_dial {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// As the dial sends it: the turn above the button's bit.
Bytes report_of(bool pressed, int tenths) {
  const auto word = static_cast<std::uint16_t>((tenths << 1) | (pressed ? 1 : 0));
  return {1, static_cast<std::uint8_t>(word & 0xff), static_cast<std::uint8_t>(word >> 8)};
}

TEST(SurfaceDial, AClickAndATurnShareAWord) {
  State state;
  EXPECT_EQ(read(Bytes{1, 0x01, 0x00}, state), Heard::news);
  EXPECT_TRUE(state.pressed);
  EXPECT_EQ(state.turned, 0);
  EXPECT_EQ(read(Bytes{1, 0x14, 0x00}, state), Heard::news);
  EXPECT_FALSE(state.pressed);
  EXPECT_EQ(state.turned, 10);
  EXPECT_EQ(read(Bytes{1, 0xec, 0xff, 9, 9, 9, 9}, state), Heard::news);
  EXPECT_EQ(state.turned, 0);
}

TEST(SurfaceDial, EveryTurnThatFitsComesBackAndAddsUp) {
  EXPECT_TRUE(rc::check([] {
    State state;
    std::int64_t all = 0;
    for (const int turn : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-16384, 16384))) {
      const bool pressed = *rc::gen::arbitrary<bool>();
      all += turn;
      RC_ASSERT(read(report_of(pressed, turn), state) == Heard::news);
      RC_ASSERT(state.pressed == pressed);
    }
    RC_ASSERT(state.turned == all);
  }));
}

TEST(SurfaceDial, AShortReportIsBrokenAndAnotherIdNothing) {
  State state;
  for (const Bytes& report : {Bytes{}, Bytes{1}, Bytes{1, 7}})
    EXPECT_EQ(read(report, state), Heard::broken);
  EXPECT_EQ(read(Bytes{2, 7, 7}, state), Heard::nothing);
  EXPECT_EQ(state, State{});
}

TEST(SurfaceDial, BuzzesAreFiveBytesAndNeverMoreThanTen) {
  EXPECT_EQ(buzz(2), (std::array<std::uint8_t, 5>{1, 2, 3, 0, 0}));
  EXPECT_EQ(buzz(1000)[1], 10);
  EXPECT_EQ(buzz(-1)[1], 1);
}

}  // namespace
}  // namespace onggi::device::surface_dial
