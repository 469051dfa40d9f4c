#include "kiosk/wheel/device/codecs/dual_sense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kiosk/ground/files/crc32.h"

namespace onggi::device::dual_sense::dual_sense_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The payload that both buses carry: sticks, triggers, count, buttons, motion.
void put_payload(Bytes& report, std::size_t at) {
  const Bytes payload{10,   20,   30,   40,   50,   60,   7,    0x28, 0x01, 0x02, 0x00,
                      0,    0,    0,    0,    0x01, 0x00, 0xff, 0xff, 0x00, 0x80, 0x00,
                      0x20, 0x00, 0xe0, 0x01, 0x00, 0x78, 0x56, 0x34, 0x12};
  std::copy(payload.begin(), payload.end(), report.begin() + static_cast<std::ptrdiff_t>(at));
}

Bytes cable() {
  Bytes report(64, 0);
  report[0] = 1;
  put_payload(report, 1);
  return report;
}

/// Seeds the check in another way than the codec does: over one run of bytes.
Bytes with_check(Bytes report, std::uint8_t seed) {
  Bytes all{seed};
  all.insert(all.end(), report.begin(), report.end() - 4);
  put_u32(report, report.size() - 4, files::crc32(all));
  return report;
}

Bytes radio() {
  Bytes report(78, 0);
  report[0] = 0x31;
  put_payload(report, 2);
  return with_check(report, 0xA1);
}

TEST(DualSense, ByCableAndByRadioItSaysTheSame) {
  State by_cable, by_radio;
  ASSERT_EQ(read(cable(), Bus::usb, by_cable), ReportResult::news);
  ASSERT_EQ(read(radio(), Bus::bluetooth, by_radio), ReportResult::news);
  EXPECT_EQ(by_cable, by_radio);
  EXPECT_EQ(by_cable.left, (std::array<std::uint8_t, 2>{10, 20}));
  EXPECT_EQ(by_cable.right, (std::array<std::uint8_t, 2>{30, 40}));
  EXPECT_EQ(by_cable.trigger, (std::array<std::uint8_t, 2>{50, 60}));
  EXPECT_EQ(by_cable.sequence, 7);
  EXPECT_EQ(by_cable.buttons, 0x00020128u);
  EXPECT_NE(by_cable.buttons & kCross, 0u);
  EXPECT_NE(by_cable.buttons & kL1, 0u);
  EXPECT_EQ(by_cable.turn, (std::array<std::int16_t, 3>{1, -1, -32768}));
  EXPECT_EQ(by_cable.pull, (std::array<std::int16_t, 3>{0x2000, -0x2000, 1}));
  EXPECT_EQ(by_cable.time, 0x12345678u);
}

TEST(DualSense, OneBitWrongOnTheRadioIsBroken) {
  const Bytes good = radio();
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    Bytes wrong = good;
    wrong[bit / 8] = static_cast<std::uint8_t>(wrong[bit / 8] ^ (1u << (bit % 8)));
    State state;
    EXPECT_NE(read(wrong, Bus::bluetooth, state), ReportResult::news) << bit;
    EXPECT_EQ(state, State{});
  }
}

TEST(DualSense, OfAnotherLengthItIsBrokenAndItsShortRadioReportIsNothing) {
  State state;
  Bytes shorter = cable();
  shorter.pop_back();
  EXPECT_EQ(read(shorter, Bus::usb, state), ReportResult::broken);
  EXPECT_EQ(read(Bytes(10, 1), Bus::bluetooth, state), ReportResult::nothing);
  EXPECT_EQ(read(Bytes{}, Bus::usb, state), ReportResult::broken);
  EXPECT_EQ(state, State{});
}

TEST(DualSense, TheMotorsOfACableAreSetByFourBytes) {
  const Output out = rumble(Bus::usb, 200, 100, 3);
  ASSERT_EQ(out.size, 63u);
  Bytes expected(63, 0);
  expected[0] = 2;
  expected[1] = 3;
  expected[3] = 100;
  expected[4] = 200;
  EXPECT_EQ(Bytes(out.report().begin(), out.report().end()), expected);
}

TEST(DualSense, ByRadioTheSameWithACountAndACheckSeededForOutput) {
  const Output out = rumble(Bus::bluetooth, 200, 100, 18);
  ASSERT_EQ(out.size, 78u);
  Bytes expected(78, 0);
  expected[0] = 0x31;
  expected[1] = 0x20;
  expected[2] = 0x10;
  expected[3] = 3;
  expected[5] = 100;
  expected[6] = 200;
  EXPECT_EQ(Bytes(out.report().begin(), out.report().end()), with_check(expected, 0xA2));
}

}  // namespace
}  // namespace onggi::device::dual_sense::dual_sense_test
