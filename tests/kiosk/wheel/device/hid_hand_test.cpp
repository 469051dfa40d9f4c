#include "kiosk/wheel/device/hid_hand.h"

#include <algorithm>

#include "tests/kiosk/wheel/device/rig.h"
#include "tests/stand_in/simulated_others.h"
#include "tests/stand_in/simulated_puck.h"

namespace onggi::device::hid_hand_test {
namespace {

using stand_in::SimulatedArm;
using stand_in::SimulatedController;
using stand_in::SimulatedHandle;
using stand_in::SimulatedPuck;

const Vec3 kHandleHome = default_def(DeviceKind::onggi_hid).home;

/// Down the wall and up again, at a potter's pace.
stand_in::Track stroke(Vec3 from, long ms, long start) {
  std::vector<stand_in::TrackPoint> points;
  for (long n = 0; n < ms; ++n) {
    const double way = static_cast<double>(n) / static_cast<double>(ms);
    points.push_back({from + Vec3{-0.01 * way, 0.05 * std::sin(6.28 * way), 0.0}, true});
  }
  return stand_in::Track(points, start);
}

TEST(HidHand, APuckLeadsTheToolAlongAStrokeWithinAMillimetre) {
  for (const auto reports : {SimulatedPuck::Reports::split, SimulatedPuck::Reports::combined}) {
    const auto track = stroke({0.065, 0.10, 0.02}, 6000, 2500);
    Rig rig(std::make_unique<SimulatedPuck>(reports, track));
    ASSERT_TRUE(rig.open());
    double worst = 0.0;
    for (long ms = 1; ms < 8500; ++ms) {
      const HandInput in = rig.tick();
      if (ms < 2520) continue;
      EXPECT_TRUE(in.active) << ms;
      worst = std::max(worst, length(in.position - track.at(ms).at));
    }
    EXPECT_LT(worst, 1e-3);
  }
}

TEST(HidHand, APuckThatIsLetGoOfLiftsTheToolAndLaterBeginsAtHome) {
  Rig untouched(std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split, stand_in::Track()));
  ASSERT_TRUE(untouched.open());
  EXPECT_FALSE(untouched.tick(50).active) << "nobody has touched it yet";
  Rig rig(std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split,
                                          stroke({0.065, 0.10, 0.02}, 500, 2500)));
  ASSERT_TRUE(rig.open());
  EXPECT_TRUE(rig.tick(2700).active);
  const HandInput left = rig.tick(2000);
  EXPECT_FALSE(left.active);
  EXPECT_LT(length(left.position - Vec3{0.06, 0.10, 0.02}), 0.04);
  EXPECT_EQ(rig.tick(4000).position, default_def(DeviceKind::space_mouse).home);
  Rig left_handed(
      std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split, stand_in::Track()));
  ASSERT_TRUE(left_handed.open());
  EXPECT_LT(HidHand(left_handed.link, true).read(1e-3).position.x, 0.0);
}

TEST(HidHand, APuckThatFallsSilentWhilePushedDoesNotDriftOn) {
  Rig rig(std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split,
                                          stroke({0.065, 0.05, 0.02}, 6000, 2500)),
          {{3000, 3000, stand_in::Fault::stall}});
  ASSERT_TRUE(rig.open());
  rig.tick(3000);
  const Vec3 then = rig.tick(200).position;
  EXPECT_LT(length(rig.tick(500).position - then), 1e-6);
}

TEST(HidHand, AStickMovesTheToolAndThePushOfTheClayMakesItTremble) {
  for (const bool bluetooth : {false, true}) {
    auto owned = std::make_unique<SimulatedController>(bluetooth, 255, 128);
    SimulatedController& controller = *owned;
    Rig rig(std::move(owned));
    ASSERT_TRUE(rig.open());
    const Vec3 home = rig.link->def().home;
    EXPECT_NEAR(rig.tick(501, {}, false).position.x, home.x + 0.5 * rig.link->def().speed, 2e-3);
    EXPECT_EQ(controller.slow(), 0);
    rig.tick(20, {1.5, 0, 0});
    EXPECT_NEAR(controller.slow(), 100, 2) << bluetooth;
    EXPECT_GT(controller.quick(), 0) << "the first touch is a tap";
    rig.tick(100, {3.0, 0, 0});
    EXPECT_NEAR(controller.slow(), 200, 2);
    EXPECT_EQ(controller.quick(), 0);
    rig.tick(20, {}, false);
    EXPECT_EQ(controller.slow(), 0);
    rig.tick(40, {3.0, 0, 0});
    rig.feels = false;
    rig.tick(40);
    EXPECT_EQ(controller.slow(), 0) << "the loop stands still, and so does it";
    rig.feels = true;
    rig.tick(40, {3.0, 0, 0});
    EXPECT_GT(controller.slow(), 0);
    rig.hand.reset();
    rig.link.reset();
    EXPECT_EQ(controller.slow(), 0) << "the program has ended";
  }
}

// However fast: a gyroscope is no stick that has a dead middle.
TEST(HidHand, AControllerThatIsTiltedByAQuarterTurnsTheToolByAQuarter) {
  for (const double seconds : {1.0, 0.4}) {
    const int counts = static_cast<int>(90.0 / seconds * 32768.0 / 2000.0);
    auto owned = std::make_unique<SimulatedController>(false, 255, 128, counts, 200, seconds);
    Rig rig(std::move(owned));
    ASSERT_TRUE(rig.open());
    EXPECT_EQ(rig.tick(150).handle, Vec3{}) << "nobody tilts it yet";
    const Vec3 handle = rig.tick(1500).handle;
    EXPECT_NEAR(handle.y, 0.0, 0.02) << seconds;
    EXPECT_NEAR(handle.z, 1.0, 0.01) << seconds;
  }
  Rig still(std::make_unique<SimulatedController>(false, 255, 128, 40, 0, 100.0));
  ASSERT_TRUE(still.open());
  EXPECT_EQ(still.tick(2000).handle, Vec3{}) << "2.4 degrees a second is a hand that is alive";
}

// Reports come every 8 ms, and the wheel ticks every one: no tick may see a step, and what smooths
// them may cost no more than 10 ms.
TEST(HidHand, SlowReportsBecomeSmoothMotionAtMostTenMillisecondsLater) {
  /// A puck that is pushed as far as it goes from its 100th ms on, and says so every `every` ms.
  class Pushed final : public stand_in::SimulatedDevice {
   public:
    explicit Pushed(long every) : every_(every) {}
    HidListing listing() const override { return {"", 0x256f, 0xc635, 1, 8, false, "", ""}; }
    std::optional<stand_in::Bytes> tick() override {
      if (++ms_ % every_ != 0 || ms_ < 100) return std::nullopt;
      if (began == 0) began = ms_;
      return stand_in::Bytes{1, 0x5e, 0x01, 0, 0, 0, 0};
    }
    bool take(const stand_in::Bytes&) override { return true; }
    long began = 0;

   private:
    long every_, ms_ = 0;
  };
  for (const long every : {8L, 16L}) {
    auto owned = std::make_unique<Pushed>(every);
    Pushed& puck = *owned;
    Rig rig(std::move(owned));
    ASSERT_TRUE(rig.open());
    const double speed = rig.link->def().speed;
    double before = rig.tick(50).position.x, step_before = 0.0, roughest = 0.0;
    const double from = before;
    double to = 0.0;
    for (int ms = 51; ms <= 500; ++ms) {
      to = rig.tick().position.x;
      roughest = std::max(roughest, std::fabs((to - before) - step_before));
      step_before = to - before;
      before = to;
    }
    // As far as it would have gone had it had its whole speed at the report's own millisecond.
    const double lag = (500.0 - static_cast<double>(puck.began)) * 1e-3 - (to - from) / speed;
    EXPECT_LE(lag, 0.010) << every;
    EXPECT_GE(lag, 0.0) << every;
    EXPECT_LT(roughest, 0.13 * speed * 1e-3) << "of a whole tick's way, where a step is 1";
    RecordProperty("lag_us", static_cast<int>(lag * 1e6));
  }
}

TEST(HidHand, TheArmStandsWhereItsHandleIsAndItsMotorsPullAsTheClayPushes) {
  auto owned = std::make_unique<SimulatedArm>(stroke({0.065, 0.10, 0.02}, 5000, 0));
  SimulatedArm& arm = *owned;
  Rig rig(std::move(owned));
  DeviceDef def = default_def(DeviceKind::polhem);
  def.stiffness_limit = 800.0;
  ASSERT_TRUE(rig.open(&def));
  const auto track = stroke({0.065, 0.10, 0.02}, 5000, 0);
  HandInput in = rig.tick(300);
  EXPECT_TRUE(in.active) << "moved by somebody";
  // 2000 counts a turn on these capstans are some 0.05 mm at the handle.
  EXPECT_LT(length(in.position - track.at(rig.socket->ms - 1).at), 3e-4);
  rig.tick(700, {2.0, 0.0, 0.0});
  const auto& mA = arm.milliamperes();
  EXPECT_GT(std::abs(mA[0]) + std::abs(mA[1]) + std::abs(mA[2]), 100);
  // The handle moves at 30 mm/s, and a hand feels its tool 1 ms late: 800 N/m times that.
  const Vec3 force = rig.link->status().force;
  EXPECT_NEAR(force.y, 2.0, 0.03) << "studio x is the arm's y";
  EXPECT_EQ(Vec3({force.x, 0.0, force.z}), Vec3{});
  rig.feels = false;
  rig.tick(15);
  EXPECT_EQ(arm.milliamperes(), (std::array<int, 3>{}));
}

TEST(HidHand, AHandlesPlaceIsTheToolsInTheVesselsMeasure) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  Rig rig(std::make_unique<SimulatedHandle>(still(home + Vec3{0.01, 0.02, 0.03}, 10000)));
  DeviceDef def = default_def(DeviceKind::onggi_hid);
  def.scale = 2.0;
  ASSERT_TRUE(rig.open(&def));
  const HandInput in = rig.tick(500);
  EXPECT_TRUE(in.active);
  EXPECT_LT(length(in.position - (home + Vec3{0.02, 0.04, 0.06})), 1e-5);
}

TEST(HidHand, WithTheClutchHeldTheToolStaysUnpushedWhileTheHandleIsMovedBack) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  std::vector<stand_in::TrackPoint> points;
  for (int ms = 0; ms < 5000; ++ms)
    points.push_back({home + Vec3{2e-5 * std::clamp(ms - 1000, 0, 2000), 0.0, 0.0}, true});
  auto owned = std::make_unique<SimulatedHandle>(stand_in::Track(points));
  SimulatedHandle& handle = *owned;
  Rig rig(std::move(owned));
  ASSERT_TRUE(rig.open());
  rig.tick(900, {0.5, 0.0, 0.0});
  rig.tick(100);
  handle.buttons = 1;
  const Vec3 then = rig.tick(5).position;
  const HandInput held = rig.tick(2200, {0.5, 0.0, 0.0});
  EXPECT_TRUE(held.active);
  EXPECT_EQ(held.position, then);
  EXPECT_EQ(rig.link->status().force, Vec3{});
  EXPECT_GT(handle.place().x, 0.039);
  handle.buttons = 0;
  rig.tick(5);
  EXPECT_LT(length(rig.tick(100).position - then), 1e-4) << "it goes on from where it is";
}

/// A handle that presses `deep` into a wall of 2000 N/m, which no device of this list bears.
struct AtAWall : Rig {
  AtAWall(double deep, const DeviceDef& def)
      : Rig(std::make_unique<SimulatedHandle>(stand_in::Track(way(deep)))) {
    EXPECT_TRUE(open(&def));
    for (int ms = 0; ms < 3900; ++ms) {
      link->heartbeat();
      hand_at = hand->read(1e-3).position.x - kHandleHome.x;
      HandFeedback felt;
      felt.contact = hand_at < 0.0;
      felt.touch.push.x = std::max(0.0, -2000.0 * hand_at);
      felt.touch.stiffness = 2000.0;
      hand->feel(felt);
    }
  }
  static std::vector<stand_in::TrackPoint> way(double deep) {
    std::vector<stand_in::TrackPoint> points;
    for (int ms = 0; ms < 4000; ++ms)
      points.push_back(
          {kHandleHome - Vec3{deep / 1500.0 * std::clamp(ms - 1000, 0, 1500), 0.0, 0.0}, true});
    return points;
  }
  SimulatedHandle& handle() { return static_cast<SimulatedHandle&>(*socket->device); }
  double hand_at = 0.0;  ///< The tool's x from the wall.
};

// And where the tool goes farther than the handle, it is the handle that bears no more.
TEST(HidHand, AWallIsNoStifferToTheHandThanItsDeviceBearsAndTheToolStaysAtIt) {
  for (const double scale : {1.0, 2.0}) {
    DeviceDef def = default_def(DeviceKind::onggi_hid);
    def.stiffness_limit = 150.0;
    def.scale = scale;
    AtAWall rig(0.015, def);
    const double pressed = -rig.handle().place().x;
    EXPECT_GT(pressed, 0.01);
    const double coupling = 150.0 / scale, series = coupling * 2000.0 / (coupling + 2000.0);
    const double force = rig.handle().force().x;
    EXPECT_NEAR(force, series * scale * pressed, 0.02 * series * scale * pressed) << scale;
    EXPECT_LE(force, 150.0 * pressed) << scale;
    EXPECT_NEAR(rig.hand_at, -force / 2000.0, 1e-5) << scale;
  }
}

TEST(HidHand, WhoPushesHarderThanTheDeviceCanHoldTakesTheToolAlong) {
  DeviceDef def = default_def(DeviceKind::onggi_hid);
  def.stiffness_limit = 150.0;
  AtAWall rig(0.06, def);
  const double pressed = -rig.handle().place().x, most = rig.link->cap();
  EXPECT_NEAR(rig.handle().force().x, most, 2e-3);
  EXPECT_NEAR(rig.hand_at, most / 150.0 - pressed, 1e-4) << "no farther behind than that stretches";
}

// What a left hand does at the left is what a right hand does at the right, in a mirror.
TEST(HidHand, OfALeftHandedVisitorTheToolGoesTheMirroredWay) {
  DeviceDef def = default_def(DeviceKind::onggi_hid);
  def.middle = {0.03, 0.01, 0.0};
  def.scale = 1.5;
  std::vector<stand_in::TrackPoint> right, left;
  for (int ms = 0; ms < 1500; ++ms) {
    const double t = 1e-3 * ms;
    const Vec3 at{0.02 * std::sin(5.0 * t), 0.01 * std::cos(3.0 * t), 0.015 * std::sin(2.0 * t)};
    const Vec3 home = default_def(DeviceKind::onggi_hid).home;
    right.push_back({home + at, true});
    left.push_back({home + Vec3{-at.x, at.y, at.z}, true});
  }
  Rig one(std::make_unique<SimulatedHandle>(stand_in::Track(right)));
  Rig other(std::make_unique<SimulatedHandle>(stand_in::Track(left)));
  ASSERT_TRUE(one.open(&def));
  ASSERT_TRUE(other.open(&def));
  other.hand = std::make_unique<HidHand>(other.link, true);
  for (int ms = 0; ms < 1400; ++ms) {
    const HandInput a = one.tick(), b = other.tick();
    ASSERT_EQ(a.active, b.active);
    ASSERT_NEAR(a.position.x, -b.position.x, 1e-6) << ms;
    ASSERT_NEAR(a.position.y, b.position.y, 1e-6);
    ASSERT_NEAR(a.position.z, b.position.z, 1e-6);
  }
}

// Mirrored is where the hand works, never which way it moves or is pushed.
TEST(HidHand, OfALeftHandedVisitorAPushToTheRightStaysAPushToTheRight) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  std::vector<stand_in::TrackPoint> track;
  for (int ms = 0; ms < 2000; ++ms)
    track.push_back({home + Vec3{1e-5 * std::clamp(ms - 500, 0, 500), 0.0, 0.0}, true});
  for (const bool left_handed : {false, true}) {
    Rig rig(std::make_unique<SimulatedHandle>(stand_in::Track(track)));
    ASSERT_TRUE(rig.open());
    rig.hand = std::make_unique<HidHand>(rig.link, left_handed);
    const double before = rig.tick(400).position.x;
    const double after = rig.tick(800).position.x;
    EXPECT_NEAR(after - before, 0.005, 1e-4) << left_handed;
    EXPECT_EQ(before > 0.0, !left_handed);
    rig.tick(490, {0.5, 0.0, 0.0});
    EXPECT_GT(rig.link->status().force.x, 0.2) << left_handed;
  }
}

TEST(HidHand, OfALeftHandedVisitorAStickPushedToTheRightGoesToTheRightAndATiltStaysATilt) {
  for (const bool left_handed : {false, true}) {
    auto owned = std::make_unique<SimulatedController>(false, 255, 128, 5000, 200, 0.2);
    Rig rig(std::move(owned));
    ASSERT_TRUE(rig.open());
    rig.hand = std::make_unique<HidHand>(rig.link, left_handed);
    const double before = rig.tick(2).position.x;
    EXPECT_EQ(before > 0.0, !left_handed);
    const HandInput in = rig.tick(500);
    EXPECT_NEAR(in.position.x - before, 0.5 * rig.link->def().speed, 2e-3) << left_handed;
    EXPECT_GT(in.handle.z, 0.1) << "as the hand tilts it, on either side";
  }
}

TEST(HidHand, AVisitorsShareOfTheForceIsWhatTheHandFeelsAndOffIsNothing) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  Rig rig(std::make_unique<SimulatedHandle>(still(home, 10000)));
  DeviceDef def = default_def(DeviceKind::onggi_hid);
  def.stiffness_limit = 800.0;
  ASSERT_TRUE(rig.open(&def));
  rig.tick(700);
  for (const double share : {1.0, 0.5, 0.0, 0.25}) {
    rig.hand->share(share);
    rig.tick(300, {2.0, 0.0, 0.0});
    EXPECT_NEAR(rig.link->status().force.x, 2.0 * share, 0.01) << share;
  }
  rig.hand->share(0.0);
  rig.tick(300, {2.0, 0.0, 0.0});
  EXPECT_EQ(rig.link->status().force, Vec3{});
}

TEST(HidHand, NobodyAtTheHandleIsNoHandAtTheClay) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  Rig rig(std::make_unique<SimulatedHandle>(still(home, 1000)));
  ASSERT_TRUE(rig.open());
  EXPECT_TRUE(rig.tick(500).active);
  rig.tick(490, {0.5, 0.0, 0.0});
  EXPECT_GT(length(rig.link->status().force), 0.2);
  EXPECT_FALSE(rig.tick(20, {0.5, 0.0, 0.0}).active) << "let go";
  EXPECT_EQ(rig.link->status().force, Vec3{});
}

// The link asks for itself, whatever the loop wishes: an arm has no sensor and no firmware that
// would.
TEST(HidHand, AnArmThatNobodyMovedIsNotPushed) {
  auto owned = std::make_unique<SimulatedArm>(still({0.065, 0.10, 0.02}, 5000));
  SimulatedArm& arm = *owned;
  Rig rig(std::move(owned));
  DeviceDef def = default_def(DeviceKind::polhem);
  def.stiffness_limit = 800.0;
  ASSERT_TRUE(rig.open(&def));
  for (std::uint64_t n = 1; n <= 2000; ++n) {
    rig.link->heartbeat();
    ForceRequest wish;
    wish.ticks = n;
    wish.force = n > 1000 ? Vec3{2.0, 0.0, 0.0} : Vec3{};
    wish.contact = true;
    rig.link->wish(wish);
    rig.link->pump(1e-3);
    ASSERT_EQ(arm.milliamperes(), (std::array<int, 3>{})) << n;
  }
}

}  // namespace
}  // namespace onggi::device::hid_hand_test
