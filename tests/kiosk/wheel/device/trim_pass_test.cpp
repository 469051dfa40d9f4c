#include "kiosk/wheel/device/trim_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace onggi::device::trim_pass_test {
namespace {

constexpr double kLoop = 0.008;  // m, its radius

/// A bowl whose wall hangs over its foot: outer radius by height, on a floor of 10 mm.
ClayView bowl(double (*outer)(double)) {
  ClayDef def;
  def.rows = 200;
  def.sectors = 16;
  def.height = 0.1;
  def.floor_thickness = 0.01;
  ClayView clay;
  clay.lay(def);
  for (int j = 0; j < clay.rows(); ++j) {
    const auto face = static_cast<float>(outer(clay.row_height(j)));
    clay.shape(j, std::vector<float>(16, face), std::vector<float>(16, face - 0.006f));
  }
  return clay;
}

double flaring(double h) { return 0.05 + 1.4 * std::max(0.0, h - 0.006); }
/// That with a foot turned smaller: 8 mm less under 8 mm of height, and nothing above 12.
double footed(double h) { return flaring(h) - 0.008 * std::clamp((0.012 - h) / 0.004, 0.0, 1.0); }

Profile profile_of(double (*outer)(double)) {
  Profile p;
  for (int n = 0; n <= 200; ++n)
    p.points.push_back({0.0005 * n, outer(0.0005 * n), n > 20 ? outer(0.0005 * n) - 0.006 : 0.0});
  return p;
}

/// m between the loop's rim and the clay, below 0 where it cuts.
double gap(const ClayView& clay, const HandInput& hand) {
  double least = 1;
  for (double up = -kLoop; up <= kLoop; up += 0.0005) {
    const double h = hand.position.y + up;
    if (h < 0.0005) continue;
    const double near = hand.position.x - std::sqrt(std::max(0.0, kLoop * kLoop - up * up));
    least = std::min(least, near - clay.radius_at(h, WallSide::outside));
  }
  return least;
}

TEST(TrimPass, OnTheWayBackUpItNeverTouchesTheWallThatHangsOverTheFoot) {
  const ClayView clay = bowl(flaring);
  const Profile target = profile_of(footed);
  TrimPass pass(2, kLoop);
  pass.begin(clay, target);
  ASSERT_FALSE(pass.done());
  double was = pass.input({1, 0, 0}).position.y;
  int up = 0;
  for (int frame = 0; frame < 400 && !pass.done(); ++frame) {
    pass.follow(clay, target, 0.025);
    const HandInput hand = pass.input({1, 0, 0});
    if (hand.position.y > was) {
      ++up;
      EXPECT_GT(gap(clay, hand), 0.002) << frame;
      EXPECT_LT(hand.position.y - was, 0.003) << "no leap";
    }
    was = hand.position.y;
  }
  EXPECT_GT(up, 3);
}

TEST(TrimPass, TakesWhatIsTooMuchAndLeavesWhatIsTheTargetsAlone) {
  const ClayView clay = bowl(flaring);
  const Profile target = profile_of(footed);
  TrimPass pass(2, kLoop);
  pass.begin(clay, target);
  double deepest = 0;
  for (int frame = 0; frame < 400 && !pass.done(); ++frame) {
    pass.follow(clay, target, 0.025);
    const HandInput hand = pass.input({1, 0, 0});
    deepest = std::max(deepest, -gap(clay, hand));
    // Where its middle is that high it reaches no clay that is too much.
    if (hand.position.y > 0.0155) {
      EXPECT_GT(gap(clay, hand), 0.0004) << hand.position.y;
    }
  }
  EXPECT_NEAR(deepest, TrimPass::kDeep, 3e-4);
}

TEST(TrimPass, OfAFootThatIsThereNothingIsTaken) {
  const ClayView clay = bowl(footed);
  TrimPass pass(2, kLoop);
  pass.begin(clay, profile_of(footed));
  EXPECT_TRUE(pass.done());
  EXPECT_FALSE(pass.input({1, 0, 0}).active);
}

}  // namespace
}  // namespace onggi::device::trim_pass_test
