#include "engine/surface/station.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::station_test {
namespace {

TEST(Station, AWayHasOneEveryHalfMillimetreAndOneAtItsEnd) {
  const Surface surface = made(bowl());
  const auto stations = straight(surface, {0.010, 0.0}, {0.0202, 0.0});
  ASSERT_EQ(stations.size(), 22u);  // 0 to 10 mm, and 10.2
  for (std::size_t n = 0; n < 21; ++n)
    EXPECT_NEAR(stations[n].along, 10000.0 + 500.0 * static_cast<double>(n), 1.0);
  EXPECT_EQ(stations.back().along, 20200);
}

TEST(Station, LeftOfAWayUpThePotIsWhereAnglesGrow) {
  const Surface surface = made(bowl());
  const Station up = straight(surface, {0.010, 0.0}, {0.020, 0.0}).front();
  EXPECT_EQ(up.across_along, 0);
  EXPECT_EQ(up.across_round, kUnit);
  const Station on = straight(surface, {0.010, 0.0}, {0.010, 0.1}).front();
  EXPECT_EQ(on.across_along, -kUnit);
  EXPECT_EQ(on.across_round, 0);
}

TEST(Station, OnceRoundIsTheGirth) {
  const Surface surface = made(bowl());
  const auto stations = band(surface, 0.03);
  const double girth = 2.0 * 3.14159265 * surface.row(120).radius;
  EXPECT_NEAR(static_cast<double>(stations.size()), girth / 5e-4, 2.0);
  EXPECT_EQ(stations.back().round - stations.front().round, kTurn);
}

TEST(Station, TheLoadRunsOutWithTheWay) {
  const Surface surface = made(bowl());
  const auto stations = straight(surface, {0.0, 0.0}, {0.02, 0.0}, 0.01);
  EXPECT_EQ(stations.front().load, kWhole);
  EXPECT_EQ(stations[10].load, kWhole / 2);
  EXPECT_EQ(stations.back().load, 0);
}

TEST(Station, PressureAndAgeAreToldBetweenTheHandsPlaces) {
  const Surface surface = made(bowl());
  const auto stations = straight(surface, {0.0, 0.0, 0.0, 10.0}, {0.01, 0.0, 1.0, 12.0});
  EXPECT_EQ(stations[10].pressure, kWhole / 2);
  EXPECT_NEAR(stations[10].age, 11000, 1);
}

TEST(Station, AWayGivenInMorePlacesHasTheSameStations) {
  const Surface surface = made(bowl());
  Tracer once(surface, 0.4), often(surface, 0.4);
  once.go({0.010, 0.0}), once.go({0.010, 0.5}), once.lift();
  for (int n = 0; n <= 7; ++n) often.go({0.010, n / 14.0});
  often.lift();
  ASSERT_EQ(once.stations().size(), often.stations().size());
  for (std::size_t n = 0; n < once.stations().size(); ++n) {
    EXPECT_NEAR(once.stations()[n].round, often.stations()[n].round, 1) << n;
    EXPECT_EQ(once.stations()[n].along, often.stations()[n].along) << n;
  }
}

TEST(Station, AHandThatOnlyTouchedLeavesOne) {
  const Surface surface = made(bowl());
  EXPECT_EQ(straight(surface, {0.01, 0.2}, {0.01, 0.2}).size(), 1u);
  Tracer never(surface, 0.4);
  never.lift();
  EXPECT_TRUE(never.stations().empty());
}

TEST(Station, AHandOffThePotIsMovedToItsEnd) {
  const Surface surface = made(bowl());
  Tracer tracer(surface, 0.4);
  tracer.go({-5.0, 0.0}), tracer.go({0.001, 1e-4}), tracer.go({0.001, 1e-4}), tracer.lift();
  EXPECT_EQ(tracer.stations().front().along, 0);
  Tracer beyond(surface, 0.4);
  beyond.go({9.0, 2e3}), beyond.lift();
  EXPECT_EQ(beyond.stations().front().along, surface.rows() * kRowHeight);
  EXPECT_EQ(beyond.stations().front().round, kMostTurns * kTurn);
}

}  // namespace
}  // namespace onggi::surface_test::station_test
