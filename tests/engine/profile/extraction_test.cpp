#include "engine/profile/extraction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "engine/profile/axis.h"
#include "engine/profile/measures.h"
#include "tests/engine/profile/mean_shapes.h"

namespace onggi::extraction_test {
namespace {

using shapes::add_handle;
using shapes::moved;
using shapes::Pose;
using shapes::random_pose;

/// Vertices stirred by up to `by` metres every way; welded vertices move together.
TriangleMesh rough(TriangleMesh mesh, double by, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> stir(-by, by);
  std::map<std::array<float, 3>, std::array<float, 3>> weld;
  for (auto& p : mesh.positions) {
    const auto [found, fresh] = weld.try_emplace(p, p);
    if (fresh)
      for (float& v : found->second) v = static_cast<float>(v + stir(random));
    p = found->second;
  }
  return mesh;
}

double rms(const Profile& a, const Profile& b, bool inner) {
  double sum = 0.0;
  const double low = inner ? a.floor_height() + 0.03 * a.height() : 0.02 * a.height();
  for (int i = 0; i < 300; ++i) {
    const double h = low + (0.98 * a.height() - low) * i / 299;
    const double d = inner ? a.inner_at(h) - b.inner_at(h) : a.outer_at(h) - b.outer_at(h);
    sum += d * d;
  }
  return std::sqrt(sum / 300) / a.height();
}

struct Case {
  const char* name;
  Profile profile;
};
std::vector<Case> cases() {
  return {{"jar", shapes::jar()}, {"bottle", shapes::bottle()}, {"bowl", shapes::bowl()}};
}

TEST(Extraction, an_upright_vessel_gives_its_own_profile_back) {
  for (const Case& c : cases()) {
    const auto found = extract_profile(revolve(section_of(c.profile), 128), {}, c.name);
    ASSERT_TRUE(found) << to_text(found.error());
    EXPECT_LT(rms(c.profile, found->profile, false), 0.002) << c.name;
    EXPECT_LT(rms(c.profile, found->profile, true), 0.003) << c.name;
    EXPECT_NEAR(found->profile.height(), c.profile.height(), 0.003 * c.profile.height());
    EXPECT_NEAR(found->profile.floor_height(), c.profile.floor_height(), 0.02 * c.profile.height());
    EXPECT_EQ(found->profile.inner_wall, InnerWall::measured) << c.name;
    EXPECT_GT(found->symmetry, 0.995);
    EXPECT_LT(found->masked_fraction, 0.01);
    EXPECT_TRUE(found->warnings.empty()) << found->warnings[0];
  }
}

RC_GTEST_PROP(Extraction, lying_anywhere_and_any_way_it_is_found_within_half_a_percent, ()) {
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const Case c = cases()[seed % 3];
  const Pose pose = random_pose(seed);
  const TriangleMesh mesh = revolve(section_of(resampled(c.profile, 70)), 72);
  const auto found = extract_profile(moved(mesh, pose), {}, c.name);
  RC_ASSERT(found.has_value());
  RC_LOG() << c.name << " outer " << rms(c.profile, found->profile, false) << " inner "
           << rms(c.profile, found->profile, true);
  RC_ASSERT(dot(found->axis_direction, pose.y) > 0.9999);
  RC_ASSERT(rms(c.profile, found->profile, false) < 0.005);
  RC_ASSERT(rms(c.profile, found->profile, true) < 0.005);
  RC_ASSERT(length(found->axis_origin - pose.shift) < 0.01 * c.profile.height());
}

TEST(Extraction, a_surface_rough_by_one_percent_keeps_its_outline) {
  for (const Case& c : cases())
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const double by = 0.01 * c.profile.height();
      const auto mesh =
          moved(rough(revolve(section_of(c.profile), 96), by, seed), random_pose(seed + 10));
      const auto found = extract_profile(mesh, {}, c.name);
      ASSERT_TRUE(found) << to_text(found.error());
      EXPECT_LT(rms(c.profile, found->profile, false), 0.005) << c.name << " " << seed;
    }
}

TEST(Extraction, a_handle_is_masked) {
  const Profile p = shapes::jar();
  TriangleMesh mesh = revolve(section_of(p), 128);
  mesh.normals.clear();
  add_handle(mesh, p, 0.08, 0.25, 0.05, 0.012);
  for (const unsigned seed : {0u, 7u}) {
    const auto found =
        extract_profile(seed == 0 ? mesh : moved(mesh, random_pose(seed)), {}, "jug");
    ASSERT_TRUE(found) << to_text(found.error());
    EXPECT_LT(rms(p, found->profile, false), 0.005);
    EXPECT_GT(found->masked_fraction, 0.01);
    EXPECT_LT(found->masked_fraction, 0.15);
    ASSERT_FALSE(found->warnings.empty());
  }
}

TEST(Extraction, standing_on_its_head_it_is_turned_over_unless_up_is_given) {
  const Profile p = shapes::jar();
  const Pose over{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {}};
  const TriangleMesh mesh = moved(revolve(section_of(p), 96), over);
  const auto found = extract_profile(mesh, {}, "jar");
  ASSERT_TRUE(found);
  EXPECT_LT(found->axis_direction.y, -0.999);
  ExtractionOptions options;
  options.up = Vec3{0, 1, 0};
  const auto told = extract_profile(mesh, options, "jar");
  ASSERT_TRUE(told);
  EXPECT_GT(told->axis_direction.y, 0.999);
}

TEST(Extraction, a_bare_outside_has_its_inner_wall_inferred) {
  Profile solid = shapes::bottle();
  for (ProfilePoint& p : solid.points) p.inner = 0.0;
  const auto found = extract_profile(revolve(section_of(solid), 96), {}, "bottle");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->profile.inner_wall, InnerWall::inferred);
  EXPECT_LT(rms(solid, found->profile, false), 0.003);
  const double wall = dimensions(found->profile).wall_mean;
  EXPECT_NEAR(wall, 0.04 * solid.max_radius(), 0.25 * 0.04 * solid.max_radius());
  EXPECT_GE(found->warnings.size(), 1u);
}

TEST(Extraction, what_is_not_turned_is_refused_by_name) {
  const auto refused = [](const TriangleMesh& mesh) {
    const auto found = extract_profile(mesh, {}, "thing.glb");
    if (found) return std::string("(found one)");
    EXPECT_EQ(found.error().where, "thing.glb");
    EXPECT_FALSE(found.error().remedy.empty());
    return found.error().what;
  };
  const Section box{{{0, 0}, {0.1, 0}, {0.1, 0.2}, {0, 0.2}}};
  TriangleMesh brick = revolve(box, 4);
  for (auto& p : brick.positions) p[0] *= 3.0f;
  EXPECT_NE(refused(brick).find("not a body of revolution"), std::string::npos) << refused(brick);

  TriangleMesh pair = revolve(section_of(shapes::jar()), 48);
  const auto n = static_cast<std::uint32_t>(pair.positions.size());
  const std::size_t triangles = pair.triangles.size();
  for (std::uint32_t i = 0; i < n; ++i)
    pair.positions.push_back({pair.positions[i][0] + 0.9f, pair.positions[i][1], 0.4f});
  for (std::size_t i = 0; i < triangles; ++i)
    pair.triangles.push_back(
        {pair.triangles[i][0] + n, pair.triangles[i][1] + n, pair.triangles[i][2] + n});
  EXPECT_NE(refused(pair).find("not a body of revolution"), std::string::npos) << refused(pair);

  EXPECT_NE(refused({}).find("no triangles"), std::string::npos);
  TriangleMesh broken = revolve(section_of(shapes::jar()), 16);
  broken.positions[3][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refused(broken).find("not a number"), std::string::npos);
  broken.positions[3][1] = 0;
  broken.triangles[5][0] = 1u << 30;
  EXPECT_NE(refused(broken).find("not there"), std::string::npos);
  TriangleMesh point = revolve(section_of(shapes::jar()), 16);
  for (auto& p : point.positions) p = {0, 0, 0};
  EXPECT_NE(refused(point).find("no size"), std::string::npos);
}

TEST(Extraction, a_heap_of_loose_triangles_is_refused_before_an_axis_is_sought) {
  const auto found = extract_profile(shapes::soup(5000, 3), {}, "heap");
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().what.find("heap of loose triangles"), std::string::npos)
      << found.error().what;
  // A vessel whose triangles share no corner is none.
  TriangleMesh loose, whole = revolve(section_of(shapes::jar()), 96);
  for (const auto& t : whole.triangles) {
    const auto n = static_cast<std::uint32_t>(loose.positions.size());
    for (const std::uint32_t i : t) loose.positions.push_back(whole.positions[i]);
    loose.triangles.push_back({n, n + 1, n + 2});
  }
  EXPECT_TRUE(extract_profile(loose, {}, "loose"));
  EXPECT_EQ(extraction::surfaces_met(loose), extraction::surfaces_met(whole));
  EXPECT_LT(extraction::surfaces_met(shapes::teapot(0.1)), 8);
}

TEST(Extraction, the_same_mesh_gives_the_same_bits) {
  const TriangleMesh mesh = moved(revolve(section_of(shapes::jar()), 64), random_pose(5));
  const auto a = extract_profile(mesh, {}, "a"), b = extract_profile(mesh, {}, "b");
  ASSERT_TRUE(a && b);
  for (std::size_t i = 0; i < a->profile.points.size(); ++i) {
    EXPECT_EQ(a->profile.points[i].outer, b->profile.points[i].outer);
    EXPECT_EQ(a->profile.points[i].inner, b->profile.points[i].inner);
  }
}

}  // namespace
}  // namespace onggi::extraction_test
