#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/engine/contact/bodies/checks.h"

namespace onggi::every_body_test {
namespace {

using namespace body_checks;

double from_ball(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  return length(p - place.at) - size.radius;
}

// From the nearest point of the middle line.
double from_capsule(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double on = std::clamp(dot(q, place.along), 0.0, size.length);
  return length(q - on * place.along) - size.radius;
}

// What the point is beyond each pair of faces.
double from_box(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double x = std::fabs(dot(q, place.along)) - 0.5 * size.length;
  const double y = std::fabs(dot(q, place.across)) - 0.5 * size.thickness;
  const double z = std::fabs(dot(q, cross(place.along, place.across))) - size.radius;
  const Vec3 out{std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0)};
  return length(out) + std::min(std::max({x, y, z}), 0.0);
}

// Beyond its faces, and beyond its round edge.
double from_cylinder(Vec3 p, const ToolPlace& place, const ToolSize& size) {
  const Vec3 q = p - place.at;
  const double through = dot(q, place.across);
  const double x = std::fabs(through) - 0.5 * size.thickness;
  const double y = length(q - through * place.across) - size.radius;
  return length(Vec2{std::max(x, 0.0), std::max(y, 0.0)}) + std::min(std::max(x, y), 0.0);
}

struct ToolCase {
  const char* tool;
  Distance distance;
  double grid_share;  // that grids may differ by; 0: it is finer than their elements
  double even_share;  // that it may feel more on one place of the grid than on another
};

class EveryBody : public testing::TestWithParam<ToolCase> {};

TEST_P(EveryBody, PressesAsARayMarchThroughItSays) {
  agrees_with_a_ray_march(GetParam().tool, GetParam().distance);
}
TEST_P(EveryBody, GivesTheSameBitsOnAllVectors) { same_bits_on_all_vectors(GetParam().tool); }
TEST_P(EveryBody, HeldAsUsualLeavesASymmetricMark) {
  symmetric_pose_leaves_symmetric_mark(GetParam().tool);
}
TEST_P(EveryBody, StaysFiniteAndWithinTheClaysLimitsInAnyPose) {
  random_poses_stay_within_limits(GetParam().tool);
}
TEST_P(EveryBody, ItsSupportPointIsItsFarthest) {
  ball_reaches_as_far_as_the_body(GetParam().tool, GetParam().distance);
}
TEST_P(EveryBody, LooksWhereItTouches) {
  if (!(GetParam().grid_share > 0.0)) GTEST_SKIP() << "finer than the elements it looks at";
  looks_where_it_touches(GetParam().tool);
}
TEST_P(EveryBody, FeelsTheSameOnAnyGrid) {
  if (!(GetParam().grid_share > 0.0)) GTEST_SKIP() << "finer than these grids' elements";
  force_does_not_depend_on_the_grid(GetParam().tool, GetParam().grid_share);
}

TEST_P(EveryBody, FeelsTheSameWhereverElementsLieUnderIt) {
  force_is_even(GetParam().tool, GetParam().even_share);
}

INSTANTIATE_TEST_SUITE_P(Tools, EveryBody,
                         testing::Values(ToolCase{"sphere", from_ball, 0.03, 0.05},
                                         ToolCase{"sponge", from_ball, 0.03, 0.05},
                                         ToolCase{"fingertip", from_capsule, 0.03, 0.001},
                                         ToolCase{"needle", from_capsule, 0.0, 0.03},
                                         ToolCase{"flat_rib", from_box, 0.03, 0.001},
                                         ToolCase{"curved_rib", from_cylinder, 0.05, 0.001},
                                         ToolCase{"loop_trimmer", from_cylinder, 0.05, 0.001}),
                         [](const auto& each) { return std::string(each.param.tool); });

}  // namespace
}  // namespace onggi::every_body_test
