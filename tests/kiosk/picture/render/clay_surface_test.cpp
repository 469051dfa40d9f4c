#include "kiosk/picture/render/clay_surface.h"

#include <algorithm>
#include <cmath>

#include "tests/kiosk/picture/render/studio_fixture.h"
#include "tests/kiosk/picture/render/texels.h"

namespace onggi::render::testing::clay_surface_test {
namespace {

constexpr int kRows = 90, kSectors = 128;
constexpr double kHeight = 0.18, kPi = 3.14159265358979;

double bellied(double t) { return 0.05 + 0.02 * std::sin(3.0 * t); }
double bowl(double t) { return 0.03 + 0.06 * t; }
double shouldered(double t) { return 0.06 - 0.04 * t * t * t; }
double bottle(double t) { return t < 0.6 ? 0.06 : 0.06 - 0.09 * (t - 0.6); }
double plate(double t) { return 0.05 + 0.09 * t; }

ClayView clay_of(double (*outer)(double)) {
  return thrown_clay(grid_of(kRows, kSectors, kHeight, 0.01), outer, 0.005, 0.0004);
}

std::vector<float> radii(const Texture& texture, float widest) {
  std::vector<float> out = testing::shares_of(texture, true);
  for (float& r : out) r *= widest;
  return out;
}

double worst(const ClaySurface& surface, const ClayView& clay) {
  const auto outer = radii(surface.outer(), surface.widest()),
             inner = radii(surface.inner(), surface.widest());
  double most = 0;
  for (int j = 0; j < clay.rows(); ++j)
    for (int i = 0; i < clay.sectors(); ++i) {
      const auto k = static_cast<std::size_t>(j * clay.sectors() + i);
      const auto s = static_cast<std::size_t>(i);
      most = std::max({most, std::abs(double{outer[k]} - double{clay.outer(j)[s]}),
                       std::abs(double{inner[k]} - double{clay.inner(j)[s]})});
    }
  return most;
}

/// Sectors from..to - 1 of `row` outwards by `by` metres.
void swell(ClayView& clay, int row, int from, int to, float by) {
  std::vector<float> outer(clay.outer(row).begin(), clay.outer(row).end()),
      inner(clay.inner(row).begin(), clay.inner(row).end());
  for (int i = from; i < to; ++i) outer[static_cast<std::size_t>(i)] += by;
  clay.shape(row, outer, inner);
}

class TheClaysRadii : public StudioTest {
 protected:
  ClaySurface surface_;
};

TEST_F(TheClaysRadii, AreKeptWithinTwoMicrometres) {
  const ClayView clay = clay_of(bellied);
  surface_.show(clay);
  EXPECT_LT(worst(surface_, clay), 2e-6);
}

TEST_F(TheClaysRadii, GoUpOnlyWhereTheyMoved) {
  ClayView clay = clay_of(bellied);
  surface_.show(clay);
  swell(clay, 40, 10, 21, 0.001f);
  swell(clay, 41, 12, 25, 0.001f);
  swell(clay, 70, 0, 2, 0.001f);
  const std::uint64_t before = calls::so_far().bytes;
  surface_.update(clay);
  EXPECT_EQ(calls::so_far().bytes - before, 2u * (2 * 15 + 2));
  EXPECT_LT(worst(surface_, clay), 2e-6);
}

TEST_F(TheClaysRadii, ThatCreepAddUp) {
  ClayView clay = clay_of(bellied);
  surface_.show(clay);
  const std::uint64_t before = calls::so_far().bytes;
  for (int n = 0; n < 200; ++n) {
    swell(clay, 30, 0, kSectors, 2e-8f);
    surface_.update(clay);
    if (n % 20 == 0) {
      EXPECT_LT(worst(surface_, clay), 2e-6) << n;
    }
  }
  // Some three steps of every sector, and not two hundred rows.
  EXPECT_GT(calls::so_far().bytes - before, 2u * 2 * kSectors);
  EXPECT_LT(calls::so_far().bytes - before, 2u * 100 * kSectors);
}

TEST_F(TheClaysRadii, ThatOutgrowTheirStepsAreTakenAnew) {
  ClayView clay = clay_of(bellied);
  surface_.show(clay);
  swell(clay, 50, 0, kSectors, 0.06f);
  surface_.update(clay);
  EXPECT_LT(worst(surface_, clay), 4e-6);
}

TEST_F(TheClaysRadii, OfAnotherPotReplaceThem) {
  surface_.show(clay_of(bowl));
  const ClayView clay = clay_of(shouldered);
  surface_.show(clay);
  EXPECT_LT(worst(surface_, clay), 4e-6);
}

/// `rows` rows of a pot, in room for kRows.
ClayView low(int rows, bool solid) {
  ClayDef def = grid_of(rows, kSectors, kHeight * rows / kRows, 0.0);
  def.floor_thickness = solid ? def.height : 0.01;
  def.inner_radius = 0.04;
  ClayView clay;
  clay.lay(def, kRows);
  return clay;
}

// A floor to build on was seen as hollow, with a black slit, after a pot that had walls.
TEST_F(TheClaysRadii, OfASolidFloorAreNotThoseOfTheWallBefore) {
  surface_.show(low(kRows, false));
  surface_.show(low(8, true));
  Texture levels;
  surface_.refresh(levels);
  const auto inner = radii(surface_.inner(), surface_.widest());
  const auto row = static_cast<std::size_t>(surface_.first_wall_row() * kRows);
  for (std::size_t i = 0; i < kSectors; ++i) EXPECT_EQ(inner[row * kSectors + i], 0.0f);
}

// Every shape as seen from near and far, level and from above.
template <typename Check>
void from_everywhere(ClaySurface& surface, Check&& check) {
  for (double (*shape)(double) : {bellied, bowl, shouldered, bottle, plate}) {
    const ClayView clay = clay_of(shape);
    surface.show(clay);
    Texture levels;
    surface.refresh(levels);
    for (const double away : {0.35, 0.6, 1.2})
      for (const double up : {0.1, 0.2, 0.35, 0.6}) check(clay, Vec3{0, up, away});
  }
}

TEST_F(TheClaysRadii, ThatTurnTheirBackAreNotSeen) {
  int hidden = 0;
  from_everywhere(surface_, [&](const ClayView& clay, Vec3 eye) {
    const double facing = surface_.facing(eye);
    hidden += facing <= 0.6 ? 1 : 0;
    for (int j = 1; j + 1 < clay.rows(); ++j) {
      const double y = clay.row_height(j), rise = clay.row_height(j + 1) - clay.row_height(j - 1);
      for (int i = 0; i < clay.sectors(); ++i) {
        const auto s = static_cast<std::size_t>(i);
        const double angle = 2 * kPi * (i + 0.5) / clay.sectors();  // from the eye's side
        if (std::min(angle, 2 * kPi - angle) <= facing * kPi) continue;
        const double r = double{clay.outer(j)[s]};
        const double slope = (double{clay.outer(j + 1)[s]} - double{clay.outer(j - 1)[s]}) / rise;
        EXPECT_LE(eye.z * std::cos(angle) - r - slope * (eye.y - y), 0.0)
            << "row " << j << ", " << angle << " rad, eye " << eye.y << ", " << eye.z;
      }
    }
  });
  EXPECT_GT(hidden, 20) << "the half that saves the work is hardly ever drawn";
}

// A look from `eye` to a point of the inner wall meets no clay on its way.
bool sees(const ClayView& clay, Vec3 eye, Vec3 point) {
  for (int n = 1; n < 400; ++n) {
    const double s = n / 400.0;
    const Vec3 at = eye + s * (point - eye);
    if (at.y > clay.rim_height() || at.y < 0) continue;
    const int j =
        std::clamp(static_cast<int>(at.y / clay.rim_height() * clay.rows()), 0, clay.rows() - 1);
    const double rho = std::hypot(at.x, at.z);
    if (rho > clay.mean_inner(j) + 2e-4 && rho < clay.mean_outer(j) - 2e-4) return false;
  }
  return true;
}

TEST_F(TheClaysRadii, BelowWhatIsSeenIntoThePotAreNotSeen) {
  int shallow = 0;
  from_everywhere(surface_, [&](const ClayView& clay, Vec3 eye) {
    const double deep = surface_.seen_into(eye);
    shallow += deep < 1.0 ? 1 : 0;
    const double rim = clay.rim_height() - kLipRadius;
    const double lowest = rim - deep * (rim - clay.floor_top());
    for (int j = clay.floor_rows() + 1; j < clay.rows(); ++j) {
      if (clay.row_height(j) >= lowest) break;
      for (int i = 0; i < 48; ++i) {
        const double angle = 2 * kPi * i / 48, r = clay.mean_inner(j) - 1e-4;
        EXPECT_FALSE(
            sees(clay, eye, {r * std::sin(angle), clay.row_height(j), r * std::cos(angle)}))
            << "row " << j << ", " << angle << " rad, eye " << eye.y << ", " << eye.z;
      }
    }
  });
  EXPECT_GT(shallow, 15) << "the depth that saves the work is hardly ever less than all";
}

}  // namespace
}  // namespace onggi::render::testing::clay_surface_test
