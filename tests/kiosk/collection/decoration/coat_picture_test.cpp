#include "kiosk/collection/decoration/coat_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/surface/laws.h"

namespace onggi::decoration::coat_picture_test {
namespace {

using surface::kSectors;
using surface::Surface;

Profile jar() {
  Profile profile;
  for (int n = 0; n <= 40; ++n) {
    const double y = 0.16 * n / 40;
    const double outer = 0.05 + 0.02 * std::sin(3.0 * n / 40.0);
    profile.points.push_back({y, outer, n < 2 ? 0.0 : outer - 0.006});
  }
  return profile;
}

Palette two_slips() {
  Palette palette;
  palette.pigments = {{{0.9f, 0.8f, 0.7f}, {0.8f, 0.8f, 0.8f}, 2e-5},
                      {{0.4f, 0.1f, 0.1f}, {0.02f, 0.02f, 0.02f}, 2e-5}};
  return palette;
}

/// Once round at a height along the outline, m.
surface::Stroke ring(const Surface& surface, surface::Tool tool, double along) {
  surface::Tracer tracer(surface, 100.0);
  tracer.go({along, 0.0});
  tracer.go({along, 1.0});
  tracer.lift();
  return {std::move(tool), tracer.stations(), false};
}

surface::Stroke band_stroke(const Surface& surface, int pigment, double along) {
  surface::BrushDef brush;
  brush.pigment = pigment;
  brush.reach = 100.0;
  return ring(surface, brush, along);
}

struct Pot {
  Surface surface = *Surface::create(jar(), "jar");
  CoatPicture picture{surface, two_slips()};

  std::size_t texel(double along, int sector = 0) const {
    return static_cast<std::size_t>(std::lround(along * 4000)) * kSectors +
           static_cast<std::size_t>(sector);
  }
  void draw() {
    picture.touch_all();
    picture.draw(surface, 1 << 20);
  }
};

TEST(CoatPicture, ABarePotHasNoPaintAndIsLevel) {
  Pot pot;
  const auto born = pot.picture.form();
  pot.draw();
  EXPECT_EQ(born, pot.picture.form());
  for (const CoatPicture::Texel& texel : pot.picture.paint()) ASSERT_EQ(texel[3], 0);
  for (const CoatPicture::Texel& texel : pot.picture.form())
    ASSERT_EQ(texel, (CoatPicture::Texel{128, 128, 0, 0}));
  EXPECT_FALSE(pot.picture.glazed());
}

TEST(CoatPicture, ABandOfSlipHidesTheClayThereAndNowhereElse) {
  Pot pot;
  ASSERT_TRUE(apply(pot.surface, band_stroke(pot.surface, 0, 0.08)));
  pot.draw();
  const auto middle = pot.picture.paint()[pot.texel(0.08)];
  EXPECT_GT(middle[3], 250);
  EXPECT_NEAR(middle[0], 255 * std::sqrt(0.9), 2);
  EXPECT_NEAR(middle[2], 255 * std::sqrt(0.7), 2);
  EXPECT_EQ(pot.picture.paint()[pot.texel(0.05)][3], 0);
  EXPECT_EQ(pot.picture.paint()[pot.texel(0.11)][3], 0);
}

TEST(CoatPicture, AThinCoatLetsTheClayThroughByItsThickness) {
  Pot pot;
  surface::DipDef dip;
  dip.coat = 0, dip.from = 0.02, dip.to = 0.1, dip.seconds = 1.0, dip.rate = 2e-5, dip.drinks = 1.0;
  ASSERT_TRUE(apply(pot.surface, {dip, {}, false}));
  pot.draw();
  // One coat of `hides`, but for a code's rounding.
  const int code = pot.surface.slip(240, 0).at(0).code;
  const double coat = 1e-9 * surface::thickness_of(code);
  EXPECT_NEAR(pot.picture.paint()[pot.texel(0.06)][3], 255 * (1 - std::exp(-coat / 2e-5)), 1);
}

TEST(CoatPicture, TheFireTurnsARedSlipBlack) {
  Pot pot;
  ASSERT_TRUE(apply(pot.surface, band_stroke(pot.surface, 1, 0.08)));
  pot.draw();
  const auto raw = pot.picture.paint()[pot.texel(0.08)];
  pot.picture.fire(true);
  pot.picture.draw(pot.surface, 1 << 20);
  const auto fired = pot.picture.paint()[pot.texel(0.08)];
  EXPECT_GT(raw[0], raw[1] + 60);
  EXPECT_EQ(fired[0], fired[1]);
  EXPECT_LT(fired[0], 45);
}

TEST(CoatPicture, TheFloorsMiddleIsTheMeanOfTheRingRoundIt) {
  Pot pot;
  const int last = pot.surface.rows() - 1;
  ASSERT_LT(pot.surface.row(last).radius, 0.0065);
  // Half of the floor is white: a fan of both colours is no floor.
  for (int j = last - 40; j <= last; ++j)
    for (int i = 0; i < kSectors / 2; ++i) {
      surface::Strata slip;
      slip.set(0, {surface::code_within(300'000), 0});
      pot.surface.set_slip(j, i, slip);
    }
  pot.draw();
  const auto& paint = pot.picture.paint();
  const auto at = [&](int j, int i) { return static_cast<std::size_t>(j) * kSectors + i; };
  EXPECT_GT(paint[at(last - 1, 7)][3], 250);
  EXPECT_EQ(paint[at(last - 1, kSectors - 7)][3], 0);
  for (int i = 0; i < kSectors; ++i) ASSERT_EQ(paint[at(last, i)], paint[at(last, 0)]) << i;
  EXPECT_NEAR(paint[at(last, 0)][3], 127, 2);
  EXPECT_EQ(paint[at(last, 0)][0], paint[at(last - 1, 7)][0]);
}

TEST(CoatPicture, MoltenGlazeIsThickWhereAnOpenCutWas) {
  Pot pot;
  surface::CutDef cut;
  cut.width = 0.001, cut.depth = 0.0006, cut.burr = 0.0;
  ASSERT_TRUE(apply(pot.surface, ring(pot.surface, cut, 0.08)));
  auto melt = surface::Melt::begin(pot.surface, {.even = 4e-4});
  ASSERT_TRUE(melt);
  while (!melt->go_on(1 << 20)) {
  }
  pot.draw();
  EXPECT_FALSE(pot.picture.melted());
  const std::uint64_t change = pot.picture.change();
  pot.picture.fire(true, &*melt);
  pot.picture.draw(pot.surface, 1 << 20);
  EXPECT_TRUE(pot.picture.melted());
  EXPECT_TRUE(pot.picture.glazed());
  EXPECT_NE(pot.picture.change(), change);
  const auto &in_cut = pot.picture.form()[pot.texel(0.08)],
             &beside = pot.picture.form()[pot.texel(0.05)];
  EXPECT_GT(in_cut[3], beside[3] + 40);
  EXPECT_NEAR(beside[3], 100, 4);
  EXPECT_EQ(in_cut[2], 0);
  pot.picture.fire(false);
  pot.picture.draw(pot.surface, 1 << 20);
  EXPECT_FALSE(pot.picture.melted());
  EXPECT_FALSE(pot.picture.glazed());
  EXPECT_GT(pot.picture.form()[pot.texel(0.08)][2], 50);
}

TEST(CoatPicture, ACutIsDeepAndItsFacesSlope) {
  Pot pot;
  surface::CutDef cut;
  cut.width = 0.004, cut.depth = 0.001;
  ASSERT_TRUE(apply(pot.surface, ring(pot.surface, cut, 0.08)));
  pot.draw();
  const auto& form = pot.picture.form();
  EXPECT_NEAR(form[pot.texel(0.08)][2], 250, 45);
  // A V that is 4 mm wide and 1 mm deep falls by a half, then rises.
  EXPECT_NEAR(form[pot.texel(0.079)][0], 128 - 32, 8);
  EXPECT_NEAR(form[pot.texel(0.081)][0], 128 + 32, 8);
  EXPECT_EQ(form[pot.texel(0.08)][1], 128);
}

// What rounds a coat's thickness to its codes would glitter under the glaze.
TEST(CoatPicture, ACoilStandsOutAndACutAndTheLipDoNot) {
  Pot pot;
  const auto most = [&](double along) {
    const auto row = static_cast<std::size_t>(std::lround(along * 4000)) / CoatPicture::kBeadRows;
    constexpr std::size_t kAcross = kSectors / CoatPicture::kBeadColumns;
    const auto from = pot.picture.beads().begin() + static_cast<std::ptrdiff_t>(row * kAcross);
    return CoatPicture::kBeadUnit * *std::max_element(from, from + kAcross);
  };
  ASSERT_TRUE(surface::apply(pot.surface, ring(pot.surface, surface::CutDef{}, 0.1)));
  pot.draw();
  EXPECT_EQ(std::ranges::count(pot.picture.beads(), 0), std::ssize(pot.picture.beads()));
  const double lip = pot.picture.lip_from() * static_cast<float>(pot.picture.height()) / 4000;
  for (const double along : {0.06, lip})
    ASSERT_TRUE(surface::apply(
        pot.surface, ring(pot.surface, surface::CoilDef{.width = 0.01, .height = 0.003}, along)));
  pot.draw();
  EXPECT_GT(most(0.06), 2700);
  EXPECT_LE(most(0.06), 3000);
  EXPECT_EQ(most(0.07), 0);
  EXPECT_EQ(most(lip), 0);
  EXPECT_GT(most(lip - 0.003), 0);
}

TEST(CoatPicture, ACoatLaidThriceIsSmooth) {
  Pot pot;
  surface::BrushDef flood;
  flood.width = 0.03, flood.tracks = 1, flood.reach = 100.0;
  for (int n = 0; n < 3; ++n) ASSERT_TRUE(apply(pot.surface, ring(pot.surface, flood, 0.08)));
  pot.draw();
  double sum = 0.0;
  for (int sector = 0; sector < kSectors; ++sector) {
    const CoatPicture::Texel& texel = pot.picture.form()[pot.texel(0.08, sector)];
    for (const std::size_t k : {0u, 1u}) sum += (texel[k] - 128.0) * (texel[k] - 128.0);
  }
  EXPECT_LT(std::sqrt(sum / kSectors), 3.0);
  EXPECT_GT(pot.picture.paint()[pot.texel(0.08)][3], 250);
}

TEST(CoatPicture, RawGlazeIsOpaqueAndAfterTheFireItIsOnlyTold) {
  Pot pot;
  surface::DipDef dip;
  dip.from = 0.02, dip.to = 0.1;
  ASSERT_TRUE(apply(pot.surface, {dip, {}, false}));
  pot.draw();
  EXPECT_TRUE(pot.picture.glazed());
  EXPECT_GT(pot.picture.paint()[pot.texel(0.06)][3], 240);
  pot.picture.fire(true);
  pot.picture.draw(pot.surface, 1 << 20);
  EXPECT_EQ(pot.picture.paint()[pot.texel(0.06)][3], 0);
  EXPECT_EQ(pot.picture.form()[pot.texel(0.06)][3], pot.surface.glaze(240, 0));
  EXPECT_EQ(pot.picture.form()[pot.texel(0.01)][3], 0);
  pot.surface.undo();
  pot.draw();
  EXPECT_FALSE(pot.picture.glazed());
}

TEST(CoatPicture, AStrokeRenewsTheTilesThatItTouchedAlone) {
  Pot pot;
  surface::Tracer tracer(pot.surface, 100.0);
  tracer.go({0.08, 0.002});
  tracer.go({0.08, 0.02});
  tracer.lift();
  ASSERT_TRUE(apply(pot.surface, {surface::BrushDef{}, tracer.stations(), false}));
  const std::uint64_t before = pot.picture.change();
  // Its left edge reaches over angle 0.
  pot.picture.touch(295, 345, -30, 50);
  EXPECT_TRUE(pot.picture.draw(pot.surface, 1));
  EXPECT_FALSE(pot.picture.draw(pot.surface, 100));
  int renewed = 0;
  for (int down = 0; down < pot.picture.tiles_down(); ++down)
    for (int across = 0; across < pot.picture.tiles_across(); ++across)
      if (pot.picture.change(down, across) > before) {
        ++renewed;
        EXPECT_TRUE(across == 0 || across == 27) << across;
        EXPECT_TRUE(down == 4 || down == 5) << down;
      }
  EXPECT_EQ(renewed, 4);
  CoatPicture whole(pot.surface, two_slips());
  whole.touch_all();
  whole.draw(pot.surface, 1 << 20);
  EXPECT_EQ(whole.paint(), pot.picture.paint());
  EXPECT_EQ(whole.form(), pot.picture.form());
}

TEST(CoatPicture, AHeightLeadsToTheRowThatHasIt) {
  const Pot pot;
  const auto& heights = pot.picture.rows_by_height();
  const double top = jar().height();
  for (int n = 3; n < CoatPicture::kHeights - 3; n += 7) {
    const double height = top * n / (CoatPicture::kHeights - 1);
    const auto row = [&](std::size_t side) {
      return static_cast<int>(heights[static_cast<std::size_t>(n)][side] *
                              static_cast<float>(pot.picture.height()));
    };
    EXPECT_NEAR(pot.surface.row(row(0)).height, height, 4e-4) << n;
    EXPECT_EQ(pot.surface.row(row(0)).part, surface::Part::outside);
    if (height < jar().floor_height() + 5e-4) continue;
    EXPECT_NEAR(pot.surface.row(row(1)).height, height, 4e-4) << n;
    EXPECT_EQ(pot.surface.row(row(1)).part, surface::Part::inside);
  }
  EXPECT_GT(pot.picture.lip_to(), pot.picture.lip_from());
  EXPECT_GT(pot.picture.floor_from(), pot.picture.lip_to());
}

}  // namespace
}  // namespace onggi::decoration::coat_picture_test
