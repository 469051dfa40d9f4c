#include "engine/surface/resist.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::resist_test {
namespace {

TEST(Resist, CoversItsWidthAndUncoversIt) {
  Surface surface = made(bowl());
  const std::uint64_t bare = surface.hash();
  ResistDef def;
  const auto way = straight(surface, {0.015, 0.0}, {0.030, 0.0});
  done(surface, def, way);
  double wide = 0.0;
  for (int i = -100; i <= 100; ++i) wide += surface.resist(90, wrapped(i));
  EXPECT_NEAR(wide * surface.row(90).width * 1e-9, def.width, 0.0003);
  EXPECT_TRUE(surface.resist(38, 0));   // 5.5 mm before its beginning
  EXPECT_FALSE(surface.resist(34, 0));  // 6.4
  def.lifts = true;
  done(surface, def, way);
  EXPECT_EQ(surface.hash(), bare);
}

TEST(Resist, WithoutPressureNothingIsCovered) {
  Surface surface = made(bowl());
  done(surface, ResistDef{}, straight(surface, {0.015, 0.0, 0.0}, {0.030, 0.0, 0.0}));
  EXPECT_EQ(surface.hash(), made(bowl()).hash());
}

}  // namespace
}  // namespace onggi::surface_test::resist_test
