#include "engine/surface/lay.h"

#include <gtest/gtest.h>

#include "engine/math/random.h"
#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::lay_test {
namespace {

TEST(Lay, AnyVolumeOfSlipIsThereToTheLastUnit) {
  Surface surface = made(bowl());
  Random random(1);
  Volume laid = 0;
  for (int n = 0; n < 20000; ++n) {
    const int j = static_cast<int>(random.bits() % 8), i = static_cast<int>(random.bits() % 20);
    const Volume volume = static_cast<Volume>(random.uniform(0.0, 3e5)) * surface.row(j).area + 7;
    const Volume took = lay_slip(surface, j, i, static_cast<int>(random.bits() % 5), volume);
    ASSERT_LE(took, volume);
    ASSERT_GE(took, 0);
    laid += took;
  }
  EXPECT_EQ(all_slip(surface), laid);
  expect_whole(surface);
}

TEST(Lay, WithoutAFourthStratumEachPigmentsVolumeIsExact) {
  Surface surface = made(bowl());
  Random random(2);
  std::array<Volume, 3> laid{};
  for (int n = 0; n < 3000; ++n) {
    // Three pigments, one after the other.
    const int pigment = n / 1000, j = static_cast<int>(random.bits() % 4);
    laid[static_cast<std::size_t>(pigment)] +=
        lay_slip(surface, j, static_cast<int>(random.bits() % 50), pigment,
                 Volume{12345} * surface.row(j).area);
  }
  for (int pigment = 0; pigment < 3; ++pigment)
    EXPECT_EQ(surface.slip_volume(pigment), laid[static_cast<std::size_t>(pigment)]);
}

TEST(Lay, ARowsRestIsLessThanACodesStep) {
  Surface surface = made(bowl());
  Random random(3);
  for (int n = 0; n < 50000; ++n) {
    lay_slip(surface, 5, static_cast<int>(random.bits() % 200), 0,
             Volume{3000} * surface.row(5).area);
    const Volume step = Volume{thickness_of(kCodes - 1) - thickness_of(kCodes - 2)};
    ASSERT_LT(std::abs(surface.rest(5, 0)), step * surface.row(5).area);
  }
}

TEST(Lay, AnEvenCoatIsEvenToACode) {
  Surface surface = made(bowl());
  for (int i = 0; i < kSectors; ++i)
    lay_slip(surface, 9, i, 3, Volume{150'000} * surface.row(9).area);
  double sum = 0.0;
  for (int i = 0; i < kSectors; ++i) {
    const int nm = surface.slip(9, i).thickness();
    ASSERT_GE(nm, thickness_of(code_within(150'000)));
    ASSERT_LE(nm, thickness_of(code_within(150'000) + 1));
    sum += nm;
  }
  EXPECT_NEAR(sum / kSectors, 150'000, 20.0);
}

TEST(Lay, AnotherPigmentStartsAStratumAndAFourthJoinsTheTwoLowest) {
  Surface surface = made(bowl());
  const Volume area = surface.row(0).area;
  for (int pigment = 1; pigment <= 3; ++pigment)
    lay_slip(surface, 0, 0, pigment, 64'000 * pigment * area);
  EXPECT_EQ(surface.slip(0, 0).at(0).pigment, 3);
  EXPECT_EQ(surface.slip(0, 0).at(1).pigment, 2);
  EXPECT_EQ(surface.slip(0, 0).at(2).pigment, 1);
  lay_slip(surface, 0, 0, 4, 64'000 * area);
  EXPECT_EQ(surface.slip(0, 0).at(0).pigment, 4);
  EXPECT_EQ(surface.slip(0, 0).at(1).pigment, 3);
  EXPECT_EQ(surface.slip(0, 0).at(2).pigment, 2);  // the thicker of 1 and 2
  EXPECT_EQ(all_slip(surface), 64'000 * 7 * area);
}

TEST(Lay, AFullCellTakesNoMore) {
  Surface surface = made(bowl());
  const Volume area = surface.row(0).area;
  const Volume most = Volume{thickness_of(kCodes - 1)} * area;
  EXPECT_EQ(lay_slip(surface, 0, 0, 1, 2 * most), most);
  EXPECT_EQ(lay_slip(surface, 0, 0, 1, 1), 0);
  const Volume full = Volume{kMostGlaze} * kGlazeUnit * area;
  EXPECT_EQ(lay_glaze(surface, 0, 0, 2 * full), full);
  EXPECT_EQ(lay_glaze(surface, 0, 0, 1), 0);
  EXPECT_EQ(surface.glaze_volume(), full);
}

TEST(Lay, AnyVolumeOfGlazeIsThereToTheLastUnit) {
  Surface surface = made(bowl());
  Random random(4);
  Volume laid = 0;
  for (int n = 0; n < 20000; ++n) {
    const int j = static_cast<int>(random.bits() % 8);
    laid += lay_glaze(surface, j, static_cast<int>(random.bits() % 20),
                      static_cast<Volume>(random.uniform(0.0, 3e4)) * surface.row(j).area + 3);
  }
  EXPECT_EQ(surface.glaze_volume(), laid);
}

TEST(Lay, ACoatIsExactlyItsCodeAndNeverThinner) {
  Surface surface = made(bowl());
  const Volume area = surface.row(0).area;
  EXPECT_EQ(coat_slip(surface, 0, 0, 2, 20), Volume{thickness_of(20)} * area);
  EXPECT_EQ(coat_slip(surface, 0, 0, 2, 10), 0);
  EXPECT_EQ(coat_slip(surface, 0, 0, 2, 21), Volume{thickness_of(21) - thickness_of(20)} * area);
  EXPECT_EQ(coat_slip(surface, 0, 0, 5, 10), Volume{thickness_of(10)} * area);
  EXPECT_EQ(surface.slip(0, 0).at(1), (Stratum{21, 2}));
}

TEST(Lay, TrimTakesGlazeThenSlipThenClayAndCountsThem) {
  Surface surface = made(bowl());
  const Volume area = surface.row(0).area;
  coat_slip(surface, 0, 0, 1, 25), coat_slip(surface, 0, 0, 2, 29);
  surface.set_glaze(0, 0, 50), surface.set_burnish(0, 0, 2), surface.set_resist(0, 0, true);
  const int low = thickness_of(25), high = thickness_of(29);
  Work work;
  EXPECT_FALSE(trim(surface, 0, 0, surface.top(0, 0), work));
  EXPECT_EQ(work, Work{});
  EXPECT_EQ(surface.burnish(0, 0), 2);
  // Half of the glaze.
  EXPECT_TRUE(trim(surface, 0, 0, low + high + 25 * kGlazeUnit, work));
  EXPECT_EQ(surface.glaze(0, 0), 25);
  EXPECT_EQ(work.glaze_taken, 25 * kGlazeUnit * area);
  EXPECT_EQ(surface.burnish(0, 0), 0);
  EXPECT_FALSE(surface.resist(0, 0));
  // To within the upper stratum: the code that stays under it.
  EXPECT_TRUE(trim(surface, 0, 0, low + thickness_of(20), work));
  EXPECT_EQ(surface.slip(0, 0).at(0), (Stratum{20, 2}));
  EXPECT_EQ(surface.glaze(0, 0), 0);
  EXPECT_EQ(work.slip_taken, (high - thickness_of(20)) * area);
  EXPECT_EQ(work.clay_taken, 0);
  EXPECT_TRUE(trim(surface, 0, 0, -100'000, work));
  EXPECT_EQ(surface.slip(0, 0), Strata{});
  EXPECT_EQ(surface.relief(0, 0), -100);
  EXPECT_EQ(work.clay_taken, 100'000 * area);
  EXPECT_EQ(work.slip_taken, (low + high) * area);
  EXPECT_EQ(work.glaze_taken, 50 * kGlazeUnit * area);
}

}  // namespace
}  // namespace onggi::surface_test::lay_test
