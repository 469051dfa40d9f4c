#include "tests/support/force_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::test::force_quality_test {
namespace {

/// `seconds` of a sine of `hertz` on a newton, late by `late` ms.
std::vector<Vec3> sine(double hertz, double late, double size = 0.5) {
  std::vector<Vec3> force;
  for (int ms = 0; ms < 1600; ++ms)
    force.push_back({1.0 + size * std::sin(2e-3 * 3.14159265358979 * hertz * (ms - late)), 0, 0});
  return force;
}

TEST(ForceQuality, KnowsASineByItsIncrementItsSpectrumAndItsLag) {
  const auto now = sine(3.0, 0.0), late = sine(3.0, 7.5);
  const ForceQuality slow = quality_of(late, now);
  EXPECT_NEAR(slow.lag, 7.5e-3, 2e-4);
  EXPECT_NEAR(slow.mean, 1.0, 0.1);
  EXPECT_NEAR(slow.increment, 0.5 * 2e-3 * 3.14159265 * 3.0 / std::sqrt(2.0), 4e-4);
  EXPECT_LT(slow.above_50, 2e-3);
  const auto fast = sine(200.0, 0.0, 0.01);
  EXPECT_NEAR(quality_of(fast, fast).above_50, 0.01 / std::sqrt(2.0), 5e-4);
  auto both = late;
  for (std::size_t n = 0; n < both.size(); ++n) both[n].x += fast[n].x;
  const ForceQuality rough = quality_of(both, both);
  EXPECT_NEAR(rough.own, slow.increment, 0.1 * slow.increment);
  EXPECT_NEAR(rough.increment,
              std::hypot(slow.increment, 0.01 * std::sin(0.2 * 3.14159265) * std::sqrt(2.0)), 3e-4);
}

TEST(ForceQuality, ThePapersFilterIsTwentyTwoMillisecondsLate) {
  const PrintedQuality printed = printed_quality(SceneDef());
  EXPECT_NEAR(printed.raw.lag, 0.0, 1e-4);
  EXPECT_NEAR(printed.filtered.lag, 0.0225, 0.001);
  EXPECT_LT(printed.filtered.increment, printed.raw.increment);
}

TEST(ForceQuality, AScenesForceIsLateByLessThanTwoMilliseconds) {
  SceneDef def;
  def.clay.keep_undo = false;
  const ForceQuality ours = scenes_quality(def, 0);
  EXPECT_GT(ours.mean, 0.1);
  EXPECT_LT(std::fabs(ours.lag), 0.002);
}

// What a hand at a device that bears 257 N/m feels of a scene, beside the printed model's force on
// the same clay.
void expect_smooth_and_in_time(const SceneDef& def, std::size_t tool, double tremble) {
  const PrintedQuality printed = printed_quality(def);
  const ForceQuality ours = scenes_quality(def, static_cast<std::uint8_t>(tool), 257.0);
  EXPECT_GT(ours.mean, 0.01) << tool;
  // In newtons, or where the force is larger than the paper's as a share of it.
  const double share = std::max(1.0, ours.mean / printed.filtered.mean);
  EXPECT_LT(ours.increment, share * printed.filtered.increment) << tool;
  EXPECT_LT(ours.above_50, tremble * printed.raw.above_50) << tool;
  EXPECT_LT(ours.lag, 0.001) << tool;
  EXPECT_GT(ours.lag, -0.002) << tool;
}

TEST(ForceQuality, AtTheHandOfADeviceEveryToolIsSmootherThanThePapersBehindItsFilterAndInTime) {
  SceneDef def;
  def.clay.keep_undo = false;
  for (std::size_t tool = 0; tool <= def.tools.size(); ++tool) {
    if (tool > 0 && def.tools[tool - 1].name == "wire") continue;
    // What elements that come under a tool shake it by: of a disc's or a plate's hardly anything.
    const bool even = tool > 0 && (def.tools[tool - 1].name == "curved_rib" ||
                                   def.tools[tool - 1].name == "flat_rib");
    expect_smooth_and_in_time(def, tool, even ? 0.04 : 0.2);
  }
}

TEST(ForceQuality, ALumpThatIsCentredUnderTheToolIsSmoothToo) {
  SceneDef def;
  def.clay.keep_undo = false;
  def.clay.rows = 600;
  def.contact = {0.015, 1e7};
  def.wobble.emplace().off_centre = 0.003;
  expect_smooth_and_in_time(def, 0, 0.5);
}

}  // namespace
}  // namespace onggi::test::force_quality_test
