#include "kiosk/exhibit/rehearsal/looks_smooth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::rehearsal::looks_smooth_test {
namespace {

// A pot 0.2 m high whose outer radius at height h is `radius(h)`.
template <class Radius>
Profile pot(Radius radius) {
  Profile p;
  for (int i = 0; i <= 2000; ++i) {
    const double h = 0.0001 * i;
    p.points.push_back({h, radius(h), h < 0.01 ? 0.0 : 0.03});
  }
  return p;
}

TEST(Smoothness, ARoundBellyIsSmoothHoweverWideItIs) {
  const Smoothness s = smoothness(pot([](double h) { return 0.05 + 0.04 * std::sin(15.0 * h); }));
  EXPECT_LT(s.roughness, 0.0001);
  EXPECT_LT(s.ledge, 0.0002);
  EXPECT_TRUE(looks_smooth(s));
}

TEST(Smoothness, AScrewThreadIsAsRoughAsASineOfItsDepth) {
  // Threads 5 mm apart: the mean over 10 mm, with both ends, keeps 1/21 of a wave.
  const Smoothness s =
      smoothness(pot([](double h) { return 0.05 + 0.001 * std::sin(2 * 3.14159265 * h / 0.005); }));
  EXPECT_NEAR(s.roughness, 0.001 / std::sqrt(2.0), 0.00004);
  EXPECT_FALSE(looks_smooth(s));
}

TEST(Smoothness, APlateForARimIsALedgeOfItsBreadth) {
  const Smoothness s = smoothness(pot([](double h) { return h < 0.19 ? 0.05 : 0.06; }));
  EXPECT_NEAR(s.ledge, 0.01, 0.0011);
  EXPECT_FALSE(looks_smooth(s));
}

TEST(Smoothness, ALumpIsAsFarFromItselfAsNothingAndFromATallerOneAsThatIsTaller) {
  const Profile lump = pot([](double) { return 0.05; });
  EXPECT_EQ(outline_distance(lump, lump), 0.0);
  EXPECT_NEAR(outline_distance(lump, pot([](double) { return 0.056; })), 0.006, 1e-12);
  Profile low = lump;
  low.points.resize(1500);
  EXPECT_NEAR(outline_distance(lump, low), 0.0501, 1e-9);
}

}  // namespace
}  // namespace onggi::rehearsal::looks_smooth_test
