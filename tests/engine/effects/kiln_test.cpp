#include "engine/effects/kiln.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace onggi::kiln_test {
namespace {

KilnDef kiln(double drying, double firing) {
  KilnDef def;
  def.drying_shrinkage = drying;
  def.firing_shrinkage = firing;
  return def;
}

// Share of every length that is lost in all.
double lost(const KilnDef& def) { return 1.0 - size_after(def, {1.0, 1.0}); }

double percent(double number, double of) { return *rc::gen::inRange(0, 101) * 0.01 * of + number; }

TEST(Kiln, SixAndAQuarterAndSixAndTwoThirdsAreTwelveAndAHalfAndNotTheirSum) {
  EXPECT_NEAR(lost(kiln(0.0625, 0.0666)), 0.125, 1e-4);
  EXPECT_LT(lost(kiln(0.0625, 0.0666)), 0.0625 + 0.0666 - 0.004);
}

TEST(Kiln, APotOf148mmComesOutAt130) {
  EXPECT_NEAR(148.0 * size_after(KilnDef{}, {1.0, 1.0}), 129.5, 0.05);
}

TEST(Kiln, EveryClayBodyShrinksAsMuchAsIsPublishedForIt) {
  const struct {
    const char* name;
    double least, most;
  } published[] = {
      {"earthenware", 0.08, 0.12}, {"stoneware", 0.11, 0.15}, {"porcelain", 0.14, 0.20}};
  EXPECT_EQ(clay_bodies().size(), std::size(published));
  for (const auto& [name, least, most] : published) {
    const ClayBody* body = find_clay_body(name);
    ASSERT_NE(body, nullptr) << name;
    const KilnDef def = kiln(body->drying_shrinkage, body->firing_shrinkage);
    EXPECT_TRUE(check_fields(def)) << name;
    EXPECT_NEAR(lost(def), 0.5 * (least + most), 0.0075) << name;
  }
  EXPECT_EQ(find_clay_body("marble"), nullptr);
  const ClayBody* usual = find_clay_body("stoneware");
  EXPECT_EQ(usual->drying_shrinkage, KilnDef{}.drying_shrinkage);
  EXPECT_EQ(usual->firing_shrinkage, KilnDef{}.firing_shrinkage);
}

RC_GTEST_PROP(KilnProperty, APotNeverGrowsOnItsWayThroughTheKiln, ()) {
  const KilnDef def = kiln(percent(0, 0.15), percent(0, 0.2));
  const Firing now{percent(0, 1), percent(0, 1)};
  const Firing later{percent(now.dried, 1.0 - now.dried), percent(now.fired, 1.0 - now.fired)};
  RC_ASSERT(size_after(def, {}) == 1.0);
  RC_ASSERT(size_after(def, later) <= size_after(def, now) + 1e-15);
  RC_ASSERT(size_after(def, later) >= 1.0 - lost(def) - 1e-15);
}

TEST(Kiln, FiguresOutOfRangeAreNamedWithARemedy) {
  for (const DefField<KilnDef>& field : KilnDef::fields()) {
    for (const double bad :
         {field.least - 0.01, field.most * 1.5, std::numeric_limits<double>::quiet_NaN()}) {
      KilnDef def;
      def.*(field.value) = bad;
      const Result<void> good = check_fields(def);
      ASSERT_FALSE(good) << field.key;
      EXPECT_EQ(good.error().where, std::string("kiln.") + field.key);
      EXPECT_FALSE(good.error().remedy.empty());
    }
  }
}

}  // namespace
}  // namespace onggi::kiln_test
