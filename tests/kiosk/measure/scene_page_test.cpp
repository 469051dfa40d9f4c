#include "kiosk/measure/scene_page.h"

#include <gtest/gtest.h>

namespace onggi::measure {
namespace {

TEST(ScenePage, ASceneIsToldInItsFilesOwnWordsButForWhereToReadOn) {
  EXPECT_EQ(words_of_scene("# For all: soft clay. What each key means: ../README.md.\n# So that "
                           "one learns.\n# More: docs/paper.md.\n\n# a key's\n[clay]\n"),
            "For all: soft clay. So that one learns.");
  EXPECT_EQ(words_of_scene("[clay]\n"), "");
}

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
  QuietOutcome careful;
  careful.looks = {{100, 98, 5, {}, 0}};
  scene.visits.careful = {careful};
  const std::string page = page_of({scene}, "onggi lab scenes");
  for (const char* told :
       {"## soft\nFor everyone.", "friction, kiln", "12.3 us a tick",
        "naive hands, 90 s | 81 points in the median (least 7)", "roughness 0.31 mm",
        "five stars 0 of 24", "a careful hand | 98; five stars 1 of 1", "A machine"})
    EXPECT_NE(page.find(told), std::string::npos) << told << "\n" << page;
}

}  // namespace
}  // namespace onggi::measure
