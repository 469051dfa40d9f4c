#include "kiosk/exhibit/tuning/scene_bill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace onggi::tuning::scene_bill_test {
namespace {

SceneDef small() {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 90;
  each_effect(def, [](auto& effect) { effect.reset(); });
  return def;
}

TEST(SceneBill, EachEffectIsChargedForWhatTheSceneWouldBeWithoutIt) {
  SceneDef def = small();
  def.walls.emplace();
  def.propagation.emplace();
  def.friction.emplace();
  def.kiln.emplace();
  const auto bill = bill_of("mine", def, 1);
  ASSERT_TRUE(bill);
  ASSERT_EQ(bill->lines.size(), 3u);  // the kiln has no part in the tick
  for (const BillLine& line : bill->lines) {
    if (line.effect == "propagation") {
      EXPECT_GT(line.shape_mm, 0.01);  // neighbours are dragged along
      EXPECT_GT(line.shape_max_mm, line.shape_mm);
    }
    if (line.effect == "friction") {
      EXPECT_EQ(line.shape_mm, 0.0);  // felt, and nothing else
      EXPECT_GT(line.force_n, 1e-3);
    }
  }
  EXPECT_GT(bill->whole_us, 0.0);
  const auto json = nlohmann::json::parse(json_of(*bill).text());
  EXPECT_EQ(json["effects"].size(), 3u);
  EXPECT_NE(text_of(*bill).find("propagation"), std::string::npos);
}

TEST(SceneBill, SaysWhenASceneWithoutAnEffectCannotHaveTakenLonger) {
  SceneBill bill;
  bill.whole_us = 10.0;
  bill.lines = {{"walls", "", 3.0}, {"moisture", "", -0.4}};
  EXPECT_EQ(doubt_of(bill), "");
  bill.lines[1].us = -2.5;
  EXPECT_NE(text_of(bill).find("without moisture a tick took 2.5 us longer"), std::string::npos)
      << text_of(bill);
}

const BillLine* line_for(const SceneBill& bill, const std::string& name) {
  const auto line = std::ranges::find(bill.lines, name, &BillLine::effect);
  return line == bill.lines.end() ? nullptr : &*line;
}

// A wall that only feels thinner leaves the same pot, and a hand that another holds does not feel
// it: its row says force, no shape, and stands within that of walls.
TEST(SceneBill, WhatWallsAreAskedForBesidesHasARowOfItsOwnWithinTheirs) {
  SceneDef def = small();
  def.walls.emplace();
  ASSERT_EQ(line_for(*bill_of("mine", def, 1), "bending_strength"), nullptr)
      << "nobody asks for it";
  def.walls->bending_strength = 9000.0;
  def.walls->tear_thickness = 0.006;
  def.moisture.emplace();
  def.moisture->sponge_height = 0.06;
  const auto bill = bill_of("mine", def, 1);
  ASSERT_TRUE(bill);
  ASSERT_EQ(bill->lines.size(), 5u);
  const BillLine* felt = line_for(*bill, "bending_strength");
  ASSERT_NE(felt, nullptr);
  EXPECT_EQ(felt->part_of, "walls");
  EXPECT_EQ(felt->shape_mm, 0.0);
  EXPECT_GT(felt->force_n, 1e-3);
  const BillLine* wet = line_for(*bill, "sponge_height");
  ASSERT_NE(wet, nullptr);
  EXPECT_GT(wet->shape_mm, 0.0);
  for (std::size_t n = 1; n < bill->lines.size(); ++n) {
    const BillLine &line = bill->lines[n], &above = bill->lines[n - 1];
    if (line.part_of.empty()) continue;
    EXPECT_TRUE(above.effect == line.part_of || above.part_of == line.part_of)
        << line.effect << " stands with its effect";
  }
  EXPECT_NE(text_of(*bill).find("of it bending_strength"), std::string::npos);
  EXPECT_NE(json_of(*bill).text().find("\"part_of\": \"walls\""), std::string::npos);
}

// With one hand a wall moves and does not thin, and a finger evens nothing: such a bill had nothing
// for either's price.
TEST(SceneBill, VolumeIsSeenBetweenTwoHandsAndSmoothingUnderAPalm) {
  SceneDef def = small();
  def.walls.emplace();
  def.volume.emplace();
  def.smoothing.emplace();
  const auto bill = bill_of("mine", def, 1);
  ASSERT_TRUE(bill);
  EXPECT_GT(line_for(*bill, "volume")->shape_mm, 1e-4);
  EXPECT_GT(line_for(*bill, "smoothing")->shape_mm, 1e-4);
}

TEST(SceneBill, TellsWhatEachAbsentEffectWouldAddWithWhatItNeeds) {
  SceneDef def = small();
  def.walls.emplace();
  def.friction.emplace();
  def.kiln.emplace();
  EXPECT_TRUE(bill_of("mine", def, 1)->offers.empty()) << "nobody asks";
  const auto bill = bill_of("mine", def, 1, true);
  ASSERT_TRUE(bill);
  std::vector<std::string> offered;
  for (const BillLine& line : bill->offers) offered.push_back(line.effect);
  std::ranges::sort(offered);
  EXPECT_EQ(offered,
            (std::vector<std::string>{"beating", "building", "moisture", "prints", "propagation",
                                      "slump", "smoothing", "springback", "volume", "wobble"}));
  for (const BillLine& line : bill->offers)
    if (line.effect == "propagation") {
      EXPECT_GT(line.shape_mm, 0.01);
    }
  EXPECT_EQ(nlohmann::json::parse(json_of(*bill).text())["offers"].size(), 10u);
  EXPECT_NE(text_of(*bill).find("us more"), std::string::npos);
}

TEST(SceneBill, ASceneOfThePrintedModelHasNone) {
  SceneDef def = small();
  def.paper.emplace();
  EXPECT_FALSE(bill_of("paper", def, 1));
}

}  // namespace
}  // namespace onggi::tuning::scene_bill_test
