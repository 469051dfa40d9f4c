#include "engine/profile/up.h"

#include <gtest/gtest.h>

#include "engine/profile/extraction.h"
#include "tests/engine/profile/mean_shapes.h"

// Which end of a scan is up: evidence weighed, never one sign alone.

namespace onggi::up_test {
namespace {

ExtractedProfile read(const TriangleMesh& mesh) {
  const auto found = extract_profile(mesh, {}, "scan");
  EXPECT_TRUE(found) << to_text(found.error());
  return found ? *found : ExtractedProfile{};
}

bool says(const ExtractedProfile& found, const std::string& words) {
  for (const std::string& w : found.warnings)
    if (w.find(words) != std::string::npos) return true;
  return false;
}

TEST(Up, a_hollow_foot_is_no_mouth) {
  for (const double hollow : {0.0, 0.05, 0.08, 0.10, 0.15}) {
    SCOPED_TRACE(hollow);
    for (const TriangleMesh& mesh :
         {shapes::lidded_pot(hollow), shapes::teapot(hollow), shapes::covered_cup(hollow)}) {
      EXPECT_GT(read(mesh).axis_direction.y, 0.999);
      EXPECT_GT(read(shapes::z_up(mesh)).axis_direction.z, 0.999);
    }
  }
}

TEST(Up, what_could_be_read_otherwise_says_so_with_the_line_to_write) {
  const ExtractedProfile pot = read(shapes::lidded_pot(0.09));
  EXPECT_LT(pot.up_sure, 0.95);
  EXPECT_GT(pot.up_sure, 0.5);
  EXPECT_TRUE(says(pot, "up = \"-y\""));
  EXPECT_TRUE(says(read(shapes::z_up(shapes::lidded_pot(0.09))), "up = \"-z\""));
  const ExtractedProfile jar = read(revolve(section_of(shapes::jar()), 96));
  EXPECT_GT(jar.up_sure, 0.99);
  EXPECT_FALSE(says(jar, "up ="));
}

TEST(Up, what_is_deep_below_is_turned_over) {
  for (const TriangleMesh& mesh : {shapes::covered_cup(0.36), shapes::covered_cup(0.6)}) {
    const ExtractedProfile found = read(mesh);
    EXPECT_LT(found.axis_direction.y, -0.999);
    EXPECT_EQ(found.up_from, UpFrom::opening);
  }
  for (const Profile& p : {shapes::jar(), shapes::bottle(), shapes::bowl()}) {
    const ExtractedProfile found = read(shapes::overturned(revolve(section_of(p), 96)));
    EXPECT_LT(found.axis_direction.y, -0.999);
    EXPECT_EQ(found.up_from, UpFrom::opening);
    EXPECT_GT(found.up_sure, 0.8);
  }
}

TEST(Up, of_two_hollows_the_one_that_holds_more_is_the_mouth) {
  EXPECT_GT(read(shapes::footed_bowl()).axis_direction.y, 0.999);
  EXPECT_LT(read(shapes::overturned(shapes::footed_bowl())).axis_direction.y, -0.999);
}

TEST(Up, in_no_axis_of_the_file_the_foot_is_where_it_stands) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const shapes::Pose pose = shapes::random_pose(seed);
    const ExtractedProfile found = read(moved(shapes::lidded_pot(0.03), pose));
    EXPECT_GT(dot(found.axis_direction, pose.y), 0.999) << seed;
    EXPECT_LT(found.up_sure, 0.95);
  }
}

TEST(Up, given_across_the_axis_decides_nothing_and_is_told) {
  const TriangleMesh mesh = shapes::footed_bowl();
  const auto free = extract_profile(mesh, {}, "a bowl");
  ASSERT_TRUE(free);
  for (const Vec3 across : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
    ExtractionOptions options;
    options.up = across;
    const auto told = extract_profile(mesh, options, "a bowl");
    ASSERT_TRUE(told);
    EXPECT_GT(dot(told->axis_direction, free->axis_direction), 0.99);
    EXPECT_EQ(told->up_from, free->up_from);
    ASSERT_EQ(told->warnings.size(), free->warnings.size() + 1);
    EXPECT_NE(told->warnings.front().find("y or -y"), std::string::npos) << told->warnings.front();
  }
}

TEST(Up, given_is_given) {
  ExtractionOptions options;
  options.up = Vec3{0, -1, 0};
  const auto told = extract_profile(shapes::lidded_pot(0.09), options, "scan");
  ASSERT_TRUE(told);
  EXPECT_LT(told->axis_direction.y, -0.999);
  EXPECT_EQ(told->up_from, UpFrom::given);
  EXPECT_EQ(told->up_sure, 1.0);
  EXPECT_FALSE(says(*told, "up ="));
}

TEST(Up, a_tube_is_open_at_both_ends_and_is_told_so) {
  const ExtractedProfile found = read(shapes::tube(0.2, 0.05, 0.045));
  EXPECT_TRUE(says(found, "Both ends are open"));
  EXPECT_FALSE(says(found, "Neither end"));
  EXPECT_FALSE(says(found, "hole through the base"));
  EXPECT_EQ(found.profile.inner_wall, InnerWall::measured);
}

TEST(Up, the_weighing_is_the_same_looked_at_from_either_end) {
  extraction::UpSigns signs;
  signs.above = {.depth = 0.3, .holds = 0.2, .radius = 0.9};
  signs.below = {.depth = 0.1, .holds = 0.05, .radius = 0.6};
  signs.file = 0.8;
  signs.handles = 0.2;
  signs.mass = -0.1;
  const extraction::UpChoice a = weigh(signs);
  std::swap(signs.above, signs.below);
  signs.file = -signs.file;
  signs.handles = -signs.handles;
  signs.mass = -signs.mass;
  const extraction::UpChoice b = weigh(signs);
  EXPECT_EQ(a.turn, !b.turn);
  EXPECT_DOUBLE_EQ(a.sure, b.sure);
  EXPECT_EQ(a.from, b.from);
}

}  // namespace
}  // namespace onggi::up_test
