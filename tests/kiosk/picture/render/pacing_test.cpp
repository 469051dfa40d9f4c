#include "kiosk/picture/render/pacing.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace onggi::render::pacing_test {
namespace {

// A machine on which a frame costs `fixed` ms and `full` more at full scale.
double settle(Pacing& pacing, double fixed, double full, int frames = 400) {
  for (int i = 0; i < frames; ++i) {
    pacing.frame(fixed + full * pacing.scale() * pacing.scale());
  }
  return pacing.scale();
}

TEST(Pacing, AFastMachineKeepsFullScale) {
  Pacing pacing(70, 36);
  EXPECT_EQ(settle(pacing, 3, 10), 1.0);
}

TEST(Pacing, AHopelessMachineStopsAtTheLeastScale) {
  Pacing pacing(70, 36);
  EXPECT_EQ(settle(pacing, 500, 500), Pacing::kLeast);
}

TEST(Pacing, SettlesOnEveryMachineAndStaysThere) {
  EXPECT_TRUE(rc::check([] {
    Pacing pacing(70, 36);
    const double fixed = *rc::gen::inRange(1, 30), full = *rc::gen::inRange(1, 400);
    const double settled = settle(pacing, fixed, full);
    for (int i = 0; i < 100; ++i) RC_ASSERT(settle(pacing, fixed, full, 1) == settled);
    RC_ASSERT(settled >= Pacing::kLeast && settled <= Pacing::kMost);
    RC_ASSERT(settled == Pacing::kLeast || fixed + full * settled * settled <= 70.0);
  }));
}

TEST(Pacing, OneStallIsForgiven) {
  Pacing pacing(70, 36);
  settle(pacing, 5, 30);
  const double before = pacing.scale();
  pacing.frame(900);
  settle(pacing, 5, 30, 5);
  EXPECT_EQ(pacing.scale(), before);
}

}  // namespace
}  // namespace onggi::render::pacing_test
