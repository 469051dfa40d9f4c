#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/paper_model.h"
#include "engine/effects/friction.h"
#include "engine/scene/scene.h"

namespace onggi::paper_scene_test {
namespace {

SceneDef papers_scene() {
  SceneDef def;
  def.clay.height = 0.072;
  def.clay.inner_radius = def.clay.radius_min = 0.0001;
  def.clay.wall_min = 0.0005;
  def.clay.floor_thickness = 0.0;
  def.clay.keep_undo = false;
  def.guard.engage_time = 0.05;
  def.friction.reset();
  def.moisture.reset();
  def.paper.emplace();
  return def;
}
Hands one_hand(Vec3 at) {
  Hands hands;
  hands.hand[0] = {at, true};
  return hands;
}

TEST(PaperScene, IsShapedAndFeltFromOutsideAndFromWithin) {
  for (const auto& [from, to] : {std::pair{0.064, 0.060}, {0.046, 0.050}}) {
    auto scene = Scene::create(papers_scene());
    ASSERT_TRUE(scene);
    double most = 0.0;
    Feedback out;
    for (int n = 0; n < 1000; ++n) {
      Hands hands = one_hand({from + (to - from) * n / 1000.0, 0.036, 0.001});
      hands.wheel_speed = 6.28;
      out = scene->step(hands, 0.001);
      most = std::max(most, std::fabs(out.hand[0].force.x));
    }
    EXPECT_EQ(out.hand[0].side, to > 0.055 ? WallSide::outside : WallSide::inside);
    EXPECT_EQ(out.faults, 0u);
    EXPECT_GT(most, 0.01);
    const auto [least, widest] = std::ranges::minmax(scene->clay().outer(200));
    EXPECT_NEAR(to > 0.055 ? least : widest, to > 0.055 ? 0.052 : 0.058, 0.001);
    EXPECT_GT(scene->counters().touched_elements, 1000u);
    EXPECT_GT(scene->counters().visited_elements, scene->counters().touched_elements);
  }
}

TEST(PaperScene, ItsTableChoosesTheModel) {
  SceneDef corrected = papers_scene();
  corrected.paper.reset();
  auto a = Scene::create(corrected);
  auto b = Scene::create(papers_scene());
  a->step(one_hand({0.060, 0.036, 0.0}), 0.001);
  b->step(one_hand({0.060, 0.036, 0.0}), 0.001);
  // The first element gives 1 / c_eta of its press, to a part in a thousand as the sphere curves.
  EXPECT_NEAR(b->clay().outer(200)[0], 0.055 - 0.0003, 2e-5);
  EXPECT_NE(a->clay().hash(), b->clay().hash());
}

TEST(PaperScene, TheFiltersMemoryIsPartOfTheState) {
  // No force gets past the guard, and the clay is the same: only what the filter keeps differs.
  SceneDef soft = papers_scene();
  soft.guard.max_force = 0.0;
  SceneDef stiff = soft;
  stiff.paper->c_v = 2.0;
  auto a = Scene::create(soft);
  auto b = Scene::create(stiff);
  auto c = Scene::create(soft);
  for (auto* scene : {&a, &b, &c}) (*scene)->step(one_hand({0.062, 0.036, 0.0}), 0.001);
  EXPECT_EQ(a->clay().hash(), b->clay().hash());
  EXPECT_NE(a->state_hash(), b->state_hash());
  EXPECT_EQ(a->state_hash(), c->state_hash());
}

TEST(Paper15, FrictionDoesNotKnowTheSpeedAndJumpsWhereTheWheelStops) {
  const auto printed = [](double turn) {
    Clay clay = std::move(*Clay::create(papers_scene().clay));
    const PaperTouch touch = PaperModel(clay).tick(clay, WallSide::outside, {0.062, 0.036, 0.0},
                                                   0.008, 0.0, turn, {10.0, 0.864, 200.0});
    return touch.force.z - touch.resistance.z;
  };
  EXPECT_EQ(printed(1e-9), printed(0.03));
  EXPECT_EQ(printed(-1e-9), -printed(1e-9));
  EXPECT_GT(printed(1e-9), 0.15);  // N, of a sudden
  EXPECT_EQ(printed(0.0), 0.0);

  const auto corrected = [](double speed) {
    const Vec3 slip = -effects::clay_velocity({0.055, 0.0, 0.0}, speed);
    return effects::friction_force({1.0, 0.0, 0.0}, 1.0, slip, 0.35, 0.01).z;
  };
  EXPECT_LT(std::fabs(corrected(1e-6)), 1e-5);
  EXPECT_GT(corrected(1.0), 5.0 * corrected(0.02));
  EXPECT_LE(corrected(30.0), 0.35);
}

TEST(Paper19, NoFloorPushesUp) {
  const auto lowered = [](bool as_printed) {
    SceneDef def = papers_scene();
    def.clay = ClayDef{};
    def.clay.floor_min = def.clay.floor_thickness;  // firm
    if (!as_printed) def.paper.reset();
    auto scene = Scene::create(def);
    double most = 0.0;
    for (int n = 0; n < 1000; ++n) {  // to 6 mm within a floor of 10 mm
      const Feedback out = scene->step(one_hand({0.001, 0.032 - 2e-5 * n, 0.0}), 0.001);
      most = std::max(most, out.hand[0].force.y);
    }
    return most;
  };
  EXPECT_EQ(lowered(true), 0.0);
  EXPECT_GT(lowered(false), 1.0);
}

TEST(Paper22, WithinASceneALiftedHandIsFeltAgain) {
  auto scene = Scene::create(papers_scene());
  scene->step(one_hand({0.0, 0.036, 0.0}), 0.001);  // on the axis: 0/0
  Feedback out;
  for (int n = 0; n < 200; ++n) out = scene->step(one_hand({0.0625, 0.036, 0.0}), 0.001);
  EXPECT_NE(out.faults & kFaultForce, 0u);
  EXPECT_EQ(out.hand[0].force, Vec3{});  // the guard lets nothing through
  scene->step({}, 0.001);
  double most = 0.0;
  for (int n = 0; n < 300; ++n) {
    out = scene->step(one_hand({0.0630 - 1e-5 * n, 0.036, 0.0}), 0.001);
    most = std::max(most, out.hand[0].force.x);
  }
  EXPECT_GT(most, 0.01);

  // The corrected scene has nothing to recover from.
  SceneDef def = papers_scene();
  def.paper.reset();
  auto corrected = Scene::create(def);
  EXPECT_EQ(corrected->step(one_hand({0.0, 0.036, 0.0}), 0.001).faults, 0u);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(corrected->step(one_hand({nan, 0.036, 0.0}), 0.001).faults, std::uint32_t{kFaultInput});
}

}  // namespace
}  // namespace onggi::paper_scene_test
