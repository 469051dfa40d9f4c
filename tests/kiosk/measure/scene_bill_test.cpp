#include "kiosk/measure/scene_bill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace onggi::measure {
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
  EXPECT_EQ(sheet_of(*bill).rows.size(), 3u);
}

TEST(SceneBill, ASceneOfThePrintedModelHasNone) {
  SceneDef def = small();
  def.paper.emplace();
  EXPECT_FALSE(bill_of("paper", def, 1));
}

}  // namespace
}  // namespace onggi::measure
