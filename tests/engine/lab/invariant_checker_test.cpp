#include "engine/lab/invariant_checker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/lab/scene_fields.h"
#include "engine/lab/trial_run.h"

namespace onggi::lab::invariant_checker_test {
namespace {

// A watch that has just seen a good tick of a pot that a hand pressed, and what it then says of the
// same tick told otherwise.
struct Watched {
  Scene scene;
  InvariantChecker watch;
  Hands hands;
  Feedback felt;

  explicit Watched(const SceneDef& def) : scene(std::move(*Scene::create(def))), watch(scene) {
    hands.hand[0] = {{0.062, 0.1, 0.0}, true};
    hands.wheel_speed = 5.0;
    for (int n = 0; n < 300; ++n) {
      felt = scene.step(hands, 0.001);
      EXPECT_FALSE(watch.after(scene, 0.001, felt));
    }
  }
  std::optional<Invariant> told(double dt = 0.001) {
    const auto found = watch.after(scene, dt, felt);
    return found ? std::optional(found->invariant) : std::nullopt;
  }
};

SceneDef small() {
  SceneDef def = bare({});
  def.clay.rows = 60;
  def.clay.sectors = 48;
  def.guard.engage_time = 0.05;
  return def;
}

TEST(InvariantChecker, SaysNothingOfWhatIsRight) {
  Watched watched(small());
  EXPECT_EQ(watched.told(), std::nullopt);
  EXPECT_FALSE(watched.watch.whole(watched.scene));
}

TEST(InvariantChecker, TellsOfAForceThatIsNoNumberOrTooLargeOrTooQuick) {
  {
    Watched watched(small());
    watched.felt.hand[0].force.y = std::nan("");
    EXPECT_EQ(watched.told(), Invariant::finite);
  }
  {
    Watched watched(small());
    watched.felt.hand[1].force.x = 3.4;
    EXPECT_EQ(watched.told(), Invariant::force);
  }
  {
    Watched watched(small());
    watched.felt.hand[0].force.x -= 0.7;  // 600 N/s are 0.6 N in a millisecond
    EXPECT_EQ(watched.told(), Invariant::force);
  }
  {
    Watched watched(small());
    watched.felt.faults |= kFaultForce;
    EXPECT_EQ(watched.told(), Invariant::force);
  }
}

TEST(InvariantChecker, TellsOfAPressDeeperThanTheClayAndOfAWheelBeyondItsSpeed) {
  Watched deep(small());
  deep.felt.hand[0].depth = 0.21;
  EXPECT_EQ(deep.told(), Invariant::depth);
  Watched quick(small());
  quick.felt.wheel_speed = 32.0;
  EXPECT_EQ(quick.told(), Invariant::range);
  Watched wet(small());
  wet.felt.wetness = -1e-12;
  EXPECT_EQ(wet.told(), Invariant::range);
}

TEST(InvariantChecker, AllowsAPressWithinALongTickWhatClayThatRisesMayComeTo) {
  const auto told = [](bool rises, double depth, double dt) {
    SceneDef def = small();
    if (rises) def.volume.emplace();
    Watched watched(def);
    watched.felt.hand[0].depth = depth;
    return watched.told(dt);
  };
  EXPECT_EQ(told(true, 0.59, 0.005), std::nullopt);
  EXPECT_EQ(told(true, 0.61, 0.005), Invariant::depth);
  EXPECT_EQ(told(true, 0.59, 0.0014), Invariant::depth);
  EXPECT_EQ(told(false, 0.59, 0.005), Invariant::depth);
}

TEST(InvariantChecker, TellsOfClayThatCameFromNowhere) {
  SceneDef def = small();
  def.volume.emplace();
  SceneDef larger = def;
  larger.clay.outer_radius *= 1.00001;
  Watched watched(def);
  Scene other = std::move(*Scene::create(larger));
  other.mark_all_dirty();
  std::optional<Breach> found;
  for (int n = 0; n < 3 && !found; ++n) found = watched.watch.after(other, 0.001, watched.felt);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->invariant, Invariant::volume);
}

TEST(InvariantChecker, TellsOfARadiusOutOfItsRange) {
  const SceneDef def = small();
  Watched watched(def);
  const auto told = [&](auto&& change) {
    Clay clay = std::move(*Clay::create(def.clay));
    change(clay);
    for (const int j : {1, 30}) {
      const auto found = watched.watch.look_at_row(clay, j);
      if (found) return std::optional(found->invariant);
    }
    return std::optional<Invariant>();
  };
  EXPECT_EQ(told([](Clay&) {}), std::nullopt);
  EXPECT_EQ(told([](Clay& clay) { clay.outer_mut(30)[47] = 0.0259f; }), Invariant::range);
  EXPECT_EQ(told([](Clay& clay) { clay.outer_mut(30)[47] = 0.1601f; }), Invariant::range);
  EXPECT_EQ(told([](Clay& clay) { clay.inner_mut(30)[0] = 0.0019f; }), Invariant::range);
  EXPECT_EQ(told([](Clay& clay) { clay.inner_mut(1)[5] = 0.0001f; }), Invariant::range);
  EXPECT_EQ(told([](Clay& clay) { clay.inner_mut(30)[0] = std::nanf(""); }), Invariant::finite);
  // To a float's rounding and no farther.
  EXPECT_EQ(told([](Clay& clay) { clay.inner_mut(30)[0] = 0.00199995f; }), std::nullopt);
  EXPECT_GT(InvariantChecker::rounding(0.055), 1e-8);
  EXPECT_LT(InvariantChecker::rounding(0.055), 3e-7);
}

TEST(InvariantChecker, TellsOfRowsThatDoNotStandOnEachOtherAndOfAFloorThatIsNotWhereItBelongs) {
  Watched watched(small());
  Clay clay = std::move(*Clay::create(small().clay));
  EXPECT_FALSE(watched.watch.look_at_stack(clay));
  clay.set_row_thickness(20, 0.004);
  ASSERT_TRUE(watched.watch.look_at_stack(clay));
  EXPECT_EQ(watched.watch.look_at_stack(clay)->invariant, Invariant::stacked);
  clay.restack(20);
  EXPECT_FALSE(watched.watch.look_at_stack(clay));
  clay.set_row_thickness(30, 0.0);
  clay.restack(30);
  EXPECT_TRUE(watched.watch.look_at_stack(clay));
  clay.set_row_thickness(30, 0.003);
  clay.restack(30);
  clay.lower_floor(0.02);
  EXPECT_TRUE(watched.watch.look_at_stack(clay));
}

TEST(InvariantChecker, TellsOfARowThatChangedAndIsNotMarked) {
  Watched watched(small());
  // Another scene, pressed elsewhere, whose marks somebody took.
  Scene other = std::move(*Scene::create(small()));
  Hands hands;
  hands.hand[0] = {{0.0, 0.15, 0.060}, true};
  for (int n = 0; n < 50; ++n) other.step(hands, 0.001);
  while (other.take_dirty_row(0) >= 0) {
  }
  const auto found = watched.watch.whole(other);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->invariant, Invariant::marks);
}

TEST(InvariantChecker, FindsWhatIsWrongWithThePrintedModel) {
  Trial trial;
  trial.def = small();
  trial.def.paper.emplace();
  Stroke stroke;
  stroke.ticks = 50;
  stroke.hand[0].begins = {{0.0, 0.1, 0.0}, true};
  stroke.hand[0].ends = {0.0, 0.1, 0.0};
  trial.strokes = {stroke};
  const TrialResult result = run_trial(trial);
  ASSERT_TRUE(result.breach);
  EXPECT_EQ(result.breach->invariant, Invariant::force);
  EXPECT_EQ(result.breach->tick, 1u);
}

}  // namespace
}  // namespace onggi::lab::invariant_checker_test
