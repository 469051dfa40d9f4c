#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/scene/replay.h"
#include "engine/scene/scene.h"

namespace onggi::tools_test {
namespace {

std::uint8_t index_of(const SceneDef& def, std::string_view name) {
  const auto tool = std::ranges::find(def.tools, name, &SceneTool::name);
  EXPECT_NE(tool, def.tools.end()) << name;
  return static_cast<std::uint8_t>(tool - def.tools.begin() + 1);
}

SceneDef small() {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 120;
  return def;
}

Hands with(std::uint8_t tool, Vec3 at) {
  Hands hands;
  hands.hand[0].active = true;
  hands.hand[0].position = at;
  hands.hand[0].tool = tool;
  return hands;
}

TEST(Tools, EveryShapeLiesToHandAndTheBallIsTheFirst) {
  const SceneDef def;
  EXPECT_EQ(def.tools.size() + 1, tool_shapes().size());
  for (const char* name :
       {"fingertip", "flat_rib", "curved_rib", "needle", "loop_trimmer", "sponge", "wire"})
    index_of(def, name);
}

TEST(Tools, ASizeThatAToolHasNotOrThatIsOutOfRangeIsRefusedByName) {
  const auto refused = [](auto change) {
    SceneDef def;
    change(def.tools[index_of(def, "flat_rib") - 1u].size, def);
    const Result<void> good = validate(def);
    EXPECT_FALSE(good);
    EXPECT_FALSE(Scene::create(def));
    return good ? std::string() : good.error().where;
  };
  using S = ToolSize;
  EXPECT_EQ(refused([](S& s, SceneDef&) { s.length = 3.0; }), "flat_rib.length");
  EXPECT_EQ(refused([](S& s, SceneDef&) { s.radius = -0.01; }), "flat_rib.radius");
  EXPECT_EQ(refused([](S& s, SceneDef&) { s.thickness = std::nan(""); }), "flat_rib.thickness");
  EXPECT_EQ(
      refused([](S&, SceneDef& d) { d.tools[index_of(d, "sponge") - 1u].size.length = 0.01; }),
      "sponge.length");
  EXPECT_EQ(refused([](S&, SceneDef& d) { d.tools[0].name = "spoon"; }), "tools");
}

TEST(Tools, ANewToolInTheHandComesToTheClayAnew) {
  const SceneDef def = small();
  Scene scene = std::move(*Scene::create(def));
  Feedback felt;
  for (int n = 0; n < 20; ++n) felt = scene.step(with(0, {0.062, 0.1, 0}), 0.001);
  EXPECT_GT(length(felt.hand[0].force), 0.0);
  // Its force ramps up from nothing, as on arrival.
  felt = scene.step(with(index_of(def, "fingertip"), {0.062, 0.1, 0}), 0.001);
  EXPECT_LT(length(felt.hand[0].force), 0.01);
  for (int n = 0; n < 20; ++n)
    felt = scene.step(with(index_of(def, "fingertip"), {0.0615, 0.1, 0}), 0.001);
  EXPECT_TRUE(felt.hand[0].contact);
  EXPECT_GT(length(felt.hand[0].force), 0.0);
  EXPECT_EQ(felt.faults, 0u);
}

TEST(Tools, AToolThatThereIsNotOrAHandleThatIsNoNumberIsHeldAsAFault) {
  Scene scene = std::move(*Scene::create(small()));
  scene.step(with(0, {0.062, 0.1, 0}), 0.001);
  EXPECT_EQ(scene.step(with(200, {0.062, 0.1, 0}), 0.001).faults, kFaultInput);
  scene.clear_faults();
  Hands hands = with(1, {0.062, 0.1, 0});
  hands.hand[0].handle.y = std::nan("");
  EXPECT_EQ(scene.step(hands, 0.001).faults, kFaultInput);
}

TEST(Tools, HeldAsUsualTheFlatRibFacesTheWallWhereverTheHandIs) {
  const SceneDef def = small();
  for (double angle : {0.0, 1.1, 2.9, -2.0}) {
    Scene scene = std::move(*Scene::create(def));
    const double away = 0.055 + 0.0015 - 0.002;
    for (int n = 0; n < 300; ++n)
      scene.step(
          with(index_of(def, "flat_rib"), {away * std::cos(angle), 0.1, away * std::sin(angle)}),
          0.001);
    const Clay& clay = scene.clay();
    const int j = clay.first_row_above(0.1);
    int pressed = 0;
    for (std::size_t i = 0; i < 120; ++i) {
      const double off = (static_cast<double>(i) + 0.5) * 2.0 * 3.14159265358979 / 120 - angle;
      if (clay.outer(j)[i] > 0.0549f) continue;
      ++pressed;
      EXPECT_NEAR(double{clay.outer(j)[i]} * std::cos(off), 0.053, 1e-5) << angle;
    }
    EXPECT_GE(pressed, 7) << angle;
  }
}

TEST(Tools, ASpongeWetsWhatItTouches) {
  const SceneDef def = small();
  Scene scene = std::move(*Scene::create(def));
  const std::uint8_t sponge = index_of(def, "sponge");
  Feedback felt;
  for (int n = 0; n < 300; ++n) felt = scene.step(with(sponge, {0.1, 0.1, 0}), 0.001);
  EXPECT_EQ(felt.wetness, 0.0);  // beside the wall
  for (int n = 0; n < 300; ++n) felt = scene.step(with(sponge, {0.082, 0.1, 0}), 0.001);
  EXPECT_GT(felt.wetness, 0.1);
}

// Draws the wire through under the pot, along x.
Feedback cut_off(Scene& scene, ReplayWriter* writer = nullptr, double wheel = 0.0) {
  Feedback felt;
  const std::uint8_t wire = index_of(scene.def(), "wire");
  for (double x = 0.075; x > -0.075; x -= 0.0002) {
    Hands hands = with(wire, {x, 0.0015, 0.0});
    hands.hand[0].handle = {0, 0, 1};
    hands.wheel_speed = wheel;
    if (writer != nullptr) writer->tick({hands, 0.001});
    felt = scene.step(hands, 0.001);
  }
  return felt;
}

TEST(Wire, ACutPotNoLongerTurnsAndNoToolShapesItUntilANewLump) {
  Scene scene = std::move(*Scene::create(small()));
  Feedback felt = cut_off(scene);
  EXPECT_EQ(felt.cut_free, 1.0);
  const double angle = felt.clay_angle;
  const std::uint64_t shape = scene.clay().hash();
  for (int n = 0; n < 500; ++n) {
    Hands hands = with(0, {0.058, 0.1, 0});
    hands.wheel_speed = 10.0;
    felt = scene.step(hands, 0.001);
    EXPECT_FALSE(felt.hand[0].contact);
  }
  EXPECT_EQ(scene.clay().hash(), shape);
  EXPECT_EQ(felt.clay_angle, angle);
  EXPECT_NE(felt.wheel_angle, angle);

  for (int n = 0; n < 50; ++n) {
    Hands hands;
    hands.renew = n == 0;
    felt = scene.step(hands, 0.001);
  }
  EXPECT_EQ(felt.cut_free, 0.0);
  EXPECT_EQ(felt.clay_angle, felt.wheel_angle);
  for (int n = 0; n < 50; ++n) felt = scene.step(with(0, {0.058, 0.1, 0}), 0.001);
  EXPECT_TRUE(felt.hand[0].contact);
}

TEST(Wire, IsFeltAsADragWhileItCutsAndNotAfter) {
  Scene scene = std::move(*Scene::create(small()));
  const std::uint8_t wire = index_of(scene.def(), "wire");
  double most = 0.0;
  Feedback felt;
  for (double x = 0.12; x > -0.12; x -= 0.0001) {
    Hands hands = with(wire, {x, 0.0015, 0.0});
    felt = scene.step(hands, 0.001);
    most = std::max(most, felt.hand[0].force.x);
  }
  EXPECT_GT(most, 1.5);
  EXPECT_LT(length(felt.hand[0].force), 1e-6);
}

TEST(Wire, ACutIsReplayedBitForBit) {
  Scene scene = std::move(*Scene::create(small()));
  ReplayWriter writer(scene.def(), "jar", 1);
  cut_off(scene, &writer, 5.0);
  const std::vector<std::byte> bytes = writer.finish(scene.state_hash());
  const Result<Replay> replay = Replay::read(bytes, "cut");
  ASSERT_TRUE(replay) << to_text(replay.error());
  EXPECT_EQ(replay->def.tools.size(), scene.def().tools.size());
  const Result<ReplayOutcome> outcome = run_replay(*replay);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->first_difference_tick, -1);
  EXPECT_EQ(outcome->replayed_hash, scene.state_hash());
}

}  // namespace
}  // namespace onggi::tools_test
