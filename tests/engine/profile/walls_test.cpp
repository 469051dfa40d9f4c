#include <gtest/gtest.h>

#include "engine/profile/extraction.h"
#include "tests/engine/profile/mean_shapes.h"

// "Measured" is said of a height only where both sides of one wall were met there.

namespace onggi::walls_test {
namespace {

ExtractedProfile read(const TriangleMesh& mesh) {
  const auto found = extract_profile(mesh, {}, "scan");
  EXPECT_TRUE(found) << to_text(found.error());
  return found ? *found : ExtractedProfile{};
}

/// Of all points between two heights, how many are said to be measured, 0..1.
double seen(const ExtractedProfile& e, double low, double high) {
  double all = 0.0, good = 0.0;
  for (std::size_t i = 0; i < e.profile.points.size(); ++i) {
    if (e.profile.points[i].height < low || e.profile.points[i].height > high) continue;
    all += 1.0;
    if (e.inner_seen[i]) good += 1.0;
  }
  return good / all;
}

TEST(Walls, the_inside_of_a_skirt_is_not_the_inside_of_the_pot) {
  const ExtractedProfile e = read(shapes::skirted_pot());
  for (double h = 0.02; h < 0.198; h += 0.002) {
    const double true_inner = 0.088 + 0.006 * (h - 0.012) / 0.188;
    EXPECT_NEAR(e.profile.inner_at(h), true_inner, 0.0006) << h;
  }
  EXPECT_EQ(seen(e, 0.152, 0.183), 0.0);
  EXPECT_EQ(seen(e, 0.020, 0.148), 1.0);
  EXPECT_EQ(seen(e, 0.187, 0.199), 1.0);
  bool told = false;
  for (const std::string& w : e.warnings)
    told = told || w.find("Both sides of the wall are measured on 8") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST(Walls, a_collar_round_the_neck_is_another_wall) {
  const ExtractedProfile e = read(shapes::moated_crock());
  for (double h = 0.02; h < 0.198; h += 0.002) EXPECT_NEAR(e.profile.inner_at(h), 0.09, 0.0005);
  EXPECT_EQ(seen(e, 0.167, 0.188), 0.0);
  EXPECT_EQ(seen(e, 0.020, 0.148), 1.0);
  EXPECT_EQ(seen(e, 0.192, 0.199), 1.0);
}

TEST(Walls, a_lid_does_not_hide_a_wall_that_is_there) {
  const ExtractedProfile e = read(shapes::hollow_lidded_pot());
  EXPECT_EQ(seen(e, 0.025, shapes::kTall - 0.003), 1.0);
  EXPECT_NEAR(e.profile.floor_height(), 0.02, 0.002);
  for (double h = 0.03; h < shapes::kTall - 0.003; h += 0.004)
    EXPECT_NEAR(e.profile.inner_at(h), shapes::pot_body().outer_at(h) - 0.005, 0.0006) << h;
  // Without that hollow all of it is inferred.
  EXPECT_EQ(seen(read(shapes::lidded_pot(0.05)), 0.0, 1.0), 0.0);
}

TEST(Walls, a_cup_on_a_stem_keeps_its_floor) {
  const ExtractedProfile e = read(shapes::goblet());
  EXPECT_NEAR(e.profile.floor_height(), 0.110, 0.003);
  EXPECT_EQ(seen(e, 0.125, 0.178), 1.0);
  for (const std::string& w : e.warnings)
    EXPECT_EQ(w.find("modelled only"), std::string::npos) << w;
}

TEST(Walls, a_mouth_modelled_into_a_solid_body_leaves_its_wall_a_guess) {
  Section s;  // a bottle whose neck is hollow, 5 of 30 cm
  s.outline = {{0, 0},        {0.06, 0},     {0.08, 0.10},  {0.05, 0.20}, {0.025, 0.24},
               {0.025, 0.30}, {0.020, 0.30}, {0.020, 0.25}, {0, 0.25}};
  const ExtractedProfile e = read(revolve(s, 96));
  EXPECT_EQ(e.profile.inner_wall, InnerWall::inferred);
  EXPECT_EQ(seen(e, 0.252, 0.298), 1.0);
  EXPECT_EQ(seen(e, 0.0, 0.248), 0.0);
  EXPECT_LT(e.profile.floor_height(), 0.02);
}

TEST(Walls, a_post_on_the_floor_is_no_wall) {
  const TriangleMesh cup = revolve(section_of(shapes::cylinder(0.1, 0.05, 0.045, 0.01)), 96);
  Section post{{{0, 0.01}, {0.008, 0.01}, {0.008, 0.09}, {0, 0.09}}};
  const ExtractedProfile e = read(shapes::joined(cup, revolve(post, 32)));
  for (double h = 0.02; h < 0.098; h += 0.004) EXPECT_NEAR(e.profile.inner_at(h), 0.045, 0.0003);
  EXPECT_EQ(seen(e, 0.02, 0.098), 1.0);
}

}  // namespace
}  // namespace onggi::walls_test
