#include "kiosk/collection/decoration/figure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::decoration::figure_test {
namespace {

using surface::kSectors;
using surface::Surface;

Surface cylinder() {
  Profile profile;
  for (int n = 0; n <= 10; ++n) profile.points.push_back({0.016 * n, 0.06, n < 1 ? 0.0 : 0.05});
  return *Surface::create(profile, "cylinder");
}

const Motif& square() {
  static const Motif kSquare{{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}, {}};
  return kSquare;
}

/// Cells that are deeper than 0.3 mm, as an area, mm^2.
double carved(const Surface& surface) {
  double area = 0.0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      if (surface.relief(j, i) < -300) area += 1e-6 * surface.row(j).area;
  return area;
}

double carve(int section) {
  Surface surface = cylinder();
  surface::CutDef cut;
  cut.section = section, cut.width = 0.001, cut.depth = 6e-4, cut.burr = 0.0;
  const FigurePlace at = figure_place(surface, 0.08, 0.25, 0.02, false);
  for (const surface::Stroke& stroke : figure_strokes(surface, square(), at, cut, {}))
    EXPECT_TRUE(apply(surface, stroke));
  return carved(surface);
}

TEST(Figure, AFlatCutTakesTheWholeAreaAndAPointedOneItsOutline) {
  EXPECT_NEAR(carve(surface::CutDef::flat), 21.0 * 21.0, 25.0);
  EXPECT_LT(carve(surface::CutDef::v), 4 * 20.0);
}

TEST(Figure, APaintedAreaIsAsLargeAsTheFigure) {
  Surface surface = cylinder();
  const FigurePlace at = figure_place(surface, 0.08, 0.25, 0.02, false);
  double area = 0.0;
  for (const surface::Stroke& stroke :
       figure_strokes(surface, square(), at, surface::BrushDef{}, surface::FillDef{}))
    ASSERT_TRUE(apply(surface, stroke));
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      if (surface.slip(j, i).word() != 0) area += 1e-6 * surface.row(j).area;
  EXPECT_NEAR(area, 400.0, 12.0);
}

TEST(Figure, ItsRightIsRightAsSeenFromWhereItIsLookedAt) {
  const Surface surface = cylinder();
  // Angles grow to the left as seen from outside, and to the right as seen from within.
  EXPECT_LT(figure_place(surface, 0.08, 0.25, 0.02, false).round, 0.0);
  const double inside = 1e-6 * surface.rows() * surface::kRowHeight - 0.1;
  EXPECT_GT(figure_place(surface, inside, 0.25, 0.02, true).round, 0.0);
  EXPECT_LT(figure_place(surface, inside, 0.25, 0.02, true).up, 0.0);
}

TEST(Figure, AStampsPictureIsItsAreas) {
  // A square ring as one area with a slit: the middle stays.
  const Motif ring{{{{-0.5, -0.5},
                     {0.5, -0.5},
                     {0.5, 0.5},
                     {-0.5, 0.5},
                     {-0.5, -0.5},
                     {-0.25, -0.25},
                     {-0.25, 0.25},
                     {0.25, 0.25},
                     {0.25, -0.25},
                     {-0.25, -0.25}}},
                   {}};
  const auto picture = stamp_picture(ring, 8);
  ASSERT_EQ(picture.size(), 64u);
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t x = 0; x < 8; ++x)
      EXPECT_EQ(picture[y * 8 + x], x >= 2 && x < 6 && y >= 2 && y < 6 ? 0 : 255) << x << ' ' << y;
}

}  // namespace
}  // namespace onggi::decoration::figure_test
