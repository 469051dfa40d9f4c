#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "kiosk/wheel/device/codecs/onggi_hid.h"
#include "kiosk/wheel/device/reference/onggi_hid_device.h"
#include "tests/kiosk/wheel/device/golden_bytes.h"

namespace onggi::device::reference_test {
namespace {

using onggi_hid::Mode;
using onggi_hid::Output;
using onggi_hid::Status;
using Bytes = std::vector<std::uint8_t>;

constexpr onggi_hid_build kBuild{5000,   20, {-1000, -1000, -1000}, {1000, 1000, 1000}, 50,
                                 0x0102, 1};

/// The device that a maker builds, with a hand at it, on a bench.
class Bench {
 public:
  explicit Bench(const onggi_hid_build& build = kBuild) { onggi_hid_start(&device, &build); }
  bool tell(const Output& output) {
    const auto bytes = onggi_hid::write(output);
    return onggi_hid_take(&device, bytes.data(), bytes.size()) != 0;
  }
  /// Off, then armed, then this force.
  void push(Vec3 force, double ttl = 0.020) {
    tell({Mode::off, next++, {}, 0, ttl, 5});
    tick();
    tell({Mode::arm, next++, {}, 0, ttl, 5});
    tell({Mode::force, next++, force, 0, ttl, 5});
  }
  void tick(int ms = 1) {
    for (int n = 0; n < ms; ++n) onggi_hid_tick(&device, 1000, place.data(), held, powered, 0);
  }
  Vec3 force() const {
    std::int32_t f[3];
    onggi_hid_force(&device, f);
    return {f[0] * 1e-3, f[1] * 1e-3, f[2] * 1e-3};
  }
  onggi_hid::Input input() {
    std::uint8_t bytes[ONGGI_HID_INPUT_SIZE];
    onggi_hid_input(&device, bytes);
    onggi_hid::Input said;
    EXPECT_EQ(onggi_hid::read(bytes, said), ReportResult::news);
    return said;
  }

  onggi_hid_device device{};
  std::array<std::int32_t, 3> place{};
  int held = 1, powered = 1;
  std::uint16_t next = 1;
};

TEST(ReferenceDevice, SaysTheGoldenBytes) {
  const auto golden = golden_bytes();
  Bench bench;
  Bytes feature(ONGGI_HID_FEATURE_SIZE), said(ONGGI_HID_INPUT_SIZE);
  onggi_hid_feature(&bench.device, feature.data());
  EXPECT_EQ(feature, golden.at("feature"));
  const std::int32_t place[3] = {123456, -7, 2147483647};
  const auto say = [&](int ms, std::uint16_t buttons) {
    for (int n = 0; n < ms; ++n) onggi_hid_tick(&bench.device, 1000, place, 1, 1, buttons);
    onggi_hid_input(&bench.device, said.data());
    return said;
  };
  const auto take = [&](const char* name) {
    return onggi_hid_take(&bench.device, golden.at(name).data(), golden.at(name).size());
  };
  EXPECT_EQ(say(1, 5), golden.at("input_held"));
  EXPECT_TRUE(take("output_off") && take("output_arm") && take("output_force"));
  EXPECT_EQ(say(1, 5), golden.at("input_armed"));
  EXPECT_EQ(say(20, 0), golden.at("input_ran_out"));
  onggi_hid_suspend(&bench.device);
  EXPECT_EQ(say(0, 0), golden.at("input_suspended"));
}

TEST(ReferenceDevice, PushesOnlyOnceArmedAndArmsOnlyWhereAHandIs) {
  Bench bench;
  bench.tick();
  EXPECT_FALSE(bench.tell({Mode::force, 1, {1, 0, 0}, 0, 0.02, 5}));
  EXPECT_EQ(bench.input().status, static_cast<int>(Status::not_armed));
  EXPECT_EQ(bench.force(), Vec3{});
  bench.held = 0;
  bench.tick();
  EXPECT_FALSE(bench.tell({Mode::arm, 2, {}, 0, 0.02, 5}));
  EXPECT_EQ(bench.input().status, static_cast<int>(Status::not_held));
  bench.held = 1;
  bench.tick();
  EXPECT_FALSE(bench.tell({Mode::arm, 3, {0.5, 0, 0}, 0, 0.02, 5})) << "arming pushes nothing";
  EXPECT_TRUE(bench.tell({Mode::arm, 4, {}, 0, 0.02, 5}));
  EXPECT_TRUE(bench.tell({Mode::force, 5, {1, 0, 0}, 0, 0.02, 5}));
  EXPECT_EQ(bench.force().x, 1.0);
  bench.powered = 0;
  bench.tick();
  EXPECT_EQ(bench.force(), Vec3{}) << "an emergency stop is seen";
}

// The kiosk is killed, hangs, or its cable is cut: nothing more comes.
TEST(ReferenceDevice, EndsItsForceByItselfWhenTheKioskFallsSilent) {
  Bench bench;
  bench.push({3, -4, 0});
  for (int ms = 1; ms < 20; ++ms) {
    bench.tick();
    EXPECT_NEAR(length(bench.force()), 5.0, 2e-3) << ms;
  }
  double before = length(bench.force());
  for (int ms = 20; ms < 41; ++ms) {
    bench.tick();
    EXPECT_LE(length(bench.force()), before);
    before = length(bench.force());
  }
  EXPECT_EQ(bench.force(), Vec3{});
  EXPECT_EQ(bench.input().status, static_cast<int>(Status::ran_out));
  EXPECT_FALSE(bench.tell({Mode::force, 100, {1, 0, 0}, 0, 0.02, 5}))
      << "it wants to be armed anew";
}

TEST(ReferenceDevice, OffAndSuspendAreAtOnce) {
  Bench bench;
  bench.push({3, 0, 0});
  EXPECT_TRUE(bench.tell({Mode::off, 0, {}, 0, 0.02, 5})) << "whatever its sequence";
  EXPECT_EQ(bench.force(), Vec3{});
  bench.push({3, 0, 0});
  onggi_hid_suspend(&bench.device);
  EXPECT_EQ(bench.force(), Vec3{});
  EXPECT_FALSE(bench.tell({Mode::arm, 900, {}, 0, 0.02, 5}));
  onggi_hid_resume(&bench.device);
  EXPECT_EQ(bench.force(), Vec3{});
  EXPECT_TRUE(bench.tell({Mode::arm, 901, {}, 0, 0.02, 5}));
}

TEST(ReferenceDevice, AReplayedOrLateReportNeitherPushesNorKeepsAForceAlive) {
  Bench bench;
  bench.push({1, 0, 0});
  const auto old = onggi_hid::write(
      {Mode::force, static_cast<std::uint16_t>(bench.next - 1), {5, 0, 0}, 0, 0.02, 5});
  for (int ms = 0; ms < 45; ++ms) {
    EXPECT_FALSE(onggi_hid_take(&bench.device, old.data(), old.size()));
    EXPECT_LE(bench.force().x, 1.0);
    bench.tick();
  }
  EXPECT_EQ(bench.force(), Vec3{});
}

TEST(ReferenceDevice, OneBitWrongInAnyReportIsNoReport) {
  Bench bench;
  bench.push({1, 0, 0});
  const auto good = onggi_hid::write({Mode::force, bench.next, {4, 0, 0}, 0, 0.02, 5});
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    auto wrong = good;
    wrong[bit / 8] = static_cast<std::uint8_t>(wrong[bit / 8] ^ (1u << (bit % 8)));
    EXPECT_FALSE(onggi_hid_take(&bench.device, wrong.data(), wrong.size())) << bit;
    EXPECT_EQ(bench.force().x, 1.0);
  }
  for (std::size_t size = 0; size < 20; ++size)
    EXPECT_FALSE(onggi_hid_take(&bench.device, good.data(), size));
  EXPECT_TRUE(onggi_hid_take(&bench.device, good.data(), good.size()));
}

TEST(ReferenceDevice, WhateverIsToldAndHoweverTheHandleFliesItStaysUnderCapAndBuild) {
  EXPECT_TRUE(rc::check([] {
    Bench bench;
    bench.tick();
    double cap = 0;
    for (int n = 0; n < 40; ++n) {
      for (std::int32_t& axis : bench.place) axis = *rc::gen::inRange(-2000000, 2000000);
      const auto mode = static_cast<Mode>(*rc::gen::inRange(0, 3));
      const double wanted_cap = 1e-3 * *rc::gen::inRange(0, 9000);
      Output output{mode,
                    bench.next++,
                    {},
                    1e-3 * *rc::gen::inRange(0, 65535),
                    1e-3 * *rc::gen::inRange(0, 30),
                    wanted_cap};
      if (mode == Mode::force)
        output.force = {1e-3 * *rc::gen::inRange(-32000, 32000),
                        1e-3 * *rc::gen::inRange(-32000, 32000),
                        1e-3 * *rc::gen::inRange(-32000, 32000)};
      if (bench.tell(output) && mode == Mode::force) cap = wanted_cap;
      bench.tick(*rc::gen::inRange(0, 25));
      RC_ASSERT(length(bench.force()) <= std::min(cap, 5.0) + 1e-9);
    }
  }));
}

TEST(ReferenceDevice, DampingWorksAgainstTheHandlesSpeed) {
  Bench bench;
  bench.push({0, 0, 0});
  bench.tell({Mode::force, bench.next++, {}, 2.0, 0.1, 5});
  for (int ms = 0; ms < 30; ++ms) {
    bench.place[0] += 1000;  // 0.1 m/s
    bench.tick();
  }
  EXPECT_NEAR(bench.force().x, -0.2, 0.004);
  EXPECT_EQ(bench.force().y, 0.0);
}

TEST(ReferenceDevice, IsPlainC99ForAnyCompiler) {
  if (std::system("command -v cc >/dev/null 2>&1") != 0) GTEST_SKIP() << "no C compiler here";
  EXPECT_EQ(std::system("cc -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror "
                        "-fsyntax-only kiosk/wheel/device/reference/onggi_hid_device.c"),
            0);
}

}  // namespace
}  // namespace onggi::device::reference_test
