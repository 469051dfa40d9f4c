#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/contact/paper_model.h"
#include "tests/engine/contact/papers_pot.h"
#include "tests/support/sphere.h"

// What goes wrong where the paper leaves a question open, each with the corrected model's answer
// beside it. Numbers are those of the table in engine/docs/paper.md.
namespace onggi::paper_gaps_test {
namespace {

using namespace papers_pot;

constexpr Yielding kClay{kTau, 5e6};
constexpr PaperCoefficients kPrinted{10.0, 0.864, 0.0};
constexpr double kMiddle = 0.036 + 0.00009;  // a row's height, half way up the paper's pot
constexpr double kSector = 3.14159265 / 180.0;

PaperTouch printed(Clay& clay, WallSide mode, Vec3 at) {
  return PaperModel(clay).tick(clay, mode, at, kRadius, 0.0, 0.0, kPrinted);
}
Press corrected(Clay& clay, WallSide side, Vec3 at) {
  return press_sphere(clay, side, at, kRadius, 0.001, kClay);
}

TEST(Paper08, ATouchAtTheSideCutsFarMoreThanIsFelt) {
  // A quarter of the pot stands 20 mm proud, and the tool's side touches its end by 0.2 mm. An
  // element has no tangential freedom: it gives way along its radius, here by 9 mm.
  constexpr int kFirst = 100;
  const auto stepped = [] {
    Clay clay = made(sheet(0.035));
    for (int j = 0; j < clay.rows(); ++j)
      for (std::size_t i = kFirst; i < kFirst + 90; ++i) clay.outer_mut(j)[i] = 0.055f;
    return clay;
  };
  const double angle = (kFirst + 0.5) * kSector - std::asin((kRadius - 0.0002) / 0.048);
  const Vec3 beside{0.048 * std::cos(angle), kMiddle, 0.048 * std::sin(angle)};
  const Vec3 before{0.056 * std::cos(2.5), kMiddle, 0.056 * std::sin(2.5)};

  // What the clay gives way by, over what is felt: both in metres of press, all elements together.
  const auto printed_ratio = [&](Clay clay, Vec3 at) {
    const Clay was = clay;
    const PaperTouch touch = printed(clay, WallSide::outside, at);
    double given = 0.0;
    for (int j = 0; j < clay.rows(); ++j)
      for (std::size_t i = 0; i < 360; ++i)
        given += kPrinted.c_eta * (double{was.outer(j)[i]} - double{clay.outer(j)[i]});
    return given / touch.depth_sum;
  };
  EXPECT_NEAR(printed_ratio(made(sheet()), before), 1.0, 1e-3);  // eqs. 5 and 9 agree
  EXPECT_GT(printed_ratio(stepped(), beside), 30.0);

  // The same of the corrected model, each element weighed by its area as its force is.
  const auto corrected_ratio = [&](Clay clay, Vec3 at) {
    const Clay was = clay;
    const Press felt = corrected(clay, WallSide::outside, at);
    double given = 0.0;
    for (int j = 0; j < clay.rows(); ++j) {
      for (std::size_t i = 0; i < 360; ++i) {
        const double radius = double{was.outer(j)[i]};
        const double area = radius * kSector * clay.row_thickness(j);
        given += area * (radius - double{clay.outer(j)[i]}) * kTau / 0.001;
      }
    }
    return given * kClay.stiffness / felt.normal;
  };
  EXPECT_NEAR(corrected_ratio(made(sheet()), before), 1.0, 0.01);
  EXPECT_NEAR(corrected_ratio(stepped(), beside), 1.0, 0.01);
}

TEST(Paper20, ClayVanishesUnderTheTool) {
  // A pot whose wall is as thin as it may be. Its volume as a sheet is all that the paper knows.
  ClayDef thin = sheet();
  thin.wall_min = 0.004;
  thin.inner_radius = 0.0459;
  const auto lost = [&](bool as_printed) {
    Clay clay = made(as_printed ? sheet() : thin);
    const double whole = clay.volume();
    const Vec3 at{0.05 + kRadius - 0.003, kMiddle, 0.0};
    for (int n = 0; n < 200; ++n) {
      if (as_printed)
        printed(clay, WallSide::outside, at);
      else
        corrected(clay, WallSide::outside, at);
    }
    // Nothing comes out elsewhere.
    for (int j = 0; j < clay.rows(); ++j)
      EXPECT_LE(*std::ranges::max_element(clay.outer(j)), 0.05f);
    return whole - clay.volume();
  };
  // With two faces the wall bends in. Clay squeezed out of a thick wall vanishes here too.
  EXPECT_GT(lost(true), 1e-7);  // a tenth of a millilitre and more in one touch
  EXPECT_LT(lost(false), 0.2 * lost(true));
}

}  // namespace
}  // namespace onggi::paper_gaps_test
