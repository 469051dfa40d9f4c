#include "tests/kiosk/visit/screens/layout_check.h"

#include <gtest/gtest.h>

#include "kiosk/visit/screens/comfort.h"
#include "kiosk/visit/screens/layout.h"

namespace onggi::screens::layout_test {
namespace {

constexpr std::pair<int, int> kSizes[] = {{1280, 720}, {1920, 1080}, {1080, 1920}, {1024, 600}};

void check_all(const std::function<void(settings::Exhibit::Screen&)>& choose) {
  for (const auto& [width, height] : kSizes) {
    for (const bool korean : {false, true}) {
      Visitor v(9, nullptr, true);
      v.width = width;
      v.height = height;
      choose(v.exhibit.screen);
      v.put_tools_to_hand();
      v.keep_today(30);
      v.show();
      if (korean) v.speak("ko");
      walk(v, [&](const std::string& name) { check_layout(v, v.plain, name); });
    }
  }
}

TEST(Layout, NothingIsCutAndNothingOverlapsAtAnySizeInEitherLanguage) {
  check_all([](settings::Exhibit::Screen&) {});
}
TEST(Layout, NorForLeftHands) {
  check_all([](settings::Exhibit::Screen& screen) { screen.left_handed = true; });
}

TEST(Layout, NorForWhoeverNeedsLargerText) {
  check_all([](settings::Exhibit::Screen& screen) { screen.larger_text = true; });
}
TEST(Layout, ATitleIsNeverSmallerThanTheWordsBelowIt) {
  for (const auto& [width, height] : kSizes)
    for (const bool larger : {false, true})
      for (int step = 0; step <= kLastGiveWay; ++step) {
        settings::Exhibit::Screen screen;
        screen.larger_text = larger;
        const TypeScale t = type_scale(screen, width, height, give_way(step, false));
        EXPECT_GT(t.lead, t.body) << width << ", step " << step;
        EXPECT_GE(t.title, t.lead) << width << ", step " << step;
        EXPECT_GE(t.display, t.title) << width << ", step " << step;
      }
}

TEST(Layout, NorWithAllThatAVisitorMayChooseAtOnce) {
  check_all([](settings::Exhibit::Screen& screen) {
    screen.lower_edge_mm = 1000;  // of a landscape screen the upper quarter is out of reach
    for (const Comfort::Choice& choice : Comfort::kChoices) screen.*choice.of = true;
  });
}

TEST(Layout, NorWithADeviceThatPushes) {
  for (const auto& [width, height] : {kSizes[2], kSizes[3]})
    for (const bool korean : {false, true}) {
      Visitor v(9);
      v.width = width;
      v.height = height;
      v.news.device_in_use(device::DeviceKind::onggi_hid, true);
      v.show();
      if (korean) v.speak("ko");
      v.throw_a_pot();
      v.touch("throw.wheel");
      ASSERT_TRUE(v.visit->control("throw.softer"));
      check_layout(v, v.plain, "throw, with force");
    }
}

TEST(Layout, BodyTextHasCapitalsOfSevenTenthsOfADegreeWhereTheScreenHasRoom) {
  settings::Exhibit::Screen screen;
  screen.viewing_distance_mm = 500;
  const TypeScale t = type_scale(screen, 1920, 1080);
  const double px_per_mm = std::hypot(1920, 1080) / screen.diagonal_mm;
  EXPECT_NEAR(static_cast<double>(t.body) * 0.714 / px_per_mm,
              2 * 500 * std::tan(0.35 * 3.14159265 / 180), 0.15);
  screen.viewing_distance_mm = 3000;
  EXPECT_LE(type_scale(screen, 1920, 1080).body, 1080 / 28.0f + 0.01f);
}

TEST(Layout, APotStandsOnTheThirdInLandscapeAndOnTheCentreLineInPortrait) {
  const Regions wide = regions({0, 0, 1920, 1080}, 65, false);
  EXPECT_NEAR(wide.pot.x + wide.pot.w / 2, 1280, 1);
  const Regions mirrored = regions({0, 0, 1920, 1080}, 65, true);
  EXPECT_NEAR(mirrored.pot.x + mirrored.pot.w / 2, 640, 1);
  const Regions tall = regions({0, 0, 1080, 1920}, 65, false);
  EXPECT_NEAR(tall.pot.x + tall.pot.w / 2, 540, 1);
  EXPECT_LT(tall.pot.y + tall.pot.h, tall.words.y);
}

}  // namespace
}  // namespace onggi::screens::layout_test
