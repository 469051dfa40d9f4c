#include "kiosk/lab/measure/soak_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace onggi::measure::soak_report_test {
namespace {

using ::testing::HasSubstr;

/// 72 hours, a sample each quarter of one.
SoakReport soaked(const std::function<void(SoakSample&)>& shape = [](SoakSample&) {}) {
  SoakReport report;
  report.hours = 72;
  report.visits = 432;
  report.kept = 300;
  for (double hours = 0.25; hours <= 72; hours += 0.25) {
    SoakSample at;
    at.hours = hours;
    // Caches fill in the first hours; then it goes up and down by some MiB.
    at.memory = 300 - 60 * std::exp(-hours / 3) + 3 * std::sin(40 * hours);
    at.in_use = 200 - 40 * std::exp(-hours / 3);
    at.descriptors = 14;
    at.threads = 10;
    at.wake_us = 200;
    at.tick_us = 30;
    shape(at);
    report.samples.push_back(at);
  }
  return report;
}

TEST(SoakReport, MemoryThatFillsItsCachesAndComesToRestIsGood) {
  const SoakReport report = soaked();
  EXPECT_NEAR(report.memory_slope(), 0.0, 0.2);
  EXPECT_TRUE(report.good());
  EXPECT_THAT(text_of(report), HasSubstr("\nGood.\n"));
}

TEST(SoakReport, MemoryThatGrowsIsTheSlopeItGrowsBy) {
  const SoakReport report = soaked([](SoakSample& at) { at.memory += 1.5 * at.hours / 24; });
  EXPECT_NEAR(report.memory_slope(), 1.5, 0.2);
  EXPECT_FALSE(report.good());
  EXPECT_NEAR(report.in_use_slope(), 0.0, 0.2) << "holes, and nothing that is kept";
  EXPECT_THAT(text_of(report), HasSubstr("MiB a day (at most 1), and what of it is in use +0.0"));
  // One postcard in the making is no slope.
  const SoakReport once = soaked([](SoakSample& at) { at.memory += at.hours == 70 ? 80 : 0; });
  EXPECT_TRUE(once.good());
}

TEST(SoakReport, ADescriptorOrAThreadThatIsNotGivenBackIsNotGood) {
  const SoakReport leaks = soaked([](SoakSample& at) { at.descriptors += at.hours > 60; });
  EXPECT_EQ(leaks.more_descriptors(), 1);
  EXPECT_FALSE(leaks.good());
  const SoakReport more = soaked([](SoakSample& at) { at.threads += at.hours > 60; });
  EXPECT_EQ(more.more_threads(), 1);
  EXPECT_FALSE(more.good());
}

TEST(SoakReport, ALoopThatGetsSlowerIsToldAsSo) {
  const SoakReport report = soaked([](SoakSample& at) { at.tick_us *= 1 + at.hours / 72; });
  EXPECT_NEAR(report.tick_ratio(), 1.875 / 1.125, 0.02);
  EXPECT_EQ(report.wake_ratio(), 1.0);
}

TEST(SoakReport, OneThingLostIsEnough) {
  for (int SoakReport::*figure :
       {&SoakReport::lost, &SoakReport::dead_ends, &SoakReport::unexplained}) {
    SoakReport report = soaked();
    report.*figure = 1;
    EXPECT_FALSE(report.good());
  }
  SoakReport none = soaked();
  none.visits = 0;
  EXPECT_FALSE(none.good()) << "who saw no visit saw nothing";
}

}  // namespace
}  // namespace onggi::measure::soak_report_test
