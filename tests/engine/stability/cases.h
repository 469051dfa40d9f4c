#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "engine/lab/scene_fields.h"
#include "engine/lab/shrink.h"
#include "engine/math/portable.h"

/// What the hard cases have in common: small scenes, hands in one line, and a replay of what broke.
namespace onggi::stability {

using lab::Breach;
using lab::Invariant;
using lab::Stroke;
using lab::Trial;

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
inline constexpr double kFastest = 62.8;  // rad/s: 600 rpm

/// A pot without effects, and a guard that lets a force through soon.
inline SceneDef small(int rows = 60, int sectors = 48) {
  SceneDef def = lab::bare({});
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.keep_undo = false;
  def.guard.engage_time = 0.05;
  def.wheel.max_speed = 62.9;
  return def;
}
/// The same with every effect.
inline SceneDef everything(SceneDef def) {
  for (std::size_t n = 0; n < lab::effect_names().size(); ++n) lab::add_effect(def, n);
  return def;
}
/// The same on the model of Lee, Han & Choi 2008 as printed.
inline SceneDef printed(const SceneDef& def) {
  SceneDef paper = lab::bare(def);
  paper.paper.emplace();
  return paper;
}

/// One hand from place to place, both active; a tick is 1 ms.
inline Stroke stroke(Vec3 from, Vec3 to, int ticks, double wheel_speed = 12.0) {
  Stroke out;
  out.ticks = ticks;
  out.wheel_speed = wheel_speed;
  out.hand[0].begins = {from, true};
  out.hand[0].ends = to;
  return out;
}
inline Stroke held(Vec3 at, int ticks, double wheel_speed = 12.0) {
  return stroke(at, at, ticks, wheel_speed);
}
/// The second hand goes along, the wall between them.
inline Stroke squeezed(Vec3 from, Vec3 to, Vec3 apart, int ticks, double wheel_speed = 12.0) {
  Stroke out = stroke(from + apart, to + apart, ticks, wheel_speed);
  out.hand[0].begins.side = SideWish::outside;
  out.hand[1].begins = {from - apart, true, SideWish::inside};
  out.hand[1].ends = to - apart;
  return out;
}
inline Vec3 round_axis(double radius, double angle, double height) {
  return {radius * portable::cos(angle), height, radius * portable::sin(angle)};
}
inline std::uint8_t tool_of(const SceneDef& def, const std::string& name) {
  for (std::size_t n = 0; n < def.tools.size(); ++n)
    if (def.tools[n].name == name) return static_cast<std::uint8_t>(n + 1);
  return 0;
}

/// Writes the trial as a replay that `onggi replay` opens; its path.
inline std::string kept(const Trial& trial, std::uint64_t ticks) {
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  for (char& letter : name)
    if (letter == '/') letter = '_';
  const auto file = std::filesystem::path(testing::TempDir()) / ("onggi_" + name + ".replay");
  const std::vector<std::byte> bytes = lab::replay_of(trial, ticks);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return file.string();
}

/// Ticks of all cases of this run, told at its end.
class Tally : public testing::Environment {
 public:
  static std::uint64_t& ticks() {
    static std::uint64_t sum = 0;
    return sum;
  }
  void TearDown() override {
    std::printf("[  ticks   ] %llu\n", static_cast<unsigned long long>(ticks()));
  }
};
inline testing::Environment* const kTally = testing::AddGlobalTestEnvironment(new Tally);

/// Every invariant after every tick, and the same hash twice. What breaks one is made as small as
/// it gets and kept as a replay.
inline void expect_stable(const Trial& trial, lab::TrialChecks checks = {.twice = true}) {
  ASSERT_TRUE(validate(trial.def)) << to_text(validate(trial.def).error());
  const lab::TrialResult result = lab::run_trial(trial, checks);
  Tally::ticks() += result.ticks;
  EXPECT_GE(result.ticks, trial.ticks());
  if (!result.breach) return;
  const lab::Shrunk least = lab::least_of(trial, *result.breach, checks, 200'000);
  FAIL() << "tick " << result.breach->tick << ": " << result.breach->what << '\n'
         << lab::words_of(trial) << "\nAt the least: " << least.breach.what << '\n'
         << lab::words_of(least.trial) << '\n'
         << kept(least.trial, least.breach.tick);
}

/// The first invariant that the same hands break on the printed model.
inline std::optional<Breach> printed_breach(Trial trial) {
  trial.def = printed(trial.def);
  return lab::run_trial(trial).breach;
}

}  // namespace onggi::stability
