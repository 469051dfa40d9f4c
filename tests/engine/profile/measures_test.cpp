#include "engine/profile/measures.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/engine/profile/shapes.h"

namespace onggi::measures_test {
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

/// A jar 200 mm tall, widest at 80 mm, whose way in is `shoulder` wide at 160 mm and `rim` at its
/// top (radii, m).
Profile jar_with_way_in(double shoulder, double rim) {
  Profile p;
  p.points = {{0, 0.05, 0},        {0.01, 0.055, 0},     {0.012, 0.056, 0.05},
              {0.08, 0.08, 0.074}, {0.12, 0.075, 0.069}, {0.16, 0.045, shoulder},
              {0.18, 0.045, 0.03}, {0.20, 0.045, rim}};
  return p;
}

TEST(Measures, the_way_in_is_as_open_as_its_narrowest_place_above_the_belly) {
  const auto opening = [](double shoulder, double rim) {
    return dimensions(jar_with_way_in(shoulder, rim)).opening;
  };
  EXPECT_DOUBLE_EQ(opening(0.038, 0.035), 0.03 / 0.045);
  EXPECT_DOUBLE_EQ(opening(0.020, 0.035), 0.02 / 0.045);
  EXPECT_DOUBLE_EQ(opening(0.038, 0.005), 0.005 / 0.045);
  EXPECT_DOUBLE_EQ(opening(0.038, 0.0), 0.0);
  // Widest at its foot, or at its rim: neither the floor's corner nor the rim alone is asked.
  Profile cone;
  cone.points = {
      {0, 0.08, 0}, {0.01, 0.08, 0}, {0.011, 0.08, 0.01}, {0.1, 0.06, 0.055}, {0.2, 0.03, 0.021}};
  EXPECT_DOUBLE_EQ(dimensions(cone).opening, 0.7);
  const Profile bowl = shapes::bowl();
  EXPECT_NEAR(dimensions(bowl).opening, bowl.inner_at(0.056) / bowl.outer_at(0.056), 1e-3);
}

// A narrower pot with a wall as thick, in proportion, is as open.
TEST(Measures, how_open_the_way_in_is_does_not_ask_how_wide_the_pot_is) {
  Profile slim = jar_with_way_in(0.038, 0.035);
  for (ProfilePoint& p : slim.points) p.outer *= 0.7, p.inner *= 0.7;
  EXPECT_NEAR(dimensions(slim).opening, 0.03 / 0.045, 1e-12);
}

TEST(Measures, what_the_way_in_lacks_is_a_share_of_the_vessels_own) {
  const Profile wanted = jar_with_way_in(0.038, 0.035);
  const auto lacking = [&](const Profile& made) {
    return compare(wanted, made, true).opening_lacking;
  };
  EXPECT_EQ(lacking(wanted), 0.0);
  EXPECT_EQ(lacking(scaled(wanted, 0.7)), 0.0);
  Profile thin = wanted;
  for (ProfilePoint& p : thin.points) p.inner *= 1.05;
  EXPECT_EQ(lacking(thin), 0.0);
  EXPECT_NEAR(lacking(jar_with_way_in(0.015, 0.035)), 0.5, 1e-12);
  EXPECT_EQ(lacking(jar_with_way_in(0.038, 0.0)), 1.0);
  // A pot whose own belly is at its rim is asked for a way in where the vessel has one.
  Profile funnel = jar_with_way_in(0.038, 0.035);
  funnel.points[4].inner = 0.025;
  funnel.points.back() = {0.20, 0.09, 0.08};
  EXPECT_NEAR(lacking(funnel), 0.5, 1e-12);
  EXPECT_NEAR(compare(wanted, scaled(funnel, 0.3), true).opening_lacking, 0.5, 1e-9);
}

TEST(Measures, a_way_in_that_nobody_measured_lacks_nothing) {
  for (const InnerWall known : {InnerWall::inferred, InnerWall::none}) {
    Profile wanted = jar_with_way_in(0.038, 0.035);
    wanted.inner_wall = known;
    EXPECT_EQ(dimensions(wanted).opening, 0.0);
    EXPECT_EQ(compare(wanted, jar_with_way_in(0.038, 0.0), true).opening_lacking, 0.0);
    EXPECT_EQ(compare(jar_with_way_in(0.038, 0.035), wanted, true).opening_lacking, 0.0);
  }
  // Nor does one of a vessel under its lid.
  for (const double rim : {0.0, 0.008})
    EXPECT_EQ(compare(jar_with_way_in(0.038, rim), jar_with_way_in(0.0, 0.0), true).opening_lacking,
              0.0);
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
}  // namespace onggi::measures_test
