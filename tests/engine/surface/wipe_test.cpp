#include "engine/surface/wipe.h"

#include <gtest/gtest.h>

#include "engine/math/portable.h"
#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::wipe_test {
namespace {

Surface glazed(double seconds = 1.0) {
  Surface surface = made(jar());
  DipDef dip = whole_dip();
  dip.seconds = seconds;
  done(surface, dip);
  return surface;
}

TEST(Wipe, LosesNoGlaze) {
  for (const double pressure : {1.0, 0.3}) {
    Surface surface = glazed();
    const Volume before = surface.glaze_volume();
    done(surface, WipeDef{}, straight(surface, {0.05, 0.0, pressure}, {0.11, 0.1, pressure}));
    done(surface, WipeDef{}, straight(surface, {0.10, 0.1, pressure}, {0.05, -0.1, pressure}));
    EXPECT_EQ(surface.glaze_volume(), before);
    expect_whole(surface);
  }
}

TEST(Wipe, LeavesAFilmAndTwoRidges) {
  Surface surface = glazed();
  done(surface, WipeDef{}, straight(surface, {0.05, 0.0}, {0.11, 0.0}));
  const int j = 320;  // 80 mm
  const int cells = static_cast<int>(0.006 / (surface.row(j).width * 1e-9));
  for (int i = -cells + 1; i < cells - 1; ++i) ASSERT_EQ(surface.glaze(j, wrapped(i)), 5) << i;
  for (const int side : {-1, 1}) {
    // 100 units were there; a ridge is about 75 more, a third higher at the finger.
    EXPECT_NEAR(surface.glaze(j, wrapped(side * (cells + 4))), 187, 15) << side;
    EXPECT_EQ(surface.glaze(j, wrapped(side * (cells + 140))), 100) << side;
  }
}

TEST(Wipe, RidgesAtABendAreEvenAndHaveNoSpikes) {
  Surface surface = glazed();
  // A hand's arch, whose middle goes back and forth a little.
  Tracer tracer(surface, 100.0);
  for (int n = 0; n <= 60; ++n) {
    const double angle = 0.05236 * n, jitter = n % 3 == 0 ? 4e-4 : -2e-4;
    tracer.go({0.08 + (0.008 + jitter) * portable::sin(angle), 0.5 + 0.02 * portable::cos(angle)});
  }
  tracer.lift();
  WipeDef finger;
  finger.width = 0.006;
  const Volume before = surface.glaze_volume();
  done(surface, finger, tracer.stations());
  EXPECT_EQ(surface.glaze_volume(), before);
  // Cells that stand over both their neighbours, along or round, by more than half a ridge.
  int spikes = 0, ridge = 0;
  for (int j = 230; j < 420; ++j)
    for (int i = 700; i < 980; ++i) {
      const auto over = [&](int dj, int di) {
        return surface.glaze(j, i) -
               std::max(surface.glaze(j + dj, i + di), surface.glaze(j - dj, i - di));
      };
      spikes += over(1, 0) > 37 || over(0, 1) > 37;
      ridge += surface.glaze(j, i) > 130;
    }
  EXPECT_GT(ridge, 1000);
  EXPECT_LT(spikes, ridge / 100);
}

TEST(Wipe, AtAnEndOfThePotTheGlazeStaysOnIt) {
  Surface surface = glazed();
  const Volume before = surface.glaze_volume();
  done(surface, WipeDef{}, band(surface, 0.0));
  done(surface, WipeDef{}, band(surface, surface.rows() * kRowHeight * 1e-6));
  EXPECT_EQ(surface.glaze_volume(), before);
}

TEST(Wipe, ThickGlazeAndANarrowRidgeStillLoseNothing) {
  Surface surface = glazed(60.0);
  const Volume before = surface.glaze_volume();
  WipeDef def;
  def.width = 0.03, def.ridge = 5e-5;
  for (int n = 0; n < 3; ++n) done(surface, def, straight(surface, {0.05, 0.0}, {0.08, 0.02}));
  EXPECT_EQ(surface.glaze_volume(), before);
}

TEST(Wipe, DryGlazeStays) {
  Surface surface = glazed();
  const std::uint64_t hash = surface.hash();
  WipeDef def;
  done(surface, def, straight(surface, {0.05, 0.0, 1.0, def.wet_time}, {0.08, 0.0, 1.0, 99.0}));
  EXPECT_EQ(surface.hash(), hash);
  // Half dry, it leaves half.
  done(surface, def, straight(surface, {0.05, 0.0, 1.0, 30.0}, {0.08, 0.0, 1.0, 30.0}));
  EXPECT_NEAR(surface.glaze(260, 0), 100 - 95 / 2, 2);
}

}  // namespace
}  // namespace onggi::surface_test::wipe_test
