#include "kiosk/wheel/device/codecs/onggi_hid.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kiosk/ground/files/crc32.h"
#include "tests/kiosk/wheel/device/golden_bytes.h"

namespace onggi::device::onggi_hid::onggi_hid_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes written(const Output& output) {
  const auto bytes = write(output);
  return {bytes.begin(), bytes.end()};
}

TEST(OnggiHid, TheKioskWritesTheGoldenBytes) {
  const auto golden = golden_bytes();
  ASSERT_EQ(golden.size(), 8u);
  Output output;
  output.sequence = 1;
  EXPECT_EQ(written(output), golden.at("output_off"));
  output = {Mode::arm, 2, {}, 0.0, 0.020, 3.3};
  EXPECT_EQ(written(output), golden.at("output_arm"));
  output = {Mode::force, 3, {1.5, -0.25, 0.001}, 0.8, 0.020, 3.3};
  EXPECT_EQ(written(output), golden.at("output_force"));
}

TEST(OnggiHid, TheKioskReadsTheGoldenBytes) {
  const auto golden = golden_bytes();
  Input input;
  ASSERT_EQ(read(golden.at("input_held"), input), ReportResult::news);
  EXPECT_EQ(input.flags, kHasSensor | kHeld | kPowered);
  EXPECT_EQ(input.sequence, 1);
  EXPECT_EQ(input.time, 1000u);
  EXPECT_NEAR(input.position.x, 0.0123456, 1e-12);
  EXPECT_NEAR(input.position.y, -7e-7, 1e-12);
  EXPECT_NEAR(input.position.z, 214.7483647, 1e-9);
  EXPECT_EQ(input.buttons, 5);
  EXPECT_EQ(input.echo, 0);
  ASSERT_EQ(read(golden.at("input_armed"), input), ReportResult::news);
  EXPECT_TRUE(input.flags & kArmed);
  EXPECT_EQ(input.echo, 3);
  ASSERT_EQ(read(golden.at("input_ran_out"), input), ReportResult::news);
  EXPECT_FALSE(input.flags & kArmed);
  EXPECT_EQ(input.status, static_cast<std::uint16_t>(Status::ran_out));
  ASSERT_EQ(read(golden.at("input_suspended"), input), ReportResult::news);
  EXPECT_EQ(input.status, static_cast<std::uint16_t>(Status::suspended));
  Feature feature;
  ASSERT_EQ(read_feature(golden.at("feature"), feature), ReportResult::news);
  EXPECT_EQ(feature.version, 1);
  EXPECT_DOUBLE_EQ(feature.max_force, 5.0);
  EXPECT_DOUBLE_EQ(feature.least.z, -0.1);
  EXPECT_DOUBLE_EQ(feature.most.x, 0.1);
  EXPECT_DOUBLE_EQ(feature.resolution, 5e-6);
  EXPECT_EQ(feature.firmware, 0x0102);
}

TEST(OnggiHid, OneBitWrongAnywhereIsBrokenAndLeavesWhatWasKnown) {
  const auto golden = golden_bytes();
  for (const char* name : {"input_held", "feature"}) {
    const Bytes& good = golden.at(name);
    for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
      Bytes wrong = good;
      wrong[bit / 8] = static_cast<std::uint8_t>(wrong[bit / 8] ^ (1u << (bit % 8)));
      Input input;
      Feature feature;
      EXPECT_NE(read(wrong, input), ReportResult::news) << bit;
      EXPECT_NE(read_feature(wrong, feature), ReportResult::news) << bit;
      EXPECT_EQ(input.time, 0u);
      EXPECT_EQ(feature.max_force, 0.0);
    }
  }
}

TEST(OnggiHid, AShortReportIsBroken) {
  Bytes report = golden_bytes().at("input_held");
  Input input;
  while (!report.empty()) {
    report.pop_back();
    EXPECT_EQ(read(report, input), ReportResult::broken) << report.size();
  }
}

TEST(OnggiHid, NewerIsSignedAndGoesRound) {
  EXPECT_TRUE(newer(3, 0xFFFE));
  EXPECT_FALSE(newer(0xFFFE, 3));
  EXPECT_FALSE(newer(7, 7));
  EXPECT_FALSE(newer(0x8000, 0));
  EXPECT_TRUE(newer(0x7FFF, 0));
}

TEST(OnggiHid, WhateverIsWantedTheBytesAreInRangeAndNoNumberIsNoForce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    const Bytes bytes = written({Mode::force, 1, {bad, bad, bad}, bad, bad, bad});
    for (std::size_t at : {4u, 6u, 8u, 10u, 14u}) EXPECT_EQ(u16_at(bytes, at), 0) << at;
  }
  EXPECT_TRUE(rc::check([] {
    const Vec3 force{*rc::gen::inRange(-90000, 90000) * 1e-3,
                     *rc::gen::inRange(-90000, 90000) * 1e-3, 0.0004};
    const Bytes bytes = written({Mode::force, 9, force, 1.0, 0.020, 5.0});
    RC_ASSERT(std::fabs(i16_at(bytes, 4) * 1e-3 - std::clamp(force.x, -32.767, 32.767)) < 5.1e-4);
    RC_ASSERT(std::fabs(i16_at(bytes, 6) * 1e-3 - std::clamp(force.y, -32.767, 32.767)) < 5.1e-4);
    RC_ASSERT(i16_at(bytes, 8) == 0);
    RC_ASSERT(u32_at(bytes, 16) == files::crc32(Report(bytes).first(16)));
  }));
}

}  // namespace
}  // namespace onggi::device::onggi_hid::onggi_hid_test
