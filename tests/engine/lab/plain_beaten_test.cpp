#include "engine/lab/plain_beaten.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/portable.h"

namespace onggi::lab::plain_beaten_test {
namespace {

constexpr double kOut = 0.055, kIn = 0.045;  // m

ClayDef a_wall() {
  ClayDef clay;
  clay.rows = 400;
  clay.sectors = 720;
  clay.outer_radius = kOut;
  clay.inner_radius = kIn;
  return clay;
}

double radius_of(const PlainBeaten& wall, WallSide side, double up, double angle) {
  return radius_at(wall.face(side, 0.02, 0.18, 321), up, angle);
}

TEST(PlainBeaten, WhatLiesOnASlantingPlaneStandsOutOfItNowhere) {
  std::vector<PlainPlace> places;
  for (int n = 0; n < 50; ++n) {
    const double round = 0.3 + 0.01 * (n * 7 % 11), up = 0.02 * n - 0.4;
    places.push_back({1.0 + n % 3, round, up, 0.05 + 0.003 * round - 0.002 * up});
  }
  for (const double proud : out_of_plane(places)) EXPECT_NEAR(proud, 0.0, 1e-15);
  places[20].value += 1e-3;
  const auto proud = out_of_plane(places);
  EXPECT_GT(proud[20], 9e-4);
  EXPECT_LT(proud[0], 0.0);
}

TEST(PlainBeaten, WithoutAnAnvilTheWallDentsByTheEnergyOverPiYTSquared) {
  const BeatingDef law;
  PlainBeaten wall(a_wall(), law);
  wall.strike({0.1, 1.0, 0.5, 0.0});
  const double dent = 0.5 * law.energy / (portable::kPi * law.yield_stress * 1e-4);
  EXPECT_NEAR(kOut - radius_of(wall, WallSide::outside, 0.1, 1.0), dent, 0.002 * dent);
  EXPECT_NEAR(kIn - radius_of(wall, WallSide::inside, 0.1, 1.0), dent, 0.002 * dent);
  EXPECT_NEAR(radius_of(wall, WallSide::outside, 0.1, 1.0 + portable::kPi), kOut, 1e-12);
}

TEST(PlainBeaten, OnAnAnvilTheWallIsThinnedByTheEnergyOverThePressure) {
  const BeatingDef law;
  PlainBeaten wall(a_wall(), law);
  wall.strike({0.1, 1.0, 1.0, 1.0});
  // Of a face that falls off as (1 - rho^2)^2 the mean is a third.
  const double wide = portable::kPi * law.face * law.face / 3.0;
  const double pressure = law.yield_stress * (1.0 + 2.0 * law.face / (3.0 * std::sqrt(3.0) * 0.01));
  const double thinner =
      kOut - kIn -
      (radius_of(wall, WallSide::outside, 0.1, 1.0) - radius_of(wall, WallSide::inside, 0.1, 1.0));
  EXPECT_NEAR(thinner / (law.energy / pressure / wide), 1.0, 0.03);
}

TEST(PlainBeaten, TheClayIsKeptAndGoesRoundAndUpAlike) {
  PlainBeaten wall(a_wall(), {});
  wall.strike({0.1, 1.0, 1.0, 1.0});
  // Away from the face the ring only gets wider, and the rows above it higher.
  const double wider = radius_of(wall, WallSide::outside, 0.1, 4.0) / kOut - 1.0;
  const double higher = wall.height() - a_wall().height;
  EXPECT_GT(wider, 1e-5);
  EXPECT_NEAR(wall.volume() / (portable::kPi * (kOut * kOut - kIn * kIn) * a_wall().height), 1.0,
              1e-12);
  EXPECT_GT(higher, 1e-6);
  EXPECT_LT(higher, 2.0 * wider * 2.0 * BeatingDef{}.face);
}

}  // namespace
}  // namespace onggi::lab::plain_beaten_test
