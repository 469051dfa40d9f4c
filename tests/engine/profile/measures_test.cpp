#include "engine/profile/measures.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/engine/profile/shapes.h"

namespace onggi {
namespace {

TEST(Measures, callipers_find_height_belly_neck_mouth_and_foot) {
  Profile p;
  p.points = {{0, 0.05, 0},        {0.01, 0.055, 0},    {0.012, 0.056, 0.05},
              {0.12, 0.10, 0.094}, {0.25, 0.03, 0.024}, {0.30, 0.045, 0.039}};
  const Dimensions d = dimensions(p);
  EXPECT_DOUBLE_EQ(d.height, 0.30);
  EXPECT_DOUBLE_EQ(d.belly, 0.20);
  EXPECT_DOUBLE_EQ(d.belly_height, 0.12);
  EXPECT_DOUBLE_EQ(d.neck, 0.06);
  EXPECT_DOUBLE_EQ(d.mouth, 0.09);
  EXPECT_NEAR(d.foot, 0.1045, 1e-9);
}

TEST(Measures, an_even_wall_is_even_and_as_thick_as_it_is) {
  const Dimensions d = dimensions(shapes::cylinder(0.2, 0.05, 0.044, 0.01));
  EXPECT_NEAR(d.wall_mean, 0.006, 1e-12);
  EXPECT_NEAR(d.wall_evenness, 1.0, 1e-6);
}

TEST(Measures, a_leaning_wall_is_measured_across_not_along_the_ground) {
  Profile cone;  // 45 degrees: the wall is thinner than its horizontal section by sqrt(2)
  cone.points = {{0, 0.02, 0}, {0.005, 0.025, 0.015}, {0.1, 0.12, 0.11}};
  EXPECT_NEAR(dimensions(cone).wall_mean, 0.01 / std::sqrt(2.0), 1e-5);
}

TEST(Measures, a_wall_thick_below_and_thin_above_is_uneven) {
  Profile p;
  p.points = {{0, 0.05, 0}, {0.01, 0.05, 0.03}, {0.2, 0.05, 0.047}};
  EXPECT_LT(dimensions(p).wall_evenness, 0.7);
}

TEST(Measures, a_vessel_is_entirely_like_itself) {
  for (const Profile& p : {shapes::jar(), shapes::bottle(), shapes::bowl()}) {
    const Measures m = compare(p, p, false);
    EXPECT_EQ(m.outline_overlap, 1.0);
    EXPECT_EQ(m.outline_rms, 0.0);
    EXPECT_EQ(m.outline_worst_sign, 0.0);
  }
}

TEST(Measures, overlap_of_two_cylinders_is_the_ratio_of_their_radii) {
  const Measures m = compare(shapes::cylinder(0.2, 0.05, 0.04, 0.01),
                             shapes::cylinder(0.2, 0.04, 0.03, 0.01), true);
  EXPECT_NEAR(m.outline_overlap, 0.8, 1e-12);
  EXPECT_NEAR(m.outline_rms, 0.01 / 0.2, 1e-12);
  EXPECT_EQ(m.outline_worst_sign, -1.0);
}

RC_GTEST_PROP(Measures, overlap_is_the_same_whichever_is_the_target, ()) {
  const double wide = *rc::gen::inRange(20, 200) / 1000.0;
  const Profile a = shapes::vessel(
      0.2, [&](double t) { return 0.03 + wide * t * (1.1 - t); }, 0.004, 0.01);
  const double ab = compare(a, shapes::jar(), true).outline_overlap;
  const double ba = compare(shapes::jar(), a, true).outline_overlap;
  RC_ASSERT(std::abs(ab - ba) < 1e-9);
  RC_ASSERT(ab > 0.0 && ab <= 1.0);
}

RC_GTEST_PROP(Measures, size_does_not_matter_when_free_of_scale, ()) {
  const double factor = *rc::gen::inRange(20, 5000) / 1000.0;
  const Measures one = compare(shapes::jar(), shapes::bottle(), true);
  const Measures other = compare(shapes::jar(), scaled(shapes::bottle(), factor), true);
  RC_ASSERT(std::abs(one.outline_rms - other.outline_rms) < 1e-12);
  RC_ASSERT(std::abs(one.outline_overlap - other.outline_overlap) < 1e-12);
  RC_ASSERT(std::abs(one.made.belly - other.made.belly) < 1e-12);
}

RC_GTEST_PROP(Measures, swelling_further_is_further_away, ()) {
  const int step = *rc::gen::inRange(1, 40);
  const auto swollen = [](double by) {
    Profile p = shapes::jar();
    for (ProfilePoint& point : p.points) point.outer += by;
    return compare(shapes::jar(), p, true);
  };
  const Measures less = swollen(step * 0.001), more = swollen((step + 1) * 0.001);
  RC_ASSERT(less.outline_rms < more.outline_rms);
  RC_ASSERT(less.outline_overlap > more.outline_overlap);
  RC_ASSERT(std::abs(less.outline_rms - step * 0.001 / 0.3) < 1e-12);
}

TEST(Measures, a_pot_too_short_misses_the_top_of_the_outline) {
  const Measures m = compare(shapes::cylinder(0.2, 0.05, 0.04, 0.01),
                             shapes::cylinder(0.1, 0.05, 0.04, 0.01), false);
  EXPECT_NEAR(m.outline_overlap, 0.5, 1e-9);
  EXPECT_GT(m.outline_worst_at, 0.49);
}

}  // namespace
}  // namespace onggi
