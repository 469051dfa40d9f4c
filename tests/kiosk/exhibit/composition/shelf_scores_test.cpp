#include <gtest/gtest.h>

#include <filesystem>

#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/collection/score/score.h"
#include "tests/support/open_shelf.h"

namespace onggi::exhibit::shelf_scores_test {
namespace {

/// How far the outline of a pot is from that of its vessel, anywhere, in shares of the height.
struct Thrown {
  double points = 0.0, worst = 0.0;
};

/// What a pot scores on the wheel: untouched, or after a hand has followed the vessel's own
/// profile.
Thrown thrown(const content::Vessel& vessel, bool follow) {
  const Profile target =
      scaled(vessel.extracted.profile, workspace_scale(vessel.extracted.profile));
  SceneDef def;
  def.clay = lump_for(target, def);
  auto scene = Scene::create(def);
  EXPECT_TRUE(scene.has_value());
  if (follow) {
    const auto script = make_script("follow", {def, &target, 5, 1.0});
    EXPECT_TRUE(script.has_value());
    const int ticks = static_cast<int>((*script)->duration() * 1000) + 1;
    for (int i = 0; i < ticks; ++i) scene->step((*script)->at(i * 1e-3, scene->clay()), 1e-3);
  }
  const score::Score score = score::judge(target, scene->clay().profile());
  return {score.points, score.measures.outline_worst_firm};
}

void expect_fair_scores(const std::filesystem::path& shelf) {
  const auto catalogue = content::open_shelf(shelf);
  ASSERT_FALSE(catalogue.vessels.empty());
  for (const content::Vessel& vessel : catalogue.vessels) {
    const Thrown lump = thrown(vessel, false);
    EXPECT_LT(lump.points, 40.0) << vessel.id;
    // Saucers and plates stand lower than a fingertip is wide once they fit the wheel.
    const Profile& p = vessel.extracted.profile;
    if (p.height() < p.max_radius() / 3.0) continue;
    // A fingertip of 8 mm cannot follow a foot or a flange that is sharper than itself: who is out
    // by 5 % of the height somewhere has less than 90, and no less than the rest deserves.
    const Thrown pot = thrown(vessel, true);
    EXPECT_GT(pot.points, pot.worst < 0.045 ? 90.0 : pot.worst < 0.12 ? 70.0 : 30.0) << vessel.id;
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
}  // namespace onggi::exhibit::shelf_scores_test
