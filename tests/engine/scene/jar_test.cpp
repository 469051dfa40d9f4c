#include "engine/scene/jar.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/profile/capacity.h"
#include "engine/scene/lump.h"

namespace onggi::jar_test {
namespace {

SceneDef with_walls() {
  SceneDef def;
  def.walls = WallsDef{};
  return def;
}

TEST(Jar, HoldsWhatWasAskedFromATenthOfALitreToThreeInEveryKindOfScene) {
  SceneDef kept = with_walls();
  kept.volume = VolumeDef{};
  for (const SceneDef& scene : {SceneDef{}, with_walls(), kept})
    for (const double litres : {0.1, 0.25, 1.0, 2.0, 3.0}) {
      const auto jar = jar_that_holds({.volume = 1e-3 * litres}, scene);
      ASSERT_TRUE(jar) << litres << ": " << to_text(jar.error());
      EXPECT_NEAR(capacity(*jar) * 1e3, litres, 1e-3 * litres);
      EXPECT_TRUE(validate(*jar, "jar"));
      EXPECT_LE(jar->height(), 0.2 + 1e-12);
      EXPECT_LE(2 * jar->max_radius(), 0.22 + 1e-12);
      SceneDef laid = scene;
      laid.clay = lump_for(*jar, laid);
      EXPECT_TRUE(validate(laid)) << "its lump can be laid";
    }
}

RC_GTEST_PROP(JarProperty, KeepsWithinItsBoundsOrSaysThatThereIsNone, ()) {
  JarWish wish;
  wish.volume = 1e-5 * *rc::gen::inRange(10, 301);
  wish.height_least = 1e-3 * *rc::gen::inRange(40, 200);
  wish.height_most = wish.height_least + 1e-3 * *rc::gen::inRange(0, 40);
  wish.mouth_least = 1e-3 * *rc::gen::inRange(40, 200);
  wish.mouth_most = wish.mouth_least + 1e-3 * *rc::gen::inRange(0, 40);
  const auto jar = jar_that_holds(wish, with_walls());
  if (!jar) {
    RC_ASSERT(jar.error().what.find("litres") != std::string::npos);
    return;
  }
  const double mouth = 2 * jar->points.back().outer;
  RC_ASSERT(std::abs(capacity(*jar) - wish.volume) <= 1e-3 * wish.volume);
  RC_ASSERT(jar->height() >= wish.height_least - 1e-9);
  RC_ASSERT(jar->height() <= std::min(wish.height_most, 0.2) + 1e-9);
  RC_ASSERT(mouth >= wish.mouth_least - 1e-9);
  RC_ASSERT(mouth <= std::min(wish.mouth_most, 0.22) + 1e-9);
}

TEST(Jar, ThatCannotBeIsRefusedWithWhatComesNearest) {
  const auto jar = jar_that_holds({.volume = 0.003, .height_most = 0.05}, with_walls());
  ASSERT_FALSE(jar);
  EXPECT_NE(jar.error().where.find("3.00 litres"), std::string::npos) << jar.error().where;
  EXPECT_NE(jar.error().remedy.find("height_mm"), std::string::npos);
}

}  // namespace
}  // namespace onggi::jar_test
