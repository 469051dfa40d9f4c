#include "kiosk/wheel/device/codecs/space_mouse.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <initializer_list>
#include <vector>

namespace onggi::device::space_mouse::space_mouse_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(SpaceMouse, ASplitPuckSendsItsPushAndItsTwistInTwoReports) {
  State state;
  EXPECT_EQ(read(Bytes{1, 0x5e, 0x01, 0xa2, 0xfe, 0x05, 0x00}, state), ReportResult::news);
  EXPECT_EQ(state.push, (std::array<std::int16_t, 3>{350, -350, 5}));
  EXPECT_EQ(state.twist, (std::array<std::int16_t, 3>{0, 0, 0}));
  EXPECT_EQ(read(Bytes{2, 0x01, 0x00, 0xff, 0xff, 0x2c, 0x01}, state), ReportResult::news);
  EXPECT_EQ(state.push, (std::array<std::int16_t, 3>{350, -350, 5}));
  EXPECT_EQ(state.twist, (std::array<std::int16_t, 3>{1, -1, 300}));
}

TEST(SpaceMouse, ACombinedReportIsKnownByItsLengthNotByTheDevice) {
  State state;
  EXPECT_EQ(read(Bytes{1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0}, state), ReportResult::news);
  EXPECT_EQ(state.push, (std::array<std::int16_t, 3>{1, 2, 3}));
  EXPECT_EQ(state.twist, (std::array<std::int16_t, 3>{4, 5, 6}));
}

TEST(SpaceMouse, ButtonsAreABitEachAndTheBatteryAPercentage) {
  State state;
  EXPECT_EQ(read(Bytes{3, 0x02, 0x80}, state), ReportResult::news);
  EXPECT_EQ(state.buttons, 0x8002u);
  EXPECT_EQ(read(Bytes{0x17, 100, 1}, state), ReportResult::news);
  EXPECT_EQ(state.battery, 100);
  EXPECT_EQ(light(true), (std::array<std::uint8_t, 2>{4, 1}));
}

TEST(SpaceMouse, AShortReportIsBrokenAndLeavesThePuckWhereItWas) {
  for (const std::uint8_t id : std::initializer_list<std::uint8_t>{1, 2}) {
    State state;
    for (std::size_t size = 1; size < 16; ++size) {
      if (size == 7 || (id == 1 && size == 13)) continue;
      Bytes report(size, 0x11);
      report[0] = id;
      EXPECT_EQ(read(report, state), ReportResult::broken) << int(id) << " of " << size;
      EXPECT_EQ(state, State{});
    }
  }
  State state;
  EXPECT_EQ(read(Bytes{}, state), ReportResult::broken);
  EXPECT_EQ(read(Bytes{3}, state), ReportResult::broken);
  EXPECT_EQ(read(Bytes{9, 1, 2, 3, 4, 5, 6}, state), ReportResult::nothing);
}

TEST(SpaceMouse, WhateverComesNoAxisIsBeyondItsRange) {
  EXPECT_TRUE(rc::check([] {
    State state;
    const auto report = *rc::gen::container<Bytes>(rc::gen::arbitrary<std::uint8_t>());
    read(report, state);
    for (const auto& axes : {state.push, state.twist})
      for (const std::int16_t value : axes) RC_ASSERT(value >= -kFull && value <= kFull);
  }));
  State state;
  read(Bytes{1, 0xff, 0x7f, 0x00, 0x80, 0, 0}, state);
  EXPECT_EQ(state.push, (std::array<std::int16_t, 3>{350, -350, 0}));
}

}  // namespace
}  // namespace onggi::device::space_mouse::space_mouse_test
