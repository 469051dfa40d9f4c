#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "tests/engine/effects/random_hands.h"
#include "tests/engine/effects/witnessed.h"

namespace onggi::effects::moisture_witness_test {
namespace {

using namespace effects_test;

// Written from the equations in engine/docs/effects.md alone.

// w' = (1 - w) / wetting - (w - air) / drying, or without the first part: Runge and Kutta's rule.
double wet_after(const MoistureDef& def, double w, double seconds, bool sponge, bool fire = false) {
  constexpr int kSteps = 4000;
  const double step = seconds / kSteps;
  const auto rate = [&](double now) {
    return (sponge ? (1.0 - now) / def.wetting_time : 0.0) -
           (now - def.air) / (fire ? def.fire_time : def.drying_time);
  };
  for (int n = 0; n < kSteps; ++n) {
    const double a = rate(w);
    const double b = rate(w + 0.5 * step * a);
    const double c = rate(w + 0.5 * step * b);
    w += step / 6.0 * (a + 2.0 * b + 2.0 * c + rate(w + step * c));
  }
  return w;
}

SceneDef wall(double sponge_height) {
  SceneDef def;
  def.clay.rows = 200;
  def.clay.sectors = 48;
  def.moisture.emplace();
  def.moisture->sponge_height = sponge_height;
  return def;
}

std::uint8_t tool_of(const SceneDef& def, const char* name) {
  for (std::uint8_t n = 0; n < def.tools.size(); ++n)
    if (def.tools[n].name == name) return static_cast<std::uint8_t>(n + 1);
  ADD_FAILURE() << "no " << name;
  return 0;
}

double wetness_at(const Scene& scene, double height) {
  const Clay& clay = scene.clay();
  int nearest = 0;
  for (int j = 0; j < clay.rows(); ++j)
    if (std::fabs(clay.row_height(j) - height) < std::fabs(clay.row_height(nearest) - height))
      nearest = j;
  return scene.wetness_of(nearest);
}

TEST(MoistureWitness, OneLawHoldsForAPotAndForABandWhateverIsSoakedOrDriedAtAnyTick) {
  for (const double band : {0.0, 0.06})
    for (const auto& [wetting, drying, air] :
         {std::array{5.0, 90.0, 0.0}, {60.0, 1.0, 0.0}, {0.6, 60.0, 0.3}, {2.0, 2.0, 0.8}})
      for (const double tick : {0.0001, 0.001, 0.005}) {
        SceneDef def = wall(band);
        def.moisture->wetting_time = wetting;
        def.moisture->drying_time = drying;
        def.moisture->fire_time = 7.0;
        def.moisture->air = air;
        Moisture wet(*def.moisture, 200);
        const Clay clay = std::move(*Clay::create(def.clay));
        const std::array<double, 1> at{0.1};
        double w = 0.0, off = 0.0;
        for (const auto& [seconds, sponge, fire] : {std::tuple{3.0, true, false},
                                                    {2.0, false, false},
                                                    {10.0, true, false},
                                                    {5.0, false, true},
                                                    {1.0, true, true},
                                                    {2.0, false, false}}) {
          for (int n = 0; n < std::lround(seconds / tick); ++n)
            wet.soak_or_dry(*def.moisture, clay, tick, sponge, at, fire);
          w = wet_after(*def.moisture, w, seconds, sponge, fire);
          off = std::max(off, std::fabs(wet.at(clay, 0.1) - w));
        }
        witnessed("moisture",
                  "its equation, solved by hand: band of " + std::to_string(band) +
                      " m, soaks in " + std::to_string(wetting) + " s, dries in " +
                      std::to_string(drying) + " s, " + std::to_string(tick) + " s",
                  off, 1e-9);
      }
}

// Wetness at 5, 10 and 15 cm after the hands were there for 2 s; those that touch the clay follow
// it as it gives way.
std::array<double, 3> after(const HandInput& one, const HandInput& other, bool water = false) {
  Scene scene = made(wall(0.03));
  Hands hands;
  hands.hand = {one, other};
  hands.water = water;
  for (int n = 0; n < 2000; ++n) {
    scene.step(hands, 0.001);
    for (HandInput& hand : hands.hand) {
      const double out =
          std::sqrt(hand.position.x * hand.position.x + hand.position.z * hand.position.z);
      if (out > 0.08 || out < 0.01) continue;
      const double in = 1.0 - 5e-6 / out;
      hand.position = {in * hand.position.x, hand.position.y, in * hand.position.z};
    }
  }
  return {wetness_at(scene, 0.05), wetness_at(scene, 0.10), wetness_at(scene, 0.15)};
}

HandInput with(const char* tool, double out, double height, double angle = 0.0) {
  HandInput hand;
  hand.position = {out * std::cos(angle), height, out * std::sin(angle)};
  hand.active = true;
  hand.side = SideWish::outside;
  hand.tool = tool_of(SceneDef{}, tool);
  return hand;
}

TEST(MoistureWitness, ASpongeInOneHandSoaksNothingWhereTheOtherHandIs) {
  const HandInput sponge = with("sponge", 0.07, 0.05);
  const double law = wet_after(MoistureDef{}, 0.0, 2.0, true);
  const auto alone = after(sponge, {});
  EXPECT_NEAR(alone[0], law, 2e-3);  // the first tick has not felt the clay yet
  for (const HandInput& other : {with("flat_rib", 0.165, 0.15), with("fingertip", 0.06, 0.15),
                                 with("sponge", 0.165, 0.15)}) {
    const auto both = after(sponge, other);
    const auto swapped = after(other, sponge);
    EXPECT_EQ(both, alone);
    EXPECT_EQ(swapped, alone);
    EXPECT_EQ(both[1], 0.0);
    EXPECT_EQ(both[2], 0.0);
  }
}

TEST(MoistureWitness, TwoSpongesSoakWhatOneDoesWhereTheyMeetAndEachItsOwnBand) {
  const HandInput sponge = with("sponge", 0.07, 0.05);
  const auto one = after(sponge, {});
  for (const double height : {0.05, 0.053, 0.047}) {
    const auto met = after(sponge, with("sponge", 0.07, height, 3.0));
    EXPECT_NEAR(met[0], one[0], 1e-12) << height;
  }
  const auto apart = after(sponge, with("sponge", 0.07, 0.15, 3.0));
  EXPECT_NEAR(apart[0], one[0], 1e-12);
  EXPECT_EQ(apart[1], 0.0);
  EXPECT_NEAR(apart[2], one[0], 1e-3);
}

TEST(MoistureWitness, WaterThatIsAskedForComesWithBothHandsAndSoaksOnceWhereTheyMeet) {
  const HandInput low = with("fingertip", 0.12, 0.05);
  const double law = wet_after(MoistureDef{}, 0.0, 2.0, true);
  const auto met = after(low, with("fingertip", 0.12, 0.05), true);
  EXPECT_NEAR(met[0], law, 1e-9);
  EXPECT_EQ(met[2], 0.0);
  const auto apart = after(low, with("fingertip", 0.12, 0.15), true);
  EXPECT_NEAR(apart[0], law, 1e-9);
  EXPECT_NEAR(apart[2], law, 1e-9);
  EXPECT_EQ(apart[1], 0.0);
  const auto none = after({}, {}, true);
  for (const double w : none) EXPECT_NEAR(w, law, 1e-9);
}

}  // namespace
}  // namespace onggi::effects::moisture_witness_test
