#include "engine/scene/lump_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::scene::lump_work_test {
namespace {

constexpr const char* kNames[kLumpStates] = {"playing", "keeping",   "renewing",
                                             "laying",  "restoring", "settling"};

std::string name_of(LumpState state) { return kNames[static_cast<std::size_t>(state)]; }

// The cells of a row of a table in Markdown, without their backticks.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = 1; at < line.size();) {
    const std::size_t end = line.find('|', at);
    if (end == std::string::npos) break;
    std::string cell = line.substr(at, end - at);
    std::erase_if(cell, [](char c) { return c == ' ' || c == '`'; });
    cells.push_back(cell);
    at = end + 1;
  }
  return cells;
}

TEST(LumpWork, TheDrawnTableIsTheOneThatRuns) {
  std::ifstream file("engine/docs/pipeline.md");
  std::map<std::string, std::vector<std::string>> drawn;
  for (std::string line; std::getline(file, line);)
    if (const auto cells = cells_of(line); cells.size() == 6) drawn[cells[0]] = cells;
  for (int n = 0; n < kLumpStates; ++n) {
    const auto state = static_cast<LumpState>(n);
    ASSERT_TRUE(drawn.contains(name_of(state))) << name_of(state);
    for (const LumpEvent event : {LumpEvent::renew, LumpEvent::restore, LumpEvent::done}) {
      const LumpState next = after(state, event);
      const std::string& cell = drawn[name_of(state)][1 + static_cast<std::size_t>(event)];
      EXPECT_EQ(cell, next == state ? "" : name_of(next)) << name_of(state);
    }
  }
}

TEST(LumpWork, WhateverWasBegunIsDoneAndThenTheHandsPlayAgain) {
  for (int n = 0; n < kLumpStates; ++n) {
    auto state = static_cast<LumpState>(n);
    for (int step = 0; step < 3; ++step) state = after(state, LumpEvent::done);
    EXPECT_EQ(state, LumpState::playing) << kNames[n];
  }
}

TEST(LumpWork, WithoutHistoryNothingIsKeptAndWithoutEffectsNothingSettles) {
  SceneDef def;
  def.clay.rows = 40;
  def.clay.sectors = 16;
  def.clay.keep_undo = false;
  Clay pot = std::move(*Clay::create(def.clay));
  const LumpWork::Parts parts{def, pot, nullptr, nullptr, nullptr};
  LumpWork work;
  Hands hands;
  EXPECT_FALSE(work.step(hands, parts));
  hands.restore = true;  // there is nothing to take back
  EXPECT_FALSE(work.step(hands, parts));
  pot.outer_mut(3)[0] = 0.05f;
  hands.renew = true;
  EXPECT_TRUE(work.step(hands, parts));  // 640 elements: all in one tick
  EXPECT_TRUE(work.playing());
  EXPECT_EQ(pot.outer(3)[0], static_cast<float>(def.clay.outer_radius));
  EXPECT_FALSE(work.step(hands, parts));  // held, it asks once
}

TEST(LumpWork, WhatIsAskedForMeanwhileIsNotDoneAfterwards) {
  SceneDef def;  // 400 x 360 elements take 18 ticks and more
  Clay pot = std::move(*Clay::create(def.clay));
  clay::History history(pot);
  const LumpWork::Parts parts{def, pot, &history, nullptr, nullptr};
  LumpWork work;
  Hands hands;
  hands.renew = true;
  EXPECT_TRUE(work.step(hands, parts));
  hands.renew = false;
  hands.restore = true;
  EXPECT_TRUE(work.step(hands, parts));
  int ticks = 2;
  while (!work.playing() && ticks < 100) {
    EXPECT_TRUE(work.step({}, parts));
    ++ticks;
  }
  EXPECT_GT(ticks, 18);
  EXPECT_LT(ticks, 30);
  EXPECT_FALSE(work.step({}, parts));
}

// A rib held so long that the touch is cut into steps of three seconds: rows, which trade clay
// under it, are taken back as they were some ticks apart.
TEST(LumpWork, WhatIsTakenBackIsAllTheClayThereWas) {
  for (const int ticks : {603, 606, 609}) {
    SceneDef def;
    def.clay.rows = 49;
    def.clay.sectors = 160;
    def.volume.emplace();
    def.smoothing.emplace();
    Scene scene = std::move(*Scene::create(def));
    const double lump = scene.clay().volume();
    Hands hands;
    hands.wheel_speed = -10.9;
    for (int t = 0; t < ticks; ++t) {
      hands.hand[0] = {
          .position = {0.034 + 5e-6 * std::max(0, t - 50), 0.13, 0.0}, .active = true, .tool = 1};
      scene.step(hands, 0.005);
    }
    ASSERT_EQ(scene.hand(0).name, "curved_rib");
    Hands restore;
    restore.restore = true;
    scene.step(restore, 0.005);
    for (int t = 0; scene.laying() || t < 20; ++t) scene.step(restore, 0.005);
    EXPECT_GT(scene.clay().rim_height(), 1.1 * def.clay.height) << "it came back to a fresh lump";
    EXPECT_NEAR(scene.clay().volume() / lump, 1.0, 1e-8) << ticks << " ticks";
  }
}

// A cut of four seconds is two steps. Clay that is taken back from the edge between them gets a
// little higher, and that is nobody's step.
TEST(LumpWork, ACutLongerThanAStepIsTakenBackWholeStepByStep) {
  SceneDef def;
  def.clay.rows = 120;
  def.clay.sectors = 90;
  def.clay.outer_radius = 0.05;
  def.clay.inner_radius = 0.042;
  def.volume.emplace();
  Scene scene = std::move(*Scene::create(def));
  const double lump = scene.clay().volume();
  Hands hands;
  hands.wheel_speed = 15.0;
  for (std::uint8_t n = 0; n < scene.def().tools.size(); ++n)
    if (scene.def().tools[n].name == "loop_trimmer") hands.hand[0].tool = n + 1;
  ASSERT_GT(hands.hand[0].tool, 0);
  hands.hand[0].active = true;
  hands.hand[0].side = SideWish::outside;
  for (int t = 0; t < 4000; ++t) {
    hands.hand[0].position = {0.052 - 1e-6 * t, 0.03 + 1e-5 * t, 0.0};
    scene.step(hands, 0.001);
  }
  hands.hand[0].active = false;
  for (int t = 0; t < 1000; ++t) scene.step(hands, 0.001);
  ASSERT_LT(scene.clay().volume(), 0.9 * lump);
  int undone = 0;
  for (; scene.can_restore() && undone < 10; ++undone) {
    hands.restore = true;
    scene.step(hands, 0.001);
    hands.restore = false;
    for (int t = 0; t < 1000; ++t) scene.step(hands, 0.001);
  }
  EXPECT_EQ(undone, 2);
  EXPECT_NEAR(scene.clay().volume() / lump, 1.0, 1e-8);
}

// Clay that is wet goes on sagging after an undo, and a cut begins in the middle of it.
TEST(LumpWork, ACutThatBeginsWhileUndoneClaySagsIsTakenBackToTheFreshLump) {
  SceneDef def;
  def.clay.rows = 60;
  def.clay.sectors = 48;
  def.volume.emplace();
  def.smoothing.emplace();
  def.slump.emplace().yield_stress = 9000.0;
  def.moisture.emplace().weakening = 0.05;
  Scene scene = std::move(*Scene::create(def));
  const double lump = scene.clay().volume(), rim = scene.clay().rim_height();
  Hands hands;
  hands.wheel_speed = 15.0;
  const auto run = [&](double seconds) {
    for (int t = 0; t < static_cast<int>(seconds * 1000); ++t, hands.restore = false)
      scene.step(hands, 0.001);
  };
  hands.hand[0] = {.position = {0.058, 0.1, 0.0}, .active = true, .side = SideWish::outside};
  hands.water = true;
  run(2.0);
  hands.water = hands.hand[0].active = false;
  run(1.0);
  hands.restore = true;
  run(0.5);
  ASSERT_LT(scene.clay().rim_height(), 0.99 * rim) << "it sags";
  ASSERT_TRUE(scene.can_restore()) << "and can be put up";
  for (std::uint8_t n = 0; n < scene.def().tools.size(); ++n)
    if (scene.def().tools[n].name == "loop_trimmer") hands.hand[0].tool = n + 1;
  hands.hand[0].active = true;
  hands.hand[0].position = {0.054, 0.08, 0.0};
  run(1.5);
  hands.hand[0].active = false;
  ASSERT_LT(scene.clay().volume(), 0.999 * lump);
  run(0.6);
  int undone = 0;
  for (; undone < 10; ++undone) {
    hands.restore = true;
    scene.step(hands, 0.001);
    hands.restore = false;
    while (scene.laying()) scene.step(hands, 0.001);
    if (!scene.can_restore()) break;
    scene.step(hands, 0.001);
  }
  EXPECT_LT(undone, 3);
  EXPECT_NEAR(scene.clay().volume() / lump, 1.0, 1e-8);
  EXPECT_NEAR(scene.clay().rim_height(), rim, 1e-9);
}

// A rim that is pressed gets its girth some ticks later: what was on its way comes all the same.
TEST(LumpWork, WhatAPressedRimWasStillOwedComesToTheClayThatIsTakenBack) {
  SceneDef def;
  def.clay.rows = 36;
  def.clay.sectors = 33;
  def.volume.emplace();
  Scene scene = std::move(*Scene::create(def));
  const double lump = scene.clay().volume();
  Hands hands;
  hands.hand[0] = {.position = {0.0, 0.205, 0.05}, .active = true};
  for (int t = 0; t < 40; ++t) scene.step(hands, 1e-6);
  ASSERT_GT(std::fabs(scene.clay().volume() / lump - 1.0), 1e-8) << "nothing is on its way";
  Hands renew;
  renew.renew = true;
  scene.step(renew, 0.001);
  while (scene.laying()) scene.step(renew, 0.001);
  Hands restore;
  restore.restore = true;
  scene.step(restore, 0.001);
  for (int t = 0; scene.laying() || t < 20; ++t) scene.step(restore, 0.001);
  EXPECT_LT(scene.clay().rim_height(), def.clay.height);
  EXPECT_NEAR(scene.clay().volume() / lump, 1.0, 1e-8);
}

}  // namespace
}  // namespace onggi::scene::lump_work_test
