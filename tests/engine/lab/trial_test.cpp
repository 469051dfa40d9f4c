#include "engine/lab/trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/lab/scene_fields.h"

namespace onggi::lab::trial_test {
namespace {

std::vector<TickRecord> records_of(const Trial& trial) {
  std::vector<TickRecord> all;
  trial.play([&](const TickRecord& record) { return all.push_back(record), true; });
  return all;
}

TEST(Trial, OfASeedIsAlwaysTheSameAndOfAnotherSeedAnother) {
  const auto words = [](std::uint64_t seed) { return words_of(random_trial(seed)); };
  EXPECT_EQ(words(5), words(5));
  EXPECT_NE(words(5), words(6));
  EXPECT_EQ(replay_of(random_trial(5), 300), replay_of(random_trial(5), 300));
}

TEST(Trial, IsASceneThatCanBeMadeWhateverItsSeed) {
  std::set<std::string> effects;
  bool ends = false;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Trial trial = random_trial(seed);
    ASSERT_TRUE(validate(trial.def)) << seed << ": " << to_text(validate(trial.def).error());
    for (std::size_t n = 0; n < effect_names().size(); ++n)
      if (has_effect(trial.def, n)) effects.insert(effect_names()[n]);
    for (const SceneField& field : scene_fields())
      ends = ends || (field.there(trial.def) && field.name == "wheel.max_speed" &&
                      field.get(trial.def) == field.most);
  }
  EXPECT_EQ(effects.size(), effect_names().size());
  EXPECT_TRUE(ends);
}

TEST(Trial, HoldsNonsenseOnlyWhereItIsAskedFor) {
  const auto nonsense = [](bool asked) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      TrialPlan plan;
      plan.nonsense = asked;
      plan.ticks = 400;
      for (const TickRecord& record : records_of(random_trial(seed, plan)))
        for (const HandInput& hand : record.hands.hand)
          count += !is_finite(hand.position) || !(record.dt > 0.0) || record.dt > 0.005;
    }
    return count;
  };
  EXPECT_EQ(nonsense(false), 0);
  EXPECT_GT(nonsense(true), 0);
}

TEST(Trial, AStrokeGoesFromItsBeginningToItsEnd) {
  Trial trial;
  Stroke stroke;
  stroke.ticks = 11;
  stroke.hand[0].begins = {{0.1, 0.0, 0.0}, true};
  stroke.hand[0].ends = {0.2, 0.5, -1.0};
  trial.strokes = {stroke};
  const auto all = records_of(trial);
  ASSERT_EQ(all.size(), 11u);
  EXPECT_EQ(all.front().hands.hand[0].position, (Vec3{0.1, 0.0, 0.0}));
  EXPECT_NEAR(all[5].hands.hand[0].position.y, 0.25, 1e-12);
  EXPECT_NEAR(all.back().hands.hand[0].position.z, -1.0, 1e-12);
}

TEST(Trial, RaggedTicksAreAboveNothingAndAtMostAsLongAsIsSaid) {
  Trial trial;
  Stroke stroke;
  stroke.ticks = 2000;
  stroke.dt = 0.003;
  stroke.ragged = true;
  trial.strokes = {stroke};
  double least = 1.0, most = 0.0;
  for (const TickRecord& record : records_of(trial)) {
    least = std::min(least, record.dt);
    most = std::max(most, record.dt);
  }
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, 1e-4);
  EXPECT_LE(most, 0.003);
  EXPECT_GT(most, 0.0029);
}

TEST(Trial, IsKeptAsAReplayThatComesToTheSameHash) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Trial trial = random_trial(seed);  // nonsense and all
    const auto replay = Replay::read(replay_of(trial, 900), "trial");
    ASSERT_TRUE(replay) << to_text(replay.error());
    EXPECT_EQ(replay->ticks.size(), 900u);
    EXPECT_EQ(replay->seed, trial.seed);
    const auto outcome = run_replay(*replay);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->first_difference_tick, -1);
    EXPECT_EQ(outcome->recorded_hash, outcome->replayed_hash);
  }
}

TEST(Trial, AMirrorTurnsItselfBack) {
  Hands hands;
  hands.hand[0] = {{0.1, 0.2, 0.3}, true, SideWish::inside, 3, {1.0, 2.0, 3.0}, 0.5};
  hands.wheel_speed = 7.0;
  EXPECT_NE(mirrored(hands), hands);
  EXPECT_EQ(mirrored(mirrored(hands)), hands);
}

}  // namespace
}  // namespace onggi::lab::trial_test
