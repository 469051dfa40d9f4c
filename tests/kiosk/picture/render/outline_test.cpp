#include "kiosk/picture/render/outline.h"

#include <algorithm>
#include <cmath>

#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::outline_test {
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
  const double quarter = 0.5 * 3.14159265358979;
  const WallMesh wall{60, 96, 96, static_cast<float>(quarter - shown.frame.pot->camera.azimuth),
                      static_cast<float>(quarter * (4.0 - cut_away))};
  shown.ribbons = outline_of(clay, CoatTexture{}, wall, *shown.frame.pot, projection * view, 3.0f);
  return shown;
}

/// A piece of an edge, from the lower left, and the way out of the clay.
struct Piece {
  glm::vec2 from, to, out;
};
std::vector<Piece> pieces(const Ribbons& ribbons) {
  std::vector<Piece> all;
  const auto& c = ribbons.corners;
  const auto on_edge = [](const EdgeCorner& out, const EdgeCorner& in) {
    return glm::mix(out.at, in.at, out.beyond / (out.beyond - in.beyond));
  };
  for (std::size_t i = 0; i + 3 < c.size(); i += 4)
    all.push_back({on_edge(c[i], c[i + 1]), on_edge(c[i + 2], c[i + 3]), c[i].at - c[i + 1].at});
  return all;
}
double apart(const Piece& piece, std::pair<float, float> pixel) {
  const glm::vec2 at(pixel.first, 600.0f - pixel.second), way = piece.to - piece.from;
  const float t = glm::dot(at - piece.from, way) / std::max(glm::dot(way, way), 1e-6f);
  return static_cast<double>(
      glm::length(at - glm::mix(piece.from, piece.to, std::clamp(t, 0.0f, 1.0f))));
}
/// The least distance of an edge from a pixel (from the top left).
double apart(const Outlined& shown, std::pair<float, float> pixel) {
  double least = 1e9;
  for (const Piece& piece : pieces(shown.ribbons)) least = std::min(least, apart(piece, pixel));
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
    Piece nearest{};
    double least = 1e9;
    for (const Piece& piece : pieces(shown.ribbons))
      if (apart(piece, pixel) < least) least = apart(piece, pixel), nearest = piece;
    ASSERT_LT(least, 3.0);
    EXPECT_GT(static_cast<float>(-sign) * nearest.out.x, 1.0f)
        << "the angle grows to the visitor's left";
  }
}

}  // namespace
}  // namespace onggi::render::testing::outline_test
