#include "kiosk/lab/measure/price_list.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <memory>

namespace onggi::measure::price_list_test {
namespace {

// What an effect changes is measured, beside what it costs: nothing of itself, friction of the
// force alone, and of the outline what lets a wall follow or drags its neighbours along.
TEST(PriceList, TellsWhatAnEffectChangesInShapeAndInForce) {
  std::vector<PricedScene> scenes;
  for (const PricedScene& scene : priced_scenes(100, 90))
    if (scene.name == "base" || scene.name == "+ friction" || scene.name == "+ propagation" ||
        scene.name == "+ walls")
      scenes.push_back(scene);
  ASSERT_EQ(scenes.size(), 4u);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::tmpfile(), std::fclose);
  const auto list = measure_prices(scenes, 100, 90, 1, false, nowhere.get());
  ASSERT_TRUE(list) << list.error().what;
  std::map<std::string, EffectPrice> of;
  for (const EffectPrice& price : list->prices) of[price.name] = price;
  EXPECT_EQ(of["base"].shape, 0.0);
  EXPECT_EQ(of["base"].force, 0.0);
  EXPECT_EQ(of["+ friction"].shape, 0.0) << "friction moves no clay";
  EXPECT_GT(of["+ friction"].force, 0.01);
  for (const char* moves : {"+ propagation", "+ walls"}) {
    EXPECT_GT(of[moves].shape, 1e-5) << moves;
    EXPECT_LT(of[moves].shape, 0.02) << moves;
    EXPECT_GE(of[moves].shape_max, of[moves].shape) << moves;
  }
}

TEST(PriceList, SaysWhenAnEffectCannotHaveCostLessThanNone) {
  EffectPrice base, moisture, preset;
  base.name = "base";
  base.median_ns = 4500;
  moisture.name = "+ moisture";
  moisture.median_ns = 4400;  // as much as a quiet machine varies
  preset.name = "first_touch.toml";
  preset.median_ns = 1900;  // another scene, not the base with an effect
  PriceList list{400, 360, {base, moisture, preset}};
  EXPECT_EQ(doubt_of(list), "");
  EXPECT_NE(json_of(list).text().find("\"times_hold\": true"), std::string::npos)
      << json_of(list).text();
  list.prices[1].median_ns = 2800;
  EXPECT_NE(doubt_of(list).find("\"+ moisture\" took 2800 ns and no effect at all 4500 ns."),
            std::string::npos)
      << doubt_of(list);
  EXPECT_NE(json_of(list).text().find("\"times_hold\": false"), std::string::npos);
}

}  // namespace
}  // namespace onggi::measure::price_list_test
