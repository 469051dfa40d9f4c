#include "kiosk/lab/measure/scene_page.h"

#include <gtest/gtest.h>

namespace onggi::measure::scene_page_test {
namespace {

TEST(ScenePage, TellsWordsEffectsCostAndBothHands) {
  SceneEntry scene;
  scene.name = "soft";
  scene.words = "For everyone.";
  scene.effects = {"friction", "kiln"};
  scene.bill.machine = "A machine";
  scene.bill.whole_us = 12.3;
  scene.bill.contact_us = 4;
  NaiveLine line;
  line.vessel = "all";
  line.seconds = 90;
  line.visits = 24;
  line.points = 81;
  line.least_points = 7;
  line.roughness = 0.00031;
  scene.visits.lines = {line};
  HeadlessOutcome careful;
  careful.looks = {{100, 98, 5, {}, 0}};
  scene.visits.careful = {careful};
  careful.looks = {{100, 91, 4, {}, 0}};
  scene.visits.careful.push_back(careful);
  const std::string page = page_of({scene}, {"onggi lab scenes", "2026-11-22", "abc1234"});
  for (const char* told :
       {"gives\n\nFor curators and for whoever wonders what a scene costs.\n\nMade by",
        "## soft\nFor everyone.", "friction, kiln", "12.3 of a tick's 1000 us",
        "naive hands, 90 s | 81 points in the median (least 7)", "roughness 0.31 mm",
        "five stars 0 of 24", "a careful hand | 94; five stars 1 of 2",
        "Made by `onggi lab scenes` on A machine, 2026-11-22, of commit abc1234."})
    EXPECT_NE(page.find(told), std::string::npos) << told << "\n" << page;
  EXPECT_EQ(page.find("Not for a first pot"), std::string::npos);
}

TEST(ScenePage, ASceneInWhichPeopleFailAtFirstSaysSoInWords) {
  SceneEntry scene;
  scene.name = "hard";
  NaiveLine line;
  line.vessel = "moon_jar";
  line.points = 2;
  scene.visits.lines = {line};
  line.vessel = "all";
  line.seconds = 90;
  line.points = 11;
  scene.visits.lines.push_back(line);
  const std::string page = page_of({scene}, {"onggi lab scenes", "2026-11-22", ""});
  EXPECT_NE(page.find("half of those who never threw get 11 points of 100 or fewer in 90 s"),
            std::string::npos)
      << page;
  EXPECT_EQ(page.find("get 2 points"), std::string::npos) << "of all vessels, once";
  EXPECT_EQ(page.find("commit"), std::string::npos);
}

}  // namespace
}  // namespace onggi::measure::scene_page_test
