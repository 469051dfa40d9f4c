#include "engine/profile/profile.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/engine/profile/shapes.h"

namespace onggi::profile_test {
namespace {

TEST(Profile, radii_are_linear_between_points_and_held_beyond_the_ends) {
  Profile p;
  p.points = {{0, 0.04, 0}, {0.1, 0.06, 0.05}, {0.2, 0.05, 0.045}};
  EXPECT_DOUBLE_EQ(p.outer_at(0.05), 0.05);
  EXPECT_DOUBLE_EQ(p.inner_at(0.15), 0.0475);
  EXPECT_DOUBLE_EQ(p.outer_at(-1), 0.04);
  EXPECT_DOUBLE_EQ(p.outer_at(1), 0.05);
  EXPECT_DOUBLE_EQ(p.outer_at(0.1), 0.06);
  EXPECT_DOUBLE_EQ(p.max_radius(), 0.06);
  EXPECT_DOUBLE_EQ(p.floor_height(), 0.1);
}

TEST(Profile, scaling_there_and_back_is_the_same_vessel) {
  const Profile p = shapes::jar();
  const Profile back = scaled(scaled(p, 3.7), 1.0 / 3.7);
  for (std::size_t i = 0; i < p.points.size(); ++i)
    EXPECT_NEAR(back.points[i].outer, p.points[i].outer, 1e-15);
}

TEST(Profile, resampling_keeps_the_outline) {
  const Profile p = shapes::bottle();
  const Profile even = resampled(p, 2000);
  EXPECT_EQ(even.points.size(), 2000u);
  EXPECT_EQ(even.points.front().height, 0.0);
  EXPECT_DOUBLE_EQ(even.height(), p.height());
  for (double h = 0; h < p.height(); h += 0.0007)
    EXPECT_NEAR(even.outer_at(h), p.outer_at(h), 2e-5);
}

TEST(Profile, what_is_wrong_with_one_is_said_with_the_point) {
  EXPECT_TRUE(validate(shapes::jar(), "jar").has_value());
  const auto wrong = [](auto&& spoil) {
    Profile p = shapes::jar();
    spoil(p.points);
    const auto result = validate(p, "jar");
    return result ? std::string() : to_text(result.error());
  };
  EXPECT_NE(wrong([](auto& p) { p.resize(1); }).find("at least two"), std::string::npos);
  EXPECT_NE(wrong([](auto& p) { p[0].height = 0.0001; }).find("point 1"), std::string::npos);
  EXPECT_NE(wrong([](auto& p) { p[4].height = p[3].height; }).find("jar, point 5"),
            std::string::npos);
  EXPECT_NE(wrong([](auto& p) { p[7].outer = -0.1; }).find("outer"), std::string::npos);
  EXPECT_NE(wrong([](auto& p) { p[9].inner = p[9].outer; }).find("inner"), std::string::npos);
  EXPECT_NE(wrong([](auto& p) {
              p[9].inner = std::numeric_limits<double>::quiet_NaN();
            }).find("not a number"),
            std::string::npos);
}

}  // namespace
}  // namespace onggi::profile_test
