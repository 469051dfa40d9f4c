#include "kiosk/collection/score/hardness.h"

#include <gtest/gtest.h>

#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/collection/score/every_vessel.h"

namespace onggi::score::hardness_test {
namespace {

Profile of(const std::string& id) {
  for (const content::Vessel& v : vessels())
    if (v.id == id) return profile(v);
  ADD_FAILURE() << id;
  return {};
}

TEST(Hardness, ACylinderIsEasierThanAMoonJarAndThatThanAFlatBowl) {
  EXPECT_LT(hardness(of("cylinder_vase")), hardness(of("moon_jar")));
  EXPECT_LT(hardness(of("black_topped_jar")), hardness(of("moon_jar")));
  EXPECT_LT(hardness(of("moon_jar")), hardness(of("maebyeong")));
  EXPECT_LT(hardness(of("moon_jar")), hardness(of("tea_bowl")));
  EXPECT_LT(hardness(of("moon_jar")), hardness(of("samanid_bowl")));
}

TEST(Hardness, SizeDoesNotCount) {
  Profile large = shapes::jar();
  for (ProfilePoint& p : large.points) p.height *= 3, p.outer *= 3, p.inner *= 3;
  EXPECT_NEAR(hardness(large), hardness(shapes::jar()), 1e-9);
}

TEST(Hardness, TheNextIsTheNearestOnItsSideAndNotItself) {
  const Profile easy = shapes::cylinder(0.3, 0.05, 0.045, 0.01), jar = shapes::jar(),
                bowl = shapes::bowl();
  ASSERT_LT(hardness(easy), hardness(jar));
  ASSERT_LT(hardness(jar), hardness(bowl));
  const Profile* const all[] = {&bowl, nullptr, &jar, &easy};
  EXPECT_EQ(next_in_hardness(easy, true, all), 2u);
  EXPECT_EQ(next_in_hardness(jar, true, all), 0u);
  EXPECT_EQ(next_in_hardness(bowl, true, all), std::nullopt);
  EXPECT_EQ(next_in_hardness(bowl, false, all), 2u);
  EXPECT_EQ(next_in_hardness(easy, false, all), std::nullopt);
}

}  // namespace
}  // namespace onggi::score::hardness_test
