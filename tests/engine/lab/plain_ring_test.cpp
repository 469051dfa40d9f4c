#include "engine/lab/plain_ring.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/effects/building.h"
#include "engine/math/portable.h"

namespace onggi::lab::plain_ring_test {
namespace {

constexpr double kCoil = 0.012, kMiddle = 0.05;  // m

// Once round, `wander` from the middle line in each half of the ring, in a second.
PlainRing ring_of(double wander) {
  return {kCoil,
          [=](double t) {
            Hands hands;
            const double angle = 2.0 * portable::kPi * t;
            const double out = kMiddle + wander * portable::sin(angle);
            hands.hand[0].position = {out * portable::cos(angle), 0.1, out * portable::sin(angle)};
            hands.hand[0].active = hands.hand[0].coil = true;
            return hands;
          },
          1.0};
}

TEST(PlainRing, OfARoundHandIsATorusByPappus) {
  const PlainRing ring = ring_of(0.0);
  EXPECT_NEAR(ring.volume(), 0.25 * portable::kPi * kCoil * kCoil * 2.0 * portable::kPi * kMiddle,
              1e-15);
  for (const double angle : {0.0, 1.0, 3.0, 6.2}) EXPECT_NEAR(ring.centre(angle), kMiddle, 1e-12);
}

TEST(PlainRing, HasAllOfTheCoilsSectionBetweenItsFaces) {
  const PlainRing ring = ring_of(0.0);
  double section = 0.0;
  constexpr int kSlices = 10'000;
  for (int k = 0; k < kSlices; ++k)
    section += ring.width((k + 0.5) / kSlices * ring.height()) * ring.height() / kSlices;
  EXPECT_NEAR(section / (0.25 * portable::kPi * kCoil * kCoil), 1.0, 1e-7);
  EXPECT_NEAR(ring.height() / kCoil, 0.893, 5e-4);
  EXPECT_NEAR(ring.width(0.5 * ring.height()), kCoil, 1e-12);
  EXPECT_NEAR(ring.width(0.0), 0.6 * kCoil, 1e-12);
}

TEST(PlainRing, FollowsTheHandAndClosesItsLastGapEvenly) {
  const PlainRing ring = ring_of(0.002);
  for (const double angle : {0.5, 1.5, 3.0, 4.5})
    EXPECT_NEAR(ring.centre(angle), kMiddle + 0.002 * std::sin(angle), 1e-8);
  // The gap is a coil wide: about 0.24 rad.
  const double gap = 2.0 * portable::kPi - kCoil / kMiddle;
  const double end = ring.centre(gap), middle = ring.centre(0.5 * (gap + 2.0 * portable::kPi));
  EXPECT_LT(end, kMiddle - 4e-4);
  EXPECT_NEAR(middle, 0.5 * (end + kMiddle), 1e-5);
  EXPECT_GT(std::fabs(ring.centre(gap + 0.12) - kMiddle - 0.002 * std::sin(gap + 0.12)), 1e-6);
}

TEST(PlainRing, ItsFacesAreItsWidthApartFromTheLowestRowToTheHighest) {
  const PlainRing ring = ring_of(0.001);
  const FaceGrid outer = ring.face(WallSide::outside, 0.1, 0.002, 0.006, 5, 90);
  const FaceGrid inner = ring.face(WallSide::inside, 0.1, 0.002, 0.006, 5, 90);
  EXPECT_NEAR(outer.bottom, 0.102, 1e-15);
  EXPECT_NEAR(outer.thickness, 0.001, 1e-15);
  ASSERT_EQ(outer.radius.size(), 450u);
  EXPECT_NEAR(outer.radius[0] - inner.radius[0], ring.width(0.002), 1e-12);
  EXPECT_NEAR(outer.radius[449] - inner.radius[449], ring.width(0.006), 1e-12);
}

}  // namespace
}  // namespace onggi::lab::plain_ring_test
