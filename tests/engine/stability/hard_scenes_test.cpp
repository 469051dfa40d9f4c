#include <rapidcheck.h>

#include <algorithm>
#include <iostream>

#include "tests/engine/stability/cases.h"

// Scenes at the ends of what validate() accepts, whatever is done in them.
namespace onggi::stability::hard_scenes_test {
namespace {

// Hands that go anywhere, for `ticks` ticks.
Trial anything(const SceneDef& def, std::uint64_t seed, int ticks) {
  lab::TrialPlan plan;
  plan.ticks = ticks;
  plan.strokes = std::max(4, ticks / 150);
  return lab::random_hands(def, seed, plan);
}

SceneDef with_effects(const std::vector<std::size_t>& which) {
  SceneDef def = small(48, 40);
  for (const std::size_t n : which) lab::add_effect(def, n);
  return def;
}

TEST(HardScenes, EveryFieldAtBothEndsOfItsRange) {
  constexpr int kTicksAnEnd = 1200;
  std::uint64_t seed = 100;
  for (const lab::SceneField& field : lab::scene_fields())
    for (const double end : {field.least, field.most}) {
      if (field.name.starts_with("paper.")) continue;  // the printed model holds to nothing
      SceneDef def = small(40, 32);
      field.set(def, end);
      ASSERT_TRUE(validate(def)) << field.name << ": " << to_text(validate(def).error());
      expect_stable(anything(def, ++seed, def.clay.rows > 1000 ? 200 : kTicksAnEnd));
      if (HasFailure()) FAIL() << field.name << " = " << end;
    }
}

TEST(HardScenes, EveryFieldAtBothEndsOfItsRangeWithEveryEffect) {
  constexpr int kTicksAnEnd = 600;
  std::uint64_t seed = 500;
  for (const lab::SceneField& field : lab::scene_fields())
    for (const double end : {field.least, field.most}) {
      SceneDef def = everything(small(40, 32));
      if (field.name.starts_with("paper.")) continue;  // it stands beside no effect
      field.set(def, end);
      ASSERT_TRUE(validate(def)) << field.name << ": " << to_text(validate(def).error());
      expect_stable(anything(def, ++seed, def.clay.rows > 1000 ? 60 : kTicksAnEnd));
      if (HasFailure()) FAIL() << field.name << " = " << end;
    }
}

TEST(HardScenes, EveryEffectAlone) {
  for (std::size_t n = 0; n < lab::effect_names().size(); ++n)
    expect_stable(anything(with_effects({n}), 10 + n, 6000));
}

TEST(HardScenes, EveryTwoEffects) {
  const std::size_t count = lab::effect_names().size();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      expect_stable(anything(with_effects({a, b}), 100 * a + b, 2000));
}

// On the thinnest disc and on a wall, by the thinnest coils and the thickest.
TEST(HardScenes, WhateverIsBuiltOfCoils) {
  std::uint64_t seed = 40;
  for (const double coil : {0.008, 0.03})
    for (const bool disc : {true, false}) {
      SceneDef def = everything(small(40, 32));
      def.building->coil = coil;
      def.building->pace = 5.0;
      def.clay.keep_undo = true;
      if (disc) {
        def.clay.rows = 16;
        def.clay.height = def.clay.floor_thickness = 0.010;
      }
      Trial trial = anything(def, ++seed, 15000);
      Stroke ring =
          held({def.clay.outer_radius - 0.5 * coil, def.clay.height + 0.4 * coil, 0.0}, 1000, 10.0);
      ring.hand[0].begins.coil = true;
      trial.strokes.insert(trial.strokes.begin(), 2, ring);
      trial.strokes[1].hand[0].begins.position.y += 0.88 * coil;
      trial.strokes[1].hand[0].ends.y += 0.88 * coil;
      expect_stable(trial);
      double most = 0.0;
      Scene scene = std::move(*Scene::create(def));
      trial.play([&](const TickRecord& record) {
        scene.step(record.hands, record.dt);
        most = std::max(most, scene.coil().added);
        return true;
      });
      EXPECT_GT(most, 0.0) << "no ring was ever closed: coil " << coil;
    }
}

// By the weakest blows and the strongest, with the smallest paddle and the largest, on clay as soft
// and as stiff as it may be.
TEST(HardScenes, WhateverIsBeaten) {
  std::uint64_t seed = 60;
  for (const double energy : {0.001, 2.0})
    for (const double face : {0.005, 0.08})
      for (const double stress : {5e3, 1e6}) {
        SceneDef def = everything(small(40, 32));
        def.beating = BeatingDef{energy, face, stress};
        def.clay.keep_undo = true;
        Trial trial = anything(def, ++seed, 4000);
        for (Stroke& stroke : trial.strokes)
          for (Stroke::Part& part : stroke.hand) part.beats = part.begins.paddle = true;
        expect_stable(trial);
      }
}

TEST(HardScenes, AllEffectsTogether) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u})
    expect_stable(anything(everything(small(48, 40)), seed, 8000));
}

TEST(HardScenes, EveryToolOfEverySize) {
  for (const SceneDef& pot : {small(48, 40), everything(small(48, 40))})
    for (const ToolShape& shape : tool_shapes())
      for (const ToolSize& size : {shape.least, shape.usual, shape.most}) {
        SceneDef def = pot;
        if (shape.name == "sphere") def.tool.radius = size.radius;
        for (SceneTool& tool : def.tools)
          if (tool.name == shape.name) tool.size = size;
        Trial trial = anything(def, 7, 1500);
        for (Stroke& stroke : trial.strokes)
          for (Stroke::Part& part : stroke.hand)
            part.begins.tool = tool_of(def, std::string(shape.name));
        expect_stable(trial);
        if (HasFailure()) FAIL() << shape.name;
      }
}

TEST(HardScenes, NoRadiusFallsBelowZeroOnSixteenToTwentySevenSectors) {
  for (int sectors = 16; sectors <= 27; ++sectors)
    for (const double radius : {0.008, 0.05}) {
      SceneDef def = small(32, sectors);
      def.clay.radius_min = 1e-4;
      def.tool.radius = radius;
      expect_stable(anything(def, static_cast<std::uint64_t>(sectors), 2500));
      expect_stable(anything(everything(def), static_cast<std::uint64_t>(sectors), 1500));
    }
}

TEST(HardScenes, AMirroredWorldHasAMirroredPot) {
  for (const ToolShape& shape : tool_shapes()) {
    SceneDef def = small(64, 96);
    def.friction.emplace();
    def.volume.emplace();
    def.walls.emplace();
    Stroke touch = stroke({0.062, 0.08, 0.01}, {0.056, 0.12, 0.0}, 300, 9.0);
    Stroke within = stroke({0.012, 0.15, -0.004}, {0.018, 0.11, 0.002}, 300, 9.0);
    for (Stroke* one : {&touch, &within})
      one->hand[0].begins.tool = tool_of(def, std::string(shape.name));
    expect_stable({def, 1, {touch, within}}, {.twice = true, .mirror = true});
    if (HasFailure()) FAIL() << shape.name;
  }
}

rc::Gen<Trial> any_trial(const lab::TrialPlan& plan) {
  const auto drawn =
      rc::gen::map(rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()),
                   [plan](std::uint64_t seed) { return lab::random_trial(seed, plan); });
  return rc::gen::shrink(rc::gen::noShrink(drawn), [](const Trial& trial) {
    return rc::seq::fromContainer(lab::simpler(trial));
  });
}

// RapidCheck draws scenes and hands from a seed that stays, and makes what it finds smaller; the
// replay that is written last is the least of them.
void any_hands_in_any_scene(std::uint64_t seed, int scenes, int ticks) {
  lab::TrialPlan plan;
  plan.ticks = ticks;
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = scenes;
  rc::detail::TestMetadata metadata;
  metadata.id = "any hands in any scene";
  std::string file;
  const auto result = rc::detail::checkTestable(
      [&] {
        const Trial trial = *any_trial(plan);
        const lab::TrialResult run = lab::run_trial(trial, {.twice = true});
        Tally::ticks() += run.ticks;
        if (!run.breach) return;
        file = kept(trial, run.breach->tick);
        RC_FAIL(run.breach->what);
      },
      metadata, params);
  std::ostringstream said;
  rc::detail::printResultMessage(result, said);
  EXPECT_TRUE(result.is<rc::detail::SuccessResult>()) << said.str() << '\n' << file;
}

TEST(HardScenes, AnyHandsInAnyScene) { any_hands_in_any_scene(20081, 60, 4000); }
TEST(HardScenes, AnyHandsInAnySceneOnceMore) { any_hands_in_any_scene(20082, 60, 4000); }

}  // namespace
}  // namespace onggi::stability::hard_scenes_test

namespace onggi::lab {
// How RapidCheck tells of a trial.
void showValue(const Trial& trial, std::ostream& out) { out << words_of(trial); }
}  // namespace onggi::lab
