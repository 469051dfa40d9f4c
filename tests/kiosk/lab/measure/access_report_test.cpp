#include "kiosk/lab/measure/access_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::measure::access_report_test {
namespace {

ScreenAccess screen(const std::string& name, double capital, double text, double control,
                    double target) {
  ScreenAccess one;
  one.name = name;
  one.texts = one.controls = 1;
  one.least_capital_mm = capital;
  one.least_text_contrast = text;
  one.least_control_contrast = control;
  one.least_target_mm = target;
  return one;
}

AccessReport report(std::vector<ScreenAccess> screens) {
  AccessReport out;
  out.display = {1920, 1080, 600, 600};
  out.screens = std::move(screens);
  return out;
}

TEST(AccessReport, CapitalsAreAskedAsTheStandardHasThem) {
  EXPECT_NEAR(capital_asked(600), 7.33, 0.005);
  EXPECT_NEAR(capital_asked(800), 9.77, 0.005);
}

TEST(AccessReport, ALineOfTheTableHasTheLeastOfAllScreensAndWhichItIs) {
  const std::string table =
      table_of({report({screen("attract", 7.4, 9, 4.6, 20), screen("label", 7.5, 5.61, 7, 16.3),
                        screen("throw", 7.6, 6, 8, 18)})});
  EXPECT_NE(table.find("| 1920x1080 | 600 mm, 600 mm | 7.3 mm | 7.4 mm | 5.6:1, label | 4.6:1, "
                       "attract | 16.3 mm |\n"),
            std::string::npos)
      << table;
  EXPECT_EQ(table.find("**"), std::string::npos) << table;
}

TEST(AccessReport, WhatIsShortStandsInBoldWithWhereItIs) {
  const std::string table =
      table_of({report({screen("throw", 7.4, 9, 9, 20), screen("label", 6.9, 4.4, 2.9, 14.8)})});
  for (const char* told :
       {"**6.9 mm**, label", "**4.4:1**, label", "**2.9:1**, label", "**14.8 mm**"})
    EXPECT_NE(table.find(told), std::string::npos) << told << "\n" << table;
}

TEST(AccessReport, AScreenWithoutWordsOrControlsIsNotTheLeast) {
  const std::string table =
      table_of({report({screen("throw", 7.4, 9, 9, 20), screen("dark", 0, 0, 0, 0)})});
  EXPECT_EQ(table.find("dark"), std::string::npos) << table;
}

TEST(AccessReport, EveryLikelyDisplayHasRoomForWordsOfTheSizeThatItsDistanceAsks) {
  ASSERT_GE(likely_displays().size(), 5u);
  bool upright = false, across = false, large = false;
  for (const AccessDisplay& display : likely_displays()) {
    upright = upright || display.height > display.width;
    across = across || display.width > display.height;
    large = large || display.width >= 3840;
    // A line of 28 such words high is the least that the screens are laid out on.
    const double mm = display.diagonal_mm / std::hypot(display.width, display.height);
    EXPECT_GE(mm * std::min(display.width, display.height) / 28 * 0.714,
              capital_asked(display.distance_mm))
        << display.width << 'x' << display.height;
  }
  EXPECT_TRUE(upright && across && large);
}

TEST(AccessReport, FlashesAreToldWhereTheyWereWatchedForAndNowhereElse) {
  AccessReport one = report({screen("attract", 7.4, 9, 9, 20), screen("label", 7.4, 9, 9, 20)});
  one.screens.front().flashes = 0;
  const std::string json = json_of(one).text();
  const auto first = json.find("flashes_in_a_second");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(json.find("flashes_in_a_second", first + 1), std::string::npos);
}

}  // namespace
}  // namespace onggi::measure::access_report_test
