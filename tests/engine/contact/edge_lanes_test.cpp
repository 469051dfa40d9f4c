#include "engine/contact/edge_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::ONGGI_LANES::edge_lanes_test {
namespace {

double edge(double press, double out, double in) {
  float lanes[kLanes];
  store(edge_of(all(static_cast<float>(press)), all(static_cast<float>(out)),
                all(static_cast<float>(in))),
        lanes);
  return double{lanes[0]};
}

// A print `half` elements wide to both sides of `middle`, in elements: its sum, and with edges.
struct Sums {
  double plain = 0.0, mended = 0.0;
};
Sums sums_of(double half, double middle) {
  const auto open = [&](int i) { return half * half - (i - middle) * (i - middle); };
  Sums sums;
  for (int i = -20; i <= 20; ++i) {
    if (open(i) <= 0.0) continue;
    sums.plain += open(i);
    sums.mended += open(i);
    if (open(i - 1) < 0.0) sums.mended += edge(open(i), open(i - 1), open(i + 1));
    if (open(i + 1) < 0.0) sums.mended += edge(open(i), open(i + 1), open(i - 1));
  }
  return sums;
}

TEST(Edge, MakesASumOverARoundPrintItsIntegralWhereverElementsLie) {
  for (const double half : {3.0, 4.7, 9.0}) {
    const double integral = 4.0 / 3.0 * half * half * half;
    double most = 0.0;
    for (int n = 0; n < 16; ++n) {
      const Sums sums = sums_of(half, (n + 0.5) / 16.0);
      EXPECT_NEAR(sums.mended / integral, 1.0, 1e-4) << half << ' ' << n;
      most = std::max(most, std::fabs(sums.plain / integral - 1.0));
    }
    EXPECT_GT(most, 0.05 / (half * half)) << half;
  }
}

TEST(Edge, OfAStraightSlopeIsBernoullisParabola) {
  for (const double way : {0.05, 0.3, 0.5, 0.9})
    EXPECT_NEAR(edge(way, way - 1.0, way + 1.0), 0.5 * (way * way - way + 1.0 / 6.0), 1e-6);
}

TEST(Edge, OfClayThatLiesAtRestAgainstTheBodyIsNothing) {
  EXPECT_NEAR(edge(1e-7, -1e-4, 1e-7), 0.0, 2e-7);
  EXPECT_NEAR(edge(1e-7, -1e-4, 0.0), 0.0, 2e-7);
}

TEST(Edge, OfAPrintOfOneElementIsLeftToTheSum) {
  EXPECT_EQ(edge(1.0, -2.0, -2.0), 0.0);
  EXPECT_EQ(edge(1.0, -2.0, -3.0), 0.0);
}

struct Met {
  Float8 covered, left, right;
};
// What is felt beside lane 3 of a print that ends there, in a step of which a press is `mean`.
double beside(double press, double out, double in, double fresh, double share, double mean) {
  float open[kLanes], radius[kLanes], felt[kLanes];
  for (int k = 0; k < kLanes; ++k) {
    open[k] = static_cast<float>(k < 3 ? in : k == 3 ? press : out);
    radius[k] = static_cast<float>(k > 3 ? 0.05 + fresh : 0.05);
  }
  const Edged nothing{all(0.0f), all(0.05f), 0};
  const Float8 bare = all(static_cast<float>(share));
  store(felt_beside<WallSide::outside>(nothing, {load(open), load(radius), 0x0f}, nothing,
                                       Met{all(1.0f) - bare, all(0.0f), bare}, {0, false, false},
                                       all(static_cast<float>(mean))),
        felt);
  return double{felt[3]};
}

TEST(Edge, WhatIsPressedFadesInAStepAndHowFarTheBodyIsShortOfTheRestDoesNot) {
  const double mean = 0.8;
  const double whole = beside(0.3e-3, -0.7e-3, 1.3e-3, 0.0, 0.0, mean);
  EXPECT_NEAR(mean * whole, edge(mean * 0.3e-3, -0.7e-3, mean * 1.3e-3), 1e-9);
  EXPECT_GT(std::fabs(whole - edge(0.3e-3, -0.7e-3, 1.3e-3)), 1e-6);
}

TEST(Edge, ThePartThatIsCoveredHasGivenWayByAllThatTheElementHas) {
  // A quarter bare, beside clay that stands 0.2 mm higher: of that a quarter was the covered
  // part's.
  EXPECT_NEAR(beside(1e-3, 0.0, 1e-3, 2e-4, 0.25, 1.0), -0.25 * 2e-4, 1e-8);
  EXPECT_NEAR(beside(1e-3, 0.0, 1e-3, 2e-4, 0.25, 0.8), -0.25 * 2e-4 / 0.8, 1e-8);
  EXPECT_EQ(beside(1e-3, 0.0, 1e-3, -2e-4, 0.25, 1.0), 0.0);
}

// What is felt beside each lane of eight elements, of a sheet that nothing was pressed of yet.
void beside_each(const float* open, float* felt) {
  const Edged nothing{all(0.0f), all(0.05f), 0};
  store(felt_beside<WallSide::outside>(nothing, {load(open), all(0.05f), 0xff}, nothing,
                                       Met{all(1.0f), all(0.0f), all(0.0f)}, {0, false, false},
                                       all(0.9f)),
        felt);
}

TEST(Edge, APrintBeginsAsItEnds) {
  const float ends[kLanes] = {1.7f, 1.4f, 1.0f, 0.3f, -0.6f, -1.7f, -2.0f, -2.1f};
  float begins[kLanes], felt[kLanes], mirrored[kLanes];
  for (int k = 0; k < kLanes; ++k) begins[k] = ends[kLanes - 1 - k];
  beside_each(ends, felt);
  beside_each(begins, mirrored);
  EXPECT_NE(felt[3], 0.0f);
  EXPECT_EQ(felt[3], mirrored[4]);
  for (const int k : {1, 2}) {
    EXPECT_EQ(felt[k], 0.0f) << k;
    EXPECT_EQ(mirrored[kLanes - 1 - k], 0.0f) << k;
  }
}

TEST(Edge, APrintOfOneElementIsLeftToTheSumThoughItHasTwoEdges) {
  for (const float other : {-0.001f, -0.3f, -1.0f, -4.0f}) {
    const float open[kLanes] = {-5.0f, -2.0f, other, 1.0f, -1.0f, -2.0f, -2.0f, -2.0f};
    float felt[kLanes];
    beside_each(open, felt);
    EXPECT_EQ(felt[3], 0.0f) << other;
  }
}

TEST(Edge, NeighboursGoOnRoundTheTurnPastItsPadding) {
  const float before[kLanes] = {0, 1, 2, 3, 4, -1, -1, -1};
  const float here[kLanes] = {10, 11, 12, 13, 14, 15, 16, 17};
  const float after[kLanes] = {20, 21, 22, 23, 24, 25, 26, 27};
  float left[kLanes], right[kLanes];
  const auto ask = [&](Seam seam) {
    const Neighbours n = neighbours(load(before), load(here), load(after), seam);
    store(n.left, left);
    store(n.right, right);
  };
  ask({3, false, false});
  EXPECT_EQ(left[0], -1.0f);
  EXPECT_EQ(left[5], 14.0f);
  EXPECT_EQ(right[5], 16.0f);
  EXPECT_EQ(right[7], 20.0f);
  ask({3, true, false});
  EXPECT_EQ(left[0], 4.0f);
  ask({3, false, true});
  EXPECT_EQ(right[4], 20.0f);
}

}  // namespace
}  // namespace onggi::ONGGI_LANES::edge_lanes_test
