#include "kiosk/picture/render/outline.h"

#include <algorithm>
#include <cmath>

#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing {
namespace {

using AnOutline = StudioTest;

constexpr double kOutlined = 0.05, kOutlinedHigh = 0.15;

struct Outlined {
  view::Frame frame;
  Ribbons ribbons;
};

Outlined outlined(double cut_away) {
  ClaySurface clay;
  clay.show(thrown_clay(
      grid_of(150, 120, kOutlinedHigh, 0.01), [](double) { return kOutlined; }, 0.006, 0.0));
  Texture levels;
  clay.refresh(levels);
  Outlined shown{frame_with_pot(800, 600, kOutlinedHigh, kOutlined), {}};
  shown.frame.pot->wheel = false;
  shown.frame.pot->cut_away = cut_away;
  glm::mat4 view, projection;
  shown.frame.pot->camera.matrices(&view[0][0], &projection[0][0]);
  shown.ribbons = outline_of(clay, *shown.frame.pot, projection * view, 3.0f);
  return shown;
}

/// The least distance of a ribbon's edge from a pixel (from the top left).
double apart(const Outlined& shown, std::pair<float, float> pixel) {
  const auto& corners = shown.ribbons.corners;
  double least = 1e9;
  for (const EdgeCorner& c : corners) {
    // Of a corner beside its edge, the foot on it.
    const glm::vec2 normal(c.normal[0] / 127.0f, c.normal[1] / 127.0f);
    const glm::vec2 on = c.at - c.beyond * normal;
    least = std::min(least, static_cast<double>(
                                glm::length(on - glm::vec2(pixel.first, 600.0f - pixel.second))));
  }
  return least;
}

std::pair<float, float> pixel_of(const Outlined& shown, double turned, double rho, double y) {
  const double a = 0.5 * 3.14159265358979 - shown.frame.pot->camera.azimuth + turned;
  return *shown.frame.pot->camera.project({rho * std::cos(a), y, rho * std::sin(a)});
}

// A cylinder turns away from the eye where the ray touches it.
TEST_F(AnOutline, RunsUpBothSidesOfTheWallRoundTheRimAndAlongTheFoot) {
  const Outlined shown = outlined(0.0);
  const Vec3 eye = shown.frame.pot->camera.eye();
  const double side = std::acos(kOutlined / std::hypot(eye.x, eye.z));
  for (const double y : {0.03, 0.07, 0.12})
    for (const double sign : {-1.0, 1.0})
      EXPECT_LT(apart(shown, pixel_of(shown, sign * side, kOutlined, y)), 3.0) << y << " " << sign;
  for (const double turned : {-1.0, 0.0, 1.0})
    EXPECT_LT(apart(shown, pixel_of(shown, turned, kOutlined, 0.0)), 6.0) << turned;
  for (const double turned : {-1.0, 0.0, 1.0, 2.0, 3.0}) {
    EXPECT_LT(apart(shown, pixel_of(shown, turned, kOutlined - 0.001, kOutlinedHigh)), 8.0)
        << turned;
    EXPECT_LT(apart(shown, pixel_of(shown, turned, kOutlined - 0.005, kOutlinedHigh)), 8.0)
        << turned;
  }
  EXPECT_GT(apart(shown, pixel_of(shown, 0.0, kOutlined, 0.07)), 40.0) << "no edge on the wall";
}

TEST_F(AnOutline, EndsTheWallWhereItIsCutAway) {
  const Outlined shown = outlined(1.0);
  for (const double y : {0.03, 0.07, 0.12}) {
    EXPECT_LT(apart(shown, pixel_of(shown, 0.0, kOutlined, y)), 3.0) << y;
    EXPECT_GT(apart(shown, pixel_of(shown, -0.8, kOutlined, y)), 10.0) << y << ": it is open there";
  }
}

// What is in front of an edge lies on the other side of it than its normal points to.
TEST_F(AnOutline, PointsAwayFromTheClay) {
  const Outlined shown = outlined(0.0);
  const Vec3 eye = shown.frame.pot->camera.eye();
  const double side = std::acos(kOutlined / std::hypot(eye.x, eye.z));
  for (const double sign : {-1.0, 1.0}) {
    const auto pixel = pixel_of(shown, sign * side, kOutlined, 0.07);
    const EdgeCorner* nearest = nullptr;
    double least = 1e9;
    for (const EdgeCorner& c : shown.ribbons.corners) {
      const double away =
          static_cast<double>(glm::length(c.at - glm::vec2(pixel.first, 600.0f - pixel.second)));
      if (away < least) least = away, nearest = &c;
    }
    ASSERT_NE(nearest, nullptr);
    EXPECT_GT(-sign * nearest->normal[0], 120) << "the angle grows to the visitor's left";
  }
}

}  // namespace
}  // namespace onggi::render::testing
