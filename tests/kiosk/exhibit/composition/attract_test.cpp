#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/scene/lump.h"
#include "engine/script/script.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/exhibit/rehearsal/looks_smooth.h"
#include "kiosk/visit/screens/demonstration.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/support/open_shelf.h"

namespace onggi::exhibit::attract_test {
namespace {

constexpr double kSmooth = 0.0003;  // m: what people call smooth

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
        std::max(worst, rehearsal::smoothness(silhouette(clay, n * clay.sectors() / 4)).roughness);
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

/// A potter's wheel that hears which tool hand 0 is told to hold.
class Overheard final : public loop::WheelCommands {
 public:
  explicit Overheard(loop::SteppedWheel& wheel) : wheel_(wheel) {}
  void start(std::unique_ptr<Scene> scene) override { wheel_.start(std::move(scene)); }
  void play(std::unique_ptr<Script> script) override { wheel_.play(std::move(script)); }
  void hand(int index, const HandInput& target) override {
    if (index == 0) {
      changed_in_the_clay += target.active && was_.active && target.tool != was_.tool;
      if (target.active) tools.insert(target.tool);
      was_ = target;
    }
    wheel_.hand(index, target);
  }
  void take(int index, std::uint8_t tool) override { wheel_.take(index, tool); }
  void hold(loop::InHand what) override { wheel_.hold(what); }
  void swing(const script::Swings& swings) override { wheel_.swing(swings); }
  void wheel(double speed) override { wheel_.wheel(speed); }
  void water(bool held) override { wheel_.water(held); }
  void fire(bool hangs) override { wheel_.fire(hangs); }
  void renew() override { wheel_.renew(); }
  void restore() override { wheel_.restore(); }
  void pause(bool on) override { wheel_.pause(on); }
  void harden(std::unique_ptr<force::LeatherOutline> wall) override {
    wheel_.harden(std::move(wall));
  }
  void decorate(const force::DecoratingTool& tool, const force::LeatherTurn& turn) override {
    wheel_.decorate(tool, turn);
  }
  void clear_faults(std::uint32_t which) override { wheel_.clear_faults(which); }
  bool refresh_every_row() override { return wheel_.refresh_every_row(); }

  int changed_in_the_clay = 0;
  std::set<int> tools;

 private:
  loop::SteppedWheel& wheel_;
  HandInput was_;
};

TEST(Attract, HandsComeOffTheClayBeforeTheyTakeAnotherTool) {
  const settings::ExhibitRead read = settings::read_exhibit("config/exhibit.toml");
  const Scenes scenes(read.exhibit);
  const auto shelf = content::open_shelf("content/vessels");
  const auto vessel = std::ranges::find(shelf.vessels, "samanid_bowl", &content::Vessel::id);
  ASSERT_NE(vessel, shelf.vessels.end());
  const Pot pot = pot_of(*vessel, scenes);
  loop::SteppedWheel wheel_host;
  wheel_host.start(std::make_unique<Scene>(std::move(*Scene::create(pot.scene))));
  Overheard heard(wheel_host);
  screens::Demonstration show(scenes.wheel_of(*vessel), false);
  for (int frame = 0; !show.done() && frame < 10'000; ++frame) {
    wheel_host.advance(25);
    wheel_host.collect();
    show.update(0.025, wheel_host.view(), pot.target, {1, 0, 0}, heard);
  }
  EXPECT_EQ(heard.changed_in_the_clay, 0);
  EXPECT_EQ(heard.tools.size(), 4u) << "palm, trimmer, rib and wire";
}

TEST(Attract, APotterThrowsEveryVesselOfTheShelfAndNoMomentOfItShowsAScrewThread) {
  const settings::ExhibitRead read = settings::read_exhibit("config/exhibit.toml");
  const Scenes scenes(read.exhibit);
  double points = 0;
  const auto shelf = content::open_shelf("content/vessels");
  ASSERT_GE(shelf.vessels.size(), 12u);
  for (const content::Vessel& vessel : shelf.vessels) {
    const Pot pot = pot_of(vessel, scenes);
    loop::SteppedWheel wheel_host;
    wheel_host.start(std::make_unique<Scene>(std::move(*Scene::create(pot.scene))));
    screens::Demonstration show(scenes.wheel_of(vessel), false);
    // A vessel has turns of its own, and on the way to it the pot has no more.
    const double most = std::max(kSmooth, rehearsal::smoothness(pot.target).roughness);
    double worst = 0, worst_at = 0, seconds = 0;
    for (int frame = 0; !show.done() && seconds < 240; ++frame, seconds += 0.025) {
      wheel_host.advance(25);
      wheel_host.collect();
      show.update(0.025, wheel_host.view(), pot.target, {1, 0, 0}, wheel_host);
      if (frame % 4 != 0) continue;
      const double rough = roughest(wheel_host.view().clay);
      if (rough > worst) worst = rough, worst_at = seconds;
    }
    EXPECT_LE(worst, most) << vessel.id << " at " << worst_at << " s";
    // As long as a passer-by who stops: they see the end of it too.
    EXPECT_LT(seconds, 180) << vessel.id;
    ASSERT_TRUE(wheel_host.refresh_every_row());
    EXPECT_EQ(wheel_host.view().status.feedback.cut_free, 1.0) << vessel.id;
    points += score::judge(pot.target, wheel_host.view().clay.profile()).points;
  }
  EXPECT_GT(points / static_cast<double>(shelf.vessels.size()), 90.0);
}

// A machine that is busy shows two frames a second. The hands leap with none of them.
TEST(Attract, AScreenThatShowsFewFramesLeavesNoScrewThread) {
  const settings::ExhibitRead read = settings::read_exhibit("config/exhibit.toml");
  const Scenes scenes(read.exhibit);
  const auto shelf = content::open_shelf("content/vessels");
  const auto vessel = std::ranges::find(shelf.vessels, "black_topped_jar", &content::Vessel::id);
  ASSERT_NE(vessel, shelf.vessels.end());
  const Pot pot = pot_of(*vessel, scenes);
  loop::SteppedWheel wheel_host;
  wheel_host.start(std::make_unique<Scene>(std::move(*Scene::create(pot.scene))));
  screens::Demonstration show(scenes.wheel_of(*vessel), false);
  double worst = 0;
  int frame = 0;
  for (; !show.done() && frame < 4000; ++frame) {
    const int ms = frame % 3 == 0 ? 900 : 300;
    wheel_host.advance(ms);
    wheel_host.collect();
    show.update(1e-3 * ms, wheel_host.view(), pot.target, {1, 0, 0}, wheel_host);
    worst = std::max(worst, roughest(wheel_host.view().clay));
  }
  EXPECT_TRUE(show.done());
  EXPECT_LE(worst, std::max(kSmooth, rehearsal::smoothness(pot.target).roughness));
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
    for (const std::string& name : scenes.wheel_of(shelf.vessels.front()).shown) {
      if (name == "follow" || name == "collapse") continue;  // that one is to look as it does
      Scene clay = std::move(*Scene::create(pot.scene));
      const auto script = make_script(name, {pot.scene, &pot.target});
      ASSERT_TRUE(script);
      ClayView view;
      for (int ms = 0; ms < 1000 * (*script)->duration(); ++ms) {
        clay.step((*script)->at(1e-3 * ms, clay.clay()), 1e-3);
        if (ms % 600 != 0) continue;
        view.take(clay.clay());
        EXPECT_LE(roughest(view), kSmooth) << scene << " " << name << " " << ms;
      }
      ++shown;
    }
    EXPECT_GT(shown, 0) << scene;
  }
}

}  // namespace
}  // namespace onggi::exhibit::attract_test
