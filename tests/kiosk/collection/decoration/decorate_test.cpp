#include "kiosk/collection/decoration/decorate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "engine/surface/laws.h"

namespace onggi::decoration::decorate_test {
namespace {

using namespace surface;

/// A jar of 300 mm: half as tall again as the wheel allows.
Profile tall() {
  return {{{0.0, 0.080, 0.0}, {0.010, 0.085, 0.076}, {0.150, 0.120, 0.112}, {0.300, 0.070, 0.064}}};
}

Surface done(const Decoration& decoration) {
  Result<Surface> surface = decorated(tall(), decoration, "jar");
  EXPECT_TRUE(surface) << (surface ? "" : to_text(surface.error()));
  return std::move(*surface);
}

Decoration of(Step step) {
  Decoration decoration;
  decoration.pigments = {{"blue", {0.0f, 0.0f, 1.0f}, 5e-5}, {"red", {1.0f, 0.0f, 0.0f}, 5e-5}};
  decoration.steps = {std::move(step)};
  return decoration;
}

/// Cells of a row that have slip.
int coated(const Surface& surface, int j) {
  int cells = 0;
  for (int i = 0; i < kSectors; ++i) cells += surface.slip(j, i).at(0).code > 0;
  return cells;
}

TEST(Decorate, ACoatCoversItsShareOfASideAndNothingElse) {
  Step step;
  step.from = 0.25, step.to = 0.5;
  const Surface outside = done(of(step));
  const int lip = lip_of(outside) / kRowHeight;
  for (int j = 0; j < outside.rows(); ++j) {
    const double share = (j + 0.5) / lip;
    if (share < 0.249 || share > 0.501) {
      EXPECT_EQ(coated(outside, j), 0) << share;
    } else if (share > 0.251 && share < 0.499) {
      EXPECT_EQ(coated(outside, j), kSectors) << share;
    }
  }
  step.inside = true, step.from = 0.9, step.to = 1.0;
  const Surface inside = done(of(step));
  const int rows = inside.rows() - lip;
  EXPECT_EQ(coated(inside, lip - 2), 0);
  EXPECT_EQ(coated(inside, lip + 2), kSectors);
  EXPECT_EQ(coated(inside, lip + rows / 10 - 3), kSectors);
  EXPECT_EQ(coated(inside, lip + rows / 10 + 3), 0);
}

TEST(Decorate, WidthsScaleWithThePotAndCoatsDoNot) {
  EXPECT_DOUBLE_EQ(wheel_scale(tall()), 2.0 / 3.0);
  Step step;
  step.kind = Step::band, step.width = 0.012, step.thickness = 2e-4;
  const Surface surface = done(of(step));
  int rows = 0;
  for (int j = 0; j < surface.rows(); ++j) rows += coated(surface, j) == kSectors;
  EXPECT_NEAR(rows * kRowHeight * 1e-6, 0.008, 0.0006);
  const int middle = lip_of(surface) / 2 / kRowHeight;
  EXPECT_NEAR(surface.slip(middle, 0).thickness() * 1e-9, 2e-4, 3e-5);
}

/// A flag: its area lies to the right of its middle, and above it.
Motif flag() {
  Motif motif;
  motif.fills = {{{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}};
  return motif;
}

// Angles grow to the left as seen from outside, and to the right as seen from the axis.
TEST(Decorate, AFigureStandsUprightAndIsNoMirrorImageOnEitherSide) {
  for (const bool inside : {false, true}) {
    Step step;
    step.kind = Step::paint, step.motif = flag(), step.size = 0.03, step.inside = inside;
    step.turn = 0.25;
    const Surface surface = done(of(step));
    double low = 1e9, high = 0.0, right = 0.0, left = 0.0;
    for (int j = 0; j < surface.rows(); ++j)
      for (int i = 0; i < kSectors; ++i)
        if (surface.slip(j, i).at(0).code > 0) {
          low = std::min(low, surface.row(j).height), high = std::max(high, surface.row(j).height);
          (i < kSectors / 4 ? right : left) += 1.0;
        }
    EXPECT_EQ(inside ? right : left, 0.0) << inside;
    EXPECT_GT(inside ? left : right, 1000.0) << inside;
    const int lip = lip_of(surface), end = surface.rows() * kRowHeight;
    const double middle = surface.row((inside ? (lip + end) / 2 : lip / 2) / kRowHeight).height;
    EXPECT_NEAR(low, middle, 0.0005) << inside;
    EXPECT_NEAR(high, middle + 0.010, 0.001) << inside;
  }
}

TEST(Decorate, AMotifStandsAsOftenAsItIsRepeated) {
  Step step;
  step.kind = Step::paint, step.motif = flag(), step.size = 0.03;
  step.repeat = 7;
  const Surface surface = done(of(step));
  const int j = lip_of(surface) / 2 / kRowHeight + 10;
  int begins = 0;
  for (int i = 0; i < kSectors; ++i)
    begins += surface.slip(j, i).at(0).code > 0 && surface.slip(j, wrapped(i - 1)).at(0).code == 0;
  EXPECT_EQ(begins, 7);
}

/// The outermost and the innermost clay of a row, um over the reference body.
std::pair<int, int> relief_of_row(const Surface& surface, int j) {
  int high = surface.relief(j, 0), low = high;
  for (int i = 1; i < kSectors; ++i) {
    high = std::max(high, surface.relief(j, i));
    low = std::min(low, surface.relief(j, i));
  }
  return {high, low};
}

TEST(Decorate, ABladeTakesTheSlipInItsRingAway) {
  Decoration decoration = of({});
  Step blade;
  blade.kind = Step::scrape, blade.width = 0.015;
  decoration.steps.push_back(blade);
  const Surface surface = done(decoration);
  const int middle = lip_of(surface) / 2 / kRowHeight;
  EXPECT_EQ(coated(surface, middle), 0);
  EXPECT_EQ(coated(surface, middle + 18), 0);  // 4.5 mm of the 5 to each side, on the wheel
  EXPECT_EQ(coated(surface, middle + 24), kSectors);
}

TEST(Decorate, AStampPressesTheAreaOfItsMotif) {
  Step stamp;
  stamp.kind = Step::stamp, stamp.motif = flag(), stamp.size = 0.03, stamp.depth = 0.0009;
  stamp.repeat = 5;
  const Surface surface = done(of(stamp));
  const int middle = lip_of(surface) / 2 / kRowHeight;
  EXPECT_NEAR(relief_of_row(surface, middle + 20).second, -600, 40);
  EXPECT_EQ(relief_of_row(surface, middle - 20).second, 0);
  int pressed = 0;
  for (int i = 0; i < kSectors; ++i)
    pressed += surface.relief(middle + 20, i) < -300 &&
               surface.relief(middle + 20, wrapped(i - 1)) >= -300;
  EXPECT_EQ(pressed, 5);
}

TEST(Decorate, ACoilStandsAtItsHeight) {
  Step coil;
  coil.kind = Step::coil, coil.width = 0.009, coil.height = 0.003;
  const Surface surface = done(of(coil));
  const int middle = lip_of(surface) / 2 / kRowHeight;
  EXPECT_NEAR(relief_of_row(surface, middle).first, 2000, 100);
  EXPECT_EQ(relief_of_row(surface, middle + 20).first, 0);
}

TEST(Decorate, AStoneRubsARingWhereItHasAHeightAndElseItsZone) {
  Step stone;
  stone.kind = Step::burnish, stone.width = 0.009;
  const Surface ring = done(of(stone));
  const int middle = lip_of(ring) / 2 / kRowHeight;
  EXPECT_GT(ring.burnish(middle, 0), 0);
  EXPECT_EQ(ring.burnish(middle + 20, 0), 0);
  stone.zone = true;
  EXPECT_GT(done(of(stone)).burnish(middle + 20, 0), 0);
}

TEST(Decorate, ABrushWithALoadRunsDry) {
  Step line;
  line.kind = Step::paint, line.width = 0.006, line.thickness = 2e-4, line.size = 0.3;
  line.motif.lines = {{{-0.5, 0.0}, {0.5, 0.0}}};
  const auto slip = [](const Surface& surface) {
    std::int64_t all = 0;
    for (int j = 0; j < surface.rows(); ++j)
      for (int i = 0; i < kSectors; ++i) all += surface.slip(j, i).thickness();
    return static_cast<double>(all);
  };
  const double full = slip(done(of(line)));
  line.load = 0.15;
  EXPECT_LT(slip(done(of(line))), 0.7 * full);
}

TEST(Decorate, AStepThatCannotBeDoneIsNamed) {
  Step step;
  step.kind = Step::paint, step.motif = flag(), step.repeat = 9;
  const auto surface = decorated(tall(), of(step), "jar/decoration.toml");
  ASSERT_FALSE(surface);
  EXPECT_EQ(to_text(surface.error()),
            "jar/decoration.toml, step 1, repeat: repeat is 9, which does not divide the pot "
            "evenly.\n  Choose 2 to 8, 10, 12, 14, 15 or 16.");
}

}  // namespace
}  // namespace onggi::decoration::decorate_test
