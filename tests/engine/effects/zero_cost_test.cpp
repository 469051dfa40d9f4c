// What a scene leaves out costs nothing: the hashes here, the bytes in
// tests/engine/scene/allocation_test.cpp, the instructions in tests/bench/effects.py. That the base
// is the engine as it was before it had effects, tests/golden/engine_trace.txt says: it is older
// than they are.
#include <gtest/gtest.h>

#include "tests/engine/effects/random_hands.h"
#include "tests/support/effect_scenes.h"

namespace onggi::zero_cost_test {
namespace {

using namespace effects_test;

SceneDef small() {
  SceneDef def;
  def.clay.rows = 60;
  def.clay.sectors = 48;
  return bare(def);
}

std::uint64_t hash_of(const SceneDef& def) {
  Scene scene = made(def);
  RandomHands hands(77);
  StateHash felt;
  for (int n = 0; n < 4000; ++n) {
    const Feedback out = scene.step(hands.next(), hands.seconds());
    for (const HandFeedback& hand : out.hand)
      for (const double f : {hand.force.x, hand.force.y, hand.force.z}) felt.add(f);
  }
  felt.add(scene.state_hash());
  return felt.value();
}

TEST(ZeroCost, AnAbsentEffectFullOfNanChangesNoBit) {
  const std::uint64_t base = hash_of(small());
  SceneDef all = small();
  for (const EffectTrial& effect : effect_trials()) {
    SceneDef def = small();
    effect.leave_out_full_of_nan(def);
    EXPECT_EQ(hash_of(def), base) << effect.name;
    effect.leave_out_full_of_nan(all);
  }
  EXPECT_EQ(hash_of(all), base);
}

TEST(ZeroCost, APresentOneDoesSomething) {
  const std::uint64_t base = hash_of(small());
  for (const EffectTrial& effect : effect_trials()) {
    SceneDef def = small();
    effect.add(def);
    if (effect.name == KilnDef::kName) {
      EXPECT_EQ(hash_of(def), base);  // it comes after the last tick
    } else {
      EXPECT_NE(hash_of(def), base) << effect.name;
    }
  }
}

}  // namespace
}  // namespace onggi::zero_cost_test
