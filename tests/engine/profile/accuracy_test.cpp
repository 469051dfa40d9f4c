#include <gtest/gtest.h>

#include "engine/math/portable.h"
#include "engine/profile/extraction.h"
#include "tests/engine/profile/decimated.h"
#include "tests/engine/profile/poses.h"

// Vessels whose profile is known by a formula, spoilt one way at a time: how near does the reading
// come? The limits: RMS under 0.5 % of the height, the axis within 0.5 degrees and 0.5 % of the
// largest radius.

namespace onggi::accuracy_test {
namespace {

using shapes::add_handle;
using shapes::moved;
using shapes::Pose;
using shapes::random_pose;

struct Known {
  const char* name;
  Profile profile;
};
const std::vector<Known>& known() {
  static const std::vector<Known> all{
      {"jar", shapes::jar()},
      {"bottle", shapes::bottle()},
      {"bowl",
       shapes::vessel(
           0.075, [](double t) { return 0.03 + 0.055 * t * (1.7 - 0.7 * t); }, 0.005, 0.008)},
      {"waisted vase",
       shapes::vessel(
           0.40, [](double t) { return 0.05 + 0.03 * portable::sin(6.2 * t) + 0.02 * t; }, 0.005,
           0.010)},
      {"dish", shapes::vessel(
                   0.06, [](double t) { return 0.06 + 0.1 * t; }, 0.006, 0.010)}};
  return all;
}

TriangleMesh turned(const Profile& p) { return shapes::welded(revolve(section_of(p), 128)); }

/// Over the whole height, foot and rim included.
double rms(const Profile& wanted, const Profile& found) {
  constexpr int kHeights = 400;
  double sum = 0.0;
  for (int i = 0; i < kHeights; ++i) {
    const double h = wanted.height() * i / (kHeights - 1);
    const double d = wanted.outer_at(h) - found.outer_at(h);
    sum += d * d;
  }
  return std::sqrt(sum / kHeights) / wanted.height();
}

void expect_found(const Known& vessel, const TriangleMesh& spoilt, const Pose& pose, double scale,
                  const std::string& how, double limit = 0.005) {
  SCOPED_TRACE(std::string(vessel.name) + ", " + how);
  const auto found = extract_profile(moved(spoilt, pose, scale), {}, vessel.name);
  ASSERT_TRUE(found) << to_text(found.error());
  const Profile& wanted = vessel.profile;
  EXPECT_LT(rms(wanted, scaled(found->profile, 1.0 / scale)), limit);
  const double cosine = dot(found->axis_direction, pose.y);
  EXPECT_GT(cosine, 0.9999619230641713);  // of 0.5 degrees
  const Vec3 middle = (pose.shift + pose.y * (0.5 * wanted.height())) * scale;
  const Vec3 rest = middle - found->axis_origin;
  const Vec3 aside = rest - found->axis_direction * dot(rest, found->axis_direction);
  EXPECT_LT(length(aside), 0.005 * wanted.max_radius() * scale);
}

TEST(Accuracy, lying_anywhere_any_way_up) {
  for (const Known& v : known())
    for (unsigned seed = 1; seed <= 6; ++seed)
      expect_found(v, turned(v.profile), random_pose(seed), 1.0, std::to_string(seed));
}

TEST(Accuracy, of_any_size) {
  for (const Known& v : known())
    for (const double scale : {1e-3, 0.03, 39.37, 1e3, 1e5})
      expect_found(v, turned(v.profile), random_pose(9), scale, std::to_string(scale));
}

TEST(Accuracy, with_a_skin_rough_by_one_percent_of_the_radius) {
  for (const Known& v : known()) {
    // On the dish 1 % of its radius is half of the wall: the two sides run through each other.
    if (v.name == std::string("dish")) continue;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const double by = 0.01 * v.profile.max_radius();
      std::mt19937 random(seed);
      std::normal_distribution<double> bump(0.0,
                                            by / std::sqrt(3.0));  // every way, RMS `by` in all
      TriangleMesh mesh = turned(v.profile);
      for (auto& p : mesh.positions)
        for (float& x : p) x += static_cast<float>(bump(random));
      expect_found(v, mesh, random_pose(seed), 1.0, std::to_string(seed));
    }
  }
}

TEST(Accuracy, with_a_handle) {
  for (const Known& v : known())
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const double height = v.profile.height();
      TriangleMesh mesh = turned(v.profile);
      if (height < 0.2)
        add_handle(mesh, v.profile, 0.25 * height, 0.85 * height, 0.04, 0.008);
      else
        add_handle(mesh, v.profile, 0.27 * height, 0.83 * height, 0.05, 0.012);
      expect_found(v, mesh, random_pose(seed), 1.0, std::to_string(seed));
    }
}

TEST(Accuracy, decimated_to_five_hundred_triangles) {
  for (const Known& v : known())
    for (const bool optimal : {true, false}) {
      const TriangleMesh few = shapes::Decimator(turned(v.profile), optimal).to(500);
      ASSERT_LE(few.triangles.size(), 500u);
      // Where a decimator only leaves corners out, all that it leaves lies inside the curve.
      for (unsigned seed = 1; seed <= 3; ++seed)
        expect_found(v, few, random_pose(seed), 1.0,
                     std::to_string(seed) + (optimal ? ", corners moved" : ", corners kept"),
                     optimal ? 0.005 : 0.006);
    }
}

}  // namespace
}  // namespace onggi::accuracy_test
