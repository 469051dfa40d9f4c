#include "kiosk/wheel/device/codecs/surface_dial.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

namespace onggi::device::surface_dial::surface_dial_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A field of the dial's input report, as the device's own report descriptor lays them out: where
/// it begins and how long it is, in bits.
struct Field {
  std::size_t at, size;
};
constexpr Field kButton{8, 1}, kTouch{9, 1}, kDial{16, 16}, kWidth{64, 8};
constexpr std::size_t kLength = 9;

void put(Bytes& report, const Field& field, int value) {
  for (std::size_t n = 0; n < field.size; ++n)
    if ((value >> n & 1) != 0)
      report[(field.at + n) / 8] =
          static_cast<std::uint8_t>(report[(field.at + n) / 8] | 1 << (field.at + n) % 8);
}

Bytes report_of(bool pressed, bool touched, int counts) {
  Bytes report(kLength, 0);
  report[0] = 1;
  put(report, kButton, pressed);
  put(report, kTouch, touched);
  put(report, kDial, counts);
  put(report, kWidth, 58);
  return report;
}

TEST(SurfaceDial, AClickIsAClickAndAHandThatRestsOnItIsNone) {
  State state;
  EXPECT_EQ(read(report_of(true, true, 0), state), ReportResult::news);
  EXPECT_TRUE(state.pressed);
  EXPECT_EQ(state.turned, 0);
  EXPECT_EQ(read(report_of(false, true, 10), state), ReportResult::news);
  EXPECT_FALSE(state.pressed);
  EXPECT_EQ(state.turned, 10);
  EXPECT_EQ(read(Bytes{1, 0, 0xff, 0xff}, state), ReportResult::news);
  EXPECT_EQ(state.turned, 9) << "one step back";
}

TEST(SurfaceDial, ATurnHasAsManyCountsAsItSaysAndElse3600) {
  EXPECT_EQ(counts_a_turn(Bytes{1, 0x48, 0x00, 0, 3, 5, 80, 0}), 72);
  EXPECT_EQ(counts_a_turn(Bytes{1, 0x10, 0x0e, 0, 2, 0, 0, 0}), 3600);
  for (const Bytes& feature : {Bytes{}, Bytes{1, 9}, Bytes{2, 9, 0}, Bytes{1, 0, 0},
                               Bytes{1, 0x11, 0x0e}, Bytes{1, 0xff, 0xff}})
    EXPECT_EQ(counts_a_turn(feature), 3600);
}

TEST(SurfaceDial, EveryTurnThatFitsComesBackAndAddsUp) {
  EXPECT_TRUE(rc::check([] {
    State state;
    std::int64_t all = 0;
    for (const int turn : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-32767, 32768))) {
      const bool pressed = *rc::gen::arbitrary<bool>();
      all += turn;
      RC_ASSERT(read(report_of(pressed, false, turn), state) == ReportResult::news);
      RC_ASSERT(state.pressed == pressed);
    }
    RC_ASSERT(state.turned == all);
  }));
}

TEST(SurfaceDial, AShortReportIsBrokenAndAnotherIdNothing) {
  State state;
  for (const Bytes& report : {Bytes{}, Bytes{1}, Bytes{1, 7}, Bytes{1, 7, 7}})
    EXPECT_EQ(read(report, state), ReportResult::broken);
  EXPECT_EQ(read(Bytes{2, 7, 7}, state), ReportResult::nothing);
  EXPECT_EQ(state, State{});
}

TEST(SurfaceDial, BuzzesAreFiveBytesAndNeverMoreThanTen) {
  EXPECT_EQ(buzz(2), (std::array<std::uint8_t, 5>{1, 2, 3, 0, 0}));
  EXPECT_EQ(buzz(1000)[1], 10);
  EXPECT_EQ(buzz(-1)[1], 1);
}

}  // namespace
}  // namespace onggi::device::surface_dial::surface_dial_test
