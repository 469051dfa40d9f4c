#include "engine/effects/moisture.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

namespace onggi::effects::moisture_test {
namespace {

Clay lump() {
  ClayDef def;
  def.rows = 100;
  def.sectors = 48;
  return std::move(*Clay::create(def));  // 20 cm: a row every 2 mm
}

MoistureDef by_rows(double air = 0.0) {
  MoistureDef def;
  def.sponge_height = 0.04;
  def.air = air;
  return def;
}

void run(Moisture& wet, const MoistureDef& def, const Clay& clay, double seconds, double dt,
         bool sponge, double height = 0.1) {
  const std::array<double, 1> heights{height};
  for (int n = 0; n < static_cast<int>(std::lround(seconds / dt)); ++n)
    wet.soak_or_dry(def, clay, dt, sponge, heights);
}

TEST(Moisture, ASpongeWetsTheBandItIsHeldToAndNoOther) {
  const Clay clay = lump();
  const MoistureDef def = by_rows();
  Moisture wet(def, clay.rows());
  run(wet, def, clay, 3.0, 0.001, true);
  EXPECT_GT(wet.at(clay, 0.1), 0.98);
  EXPECT_GT(wet.at(clay, 0.117), 0.98);
  EXPECT_EQ(wet.at(clay, 0.125), 0.0);
  EXPECT_EQ(wet.at(clay, 0.02), 0.0);
  EXPECT_NEAR(wet.mean(), 0.2, 0.01);  // 4 of 20 cm
}

TEST(Moisture, WithNoHandOnTheClayTheSpongeWetsTheWholePot) {
  const Clay clay = lump();
  const MoistureDef def = by_rows();
  Moisture wet(def, clay.rows());
  wet.soak_or_dry(def, clay, def.wetting_time, true, {});
  const double drying = def.wetting_time / def.drying_time;  // goes on
  const double wetness = (1.0 - std::exp(-1.0 - drying)) / (1.0 + drying);
  for (int j = 0; j < clay.rows(); ++j) EXPECT_NEAR(wet.of_row(j), wetness, 1e-12);
}

TEST(Moisture, DriesAsAnExactExponentialWhateverTheTicksLength) {
  const Clay clay = lump();
  for (const MoistureDef& def : {by_rows(), by_rows(0.3), MoistureDef{}}) {
    for (const double dt : {0.0005, 0.005}) {
      Moisture wet(def, clay.rows());
      run(wet, def, clay, 2.0, dt, true);
      const double before = wet.at(clay, 0.1);
      run(wet, def, clay, 30.0, dt, false);
      EXPECT_NEAR(wet.at(clay, 0.1), def.air + (before - def.air) * std::exp(-0.5), 1e-9);
    }
  }
}

TEST(Moisture, AnHourOfDryingAndWettingKeepsTheSameFiguresAsTheFirstMinute) {
  const Clay clay = lump();
  MoistureDef def = by_rows(0.1);
  def.drying_time = 1.0;  // so that the common factor is renewed 260 times
  Moisture wet(def, clay.rows());
  run(wet, def, clay, 3600.0, 0.05, false);
  EXPECT_NEAR(wet.of_row(3), 0.1, 1e-12);
  run(wet, def, clay, 3.0, 0.005, true);
  const double soaked = wet.at(clay, 0.1);
  Moisture fresh(def, clay.rows());
  run(fresh, def, clay, 60.0, 0.05, false);
  run(fresh, def, clay, 3.0, 0.005, true);
  EXPECT_NEAR(soaked, fresh.at(clay, 0.1), 1e-9);
}

RC_GTEST_PROP(MoistureProperty, WhateverSpongeAndAirDoNoRowIsDrierThanDryOrWetterThanWet, ()) {
  const Clay clay = lump();
  MoistureDef def = by_rows(*rc::gen::inRange(0, 11) * 0.1);
  def.drying_time = *rc::gen::inRange(1, 100);
  Moisture wet(def, clay.rows());
  for (int n = 0; n < 300; ++n) {
    if (*rc::gen::inRange(0, 50) == 0) def.air = *rc::gen::inRange(0, 11) * 0.1;
    const std::array<double, 2> heights{*rc::gen::inRange(-5, 30) * 0.01, 0.05};
    wet.soak_or_dry(def, clay, *rc::gen::inRange(1, 51) * 1e-4, *rc::gen::inRange(0, 2) == 1,
                    std::span(heights).first(static_cast<std::size_t>(*rc::gen::inRange(0, 3))));
    double sum = 0.0;
    for (int j = 0; j < clay.rows(); ++j) {
      RC_ASSERT(wet.of_row(j) >= -1e-12 && wet.of_row(j) <= 1.0 + 1e-12);
      sum += wet.of_row(j);
    }
    RC_ASSERT(std::fabs(wet.mean() - sum / clay.rows()) < 1e-9);
  }
}

TEST(Moisture, WetClayGivesWaySoonerAndCarriesThirtyTimesLess) {
  const MoistureDef def;
  EXPECT_EQ(softness(def, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(softness(def, 1.0), def.softening);
  EXPECT_EQ(strength(def, 0.0), 1.0);
  EXPECT_NEAR(strength(def, 1.0), 0.03, 1e-12);
  EXPECT_NEAR(strength(def, 0.5) * strength(def, 0.5), 0.03, 1e-12);
}

}  // namespace
}  // namespace onggi::effects::moisture_test
