#include "tests/support/tick_scripts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace onggi::tick_scripts_test {
namespace {

struct Pass {
  double least_depth = 1.0, most_depth = 0.0;
  int touching = 0, ticks = 0;
  std::uint32_t faults = 0;
};

// A pass, after the 60 ticks in which the tool settles.
Pass one_pass(const TickScript& script, Scene& scene) {
  Pass run;
  for (int n = 0; n < script.pass(); ++n) {
    const Feedback felt = scene.step(script.hands(n), kTickSeconds);
    run.faults |= felt.faults;
    if (n < 60) continue;
    ++run.ticks;
    run.touching += felt.hand[0].contact ? 1 : 0;
    run.least_depth = std::min(run.least_depth, felt.hand[0].depth);
    run.most_depth = std::max(run.most_depth, felt.hand[0].depth);
  }
  return run;
}

TEST(TickScripts, TheClayUnderTheToolIsFreshToTheEndOfThePass) {
  for (const TickScript& script : tick_scripts()) {
    auto scene = Scene::create(script.scene(400, 360));
    ASSERT_TRUE(scene) << script.name;
    const Pass run = one_pass(script, *scene);
    EXPECT_EQ(run.faults, 0u) << script.name;
    if (!script.touches) {
      EXPECT_EQ(run.touching, 0) << script.name;
      continue;
    }
    EXPECT_EQ(run.touching, run.ticks) << script.name;
    EXPECT_GT(run.least_depth, 0.1e-3) << script.name;
    EXPECT_LT(run.most_depth, 2.5e-3) << script.name;
  }
}

TEST(TickScripts, RenewedClayIsTheLumpAgain) {
  for (const TickScript& script : tick_scripts()) {
    for (const auto& [rows, sectors] : {std::pair{400, 360}, {90, 2880}, {65, 16}}) {
      auto scene = Scene::create(script.scene(rows, sectors));
      ASSERT_TRUE(scene) << script.name;
      const std::uint64_t lump = scene->clay().hash();
      for (int n = 0; n < 100; ++n) scene->step(script.hands(n), kTickSeconds);
      EXPECT_EQ(scene->clay().hash() == lump, !script.touches) << script.name;
      renew_clay(*scene, script.wheel_speed);
      EXPECT_EQ(scene->clay().hash(), lump) << script.name << " " << rows << " x " << sectors;
    }
  }
}

TEST(TickScripts, EveryOneHasItsOwnName) {
  std::set<std::string_view> names;
  for (const TickScript& script : tick_scripts()) {
    names.insert(script.name);
    EXPECT_EQ(&tick_script(script.name), &script);
  }
  EXPECT_EQ(names.size(), tick_scripts().size());
}

}  // namespace
}  // namespace onggi::tick_scripts_test
