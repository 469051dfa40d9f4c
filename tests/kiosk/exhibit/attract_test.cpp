#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/scene/lump.h"
#include "engine/script/script.h"
#include "kiosk/content/catalogue.h"
#include "kiosk/exhibit/scenes.h"
#include "kiosk/loop/stepped_potter.h"
#include "kiosk/measure/handsome.h"
#include "kiosk/score/score.h"
#include "kiosk/screens/demonstration.h"

namespace onggi::exhibit {
namespace {

constexpr double kSmooth = 0.0003;  // m: what people call smooth
// m above that, and above the turns of the vessel itself, in the middle of throwing: a press that
// is under way has an upper and a lower edge. Scripts that went three times as fast left 4.3 mm.
constexpr double kUnderWay = 0.0002;
// Of the vessel's own turns: where a flat shoulder turns up into a neck, palms of 18 mm come to it
// steeper for a while than it is.
constexpr double kSteeper = 1.4;

// The outline as it stands against the light on one side: a screw thread is no ridge of the mean.
Profile silhouette(const ClayView& clay, int sector) {
  Profile side;
  for (int j = 0; j < clay.rows(); ++j) {
    const auto s = static_cast<std::size_t>(sector);
    side.points.push_back({clay.row_height(j), clay.outer(j)[s], clay.inner(j)[s]});
  }
  return side;
}

double roughest(const ClayView& clay) {
  double worst = 0;
  for (int n = 0; n < 4; ++n)
    worst =
        std::max(worst, measure::smoothness(silhouette(clay, n * clay.sectors() / 4)).roughness);
  return worst;
}

struct Pot {
  Profile target;
  SceneDef scene;
};

// On a grid that is coarse about the axis, where nothing of this happens.
Pot pot_of(const content::Vessel& vessel, const Scenes& scenes) {
  const Profile& own = vessel.extracted.profile;
  Pot pot{scaled(own, workspace_scale(own)), scenes.of(vessel.id)};
  pot.scene.clay.rows = 240;
  pot.scene.clay.sectors = 24;
  pot.scene.clay = lump_for(pot.target, pot.scene);
  return pot;
}

TEST(Attract, APotterThrowsEveryVesselOfTheShelfAndNoMomentOfItShowsAScrewThread) {
  const settings::ExhibitRead read = settings::read_exhibit("config/exhibit.toml");
  const Scenes scenes(read.exhibit);
  double points = 0;
  const auto shelf = content::open_shelf("content/vessels");
  ASSERT_GE(shelf.vessels.size(), 12u);
  for (const content::Vessel& vessel : shelf.vessels) {
    const Pot pot = pot_of(vessel, scenes);
    loop::SteppedPotter potter;
    potter.start(std::make_unique<Scene>(std::move(*Scene::create(pot.scene))));
    screens::Demonstration show(scenes.wheel_of(vessel.id), false);
    const double most =
        kUnderWay + std::max(kSmooth, kSteeper * measure::smoothness(pot.target).roughness);
    double worst = 0, worst_at = 0, seconds = 0;
    for (int frame = 0; !show.done() && seconds < 240; ++frame, seconds += 0.025) {
      potter.advance(25);
      potter.collect();
      show.update(0.025, potter.view(), pot.target, {1, 0, 0}, potter);
      if (frame % 24 != 0) continue;
      const double rough = roughest(potter.view().clay);
      if (rough > worst) worst = rough, worst_at = seconds;
    }
    EXPECT_LE(worst, most) << vessel.id << " at " << worst_at << " s";
    // As long as a passer-by who stops: they see the end of it too.
    EXPECT_LT(seconds, 180) << vessel.id;
    ASSERT_TRUE(potter.settle());
    EXPECT_EQ(potter.view().status.feedback.cut_free, 1.0) << vessel.id;
    points += score::judge(pot.target, potter.view().clay.profile()).points;
  }
  EXPECT_GT(points / static_cast<double>(shelf.vessels.size()), 90.0);
}

TEST(Attract, WhatEffectsDoIsShownSlowlyToo) {
  const settings::ExhibitRead read = settings::read_exhibit("config/exhibit.toml");
  const auto shelf = content::open_shelf("content/vessels");
  for (const char* scene : {"config/scenes/studio.toml", "config/scenes/master.toml"}) {
    settings::Exhibit exhibit = read.exhibit;
    exhibit.scene = scene;
    const Scenes scenes(exhibit);
    const Pot pot = pot_of(shelf.vessels.front(), scenes);
    int shown = 0;
    for (const std::string& name : scenes.wheel_of(shelf.vessels.front().id).shown) {
      if (name == "follow" || name == "collapse") continue;  // that one is to look as it does
      Scene clay = std::move(*Scene::create(pot.scene));
      const auto script = make_script(name, {pot.scene, &pot.target});
      ASSERT_TRUE(script);
      ClayView view;
      for (int ms = 0; ms < 1000 * (*script)->duration(); ++ms) {
        clay.step((*script)->at(1e-3 * ms, clay.clay()), 1e-3);
        if (ms % 600 != 0) continue;
        view.take(clay.clay());
        ASSERT_LE(roughest(view), kSmooth + kUnderWay) << scene << " " << name << " " << ms;
      }
      ++shown;
    }
    EXPECT_GT(shown, 0) << scene;
  }
}

}  // namespace
}  // namespace onggi::exhibit
