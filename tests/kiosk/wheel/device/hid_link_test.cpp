#include "kiosk/wheel/device/hid_link.h"

#include <rapidcheck.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

#include "kiosk/wheel/device/codecs/onggi_hid.h"
#include "kiosk/wheel/device/device_watch.h"
#include "tests/kiosk/wheel/device/rig.h"
#include "tests/stand_in/simulated_others.h"

namespace onggi::device::hid_link_test {
namespace {

using stand_in::Fault;
using stand_in::PlannedFault;
using stand_in::SimulatedHandle;

const Vec3 kHome = default_def(DeviceKind::onggi_hid).home;

DeviceDef measured() {
  DeviceDef def = default_def(DeviceKind::onggi_hid);
  def.stiffness_limit = 800.0;
  return def;
}

/// The reference device with a hand at it that never lets go, armed and engaged after 700 ms.
struct ForceRig : Rig {
  explicit ForceRig(std::vector<PlannedFault> faults = {})
      : Rig(std::make_unique<SimulatedHandle>(still(kHome, 4'000'000)), std::move(faults)),
        handle(static_cast<SimulatedHandle&>(*socket->device)) {
    const DeviceDef def = measured();
    EXPECT_TRUE(open(&def));
  }
  SimulatedHandle& handle;
};

/// The force in an output report, N, and 0 for off.
Vec3 force_in(const stand_in::Bytes& report) {
  return {i16_at(report, 4) * 1e-3, i16_at(report, 6) * 1e-3, i16_at(report, 8) * 1e-3};
}

/// What went out was never above cap or slew, but for the end, which is at once.
void expect_gentle(const std::vector<stand_in::WireRecord>& record, const DeviceDef& def) {
  Vec3 before;
  long at = 0;
  for (const auto& wire : record) {
    if (!wire.out) continue;
    const Vec3 force = force_in(wire.bytes);
    EXPECT_LE(length(force), def.cap() + 1e-9) << wire.at;
    const double most = def.max_slew * 1e-3 * static_cast<double>(std::clamp(wire.at - at, 1L, 5L));
    if (force != Vec3{}) {
      EXPECT_LE(length(force - before), most + 2e-3) << wire.at;
    }
    before = force;
    at = wire.at;
  }
}

TEST(HidLink, ArmsOnlyADeviceThatIsHeldAndBeginsFromNothing) {
  ForceRig rig;
  EXPECT_TRUE(rig.link->status().asks_to_be_held) << "nobody was seen to take it yet";
  rig.tick(5);
  EXPECT_FALSE(rig.link->status().asks_to_be_held);
  rig.tick(600);
  rig.tick(300, {2.0, 0.0, 0.0});
  EXPECT_NEAR(rig.handle.force().x, 2.0, 1e-9);
  EXPECT_NEAR(rig.handle.place().x, 2.0 / 1500.0, 1e-4) << "and the hand gives way as hands do";
  expect_gentle(rig.world.record, rig.link->def());
  // Off begins the count, and arming comes before the first force.
  std::vector<int> modes;
  for (const auto& wire : rig.world.record)
    if (wire.out && (modes.empty() || modes.back() != wire.bytes[1]))
      modes.push_back(wire.bytes[1]);
  EXPECT_EQ(modes, (std::vector<int>{0, 1, 2}));
}

TEST(HidLink, ADeviceWhoseStiffnessNobodyMeasuredGetsOneNewtonAtTheMost) {
  Rig rig(std::make_unique<SimulatedHandle>(still(kHome, 10000)));
  ASSERT_TRUE(rig.open());
  EXPECT_EQ(rig.link->cap(), 1.0);
  rig.tick(700);
  rig.tick(500, {3.0, 0.0, 0.0});
  EXPECT_NEAR(length(rig.link->status().force), 1.0, 2e-3);
}

TEST(HidLink, OfTwoCapsTheSmallerHolds) {
  Rig rig(std::make_unique<SimulatedHandle>(still(kHome, 10000), 800));
  const DeviceDef def = measured();
  ASSERT_TRUE(rig.open(&def));
  EXPECT_DOUBLE_EQ(rig.link->cap(), 0.8);
}

struct OfTheWire {
  Fault fault;
  LinkFault seen;
};

TEST(HidLink, EveryFaultOfTheWireIsZeroForceInTheTickInWhichItIsSeen) {
  for (const OfTheWire& of : {OfTheWire{Fault::stall, LinkFault::stall},
                              {Fault::flip, LinkFault::bad_report},
                              {Fault::shorten, LinkFault::bad_report},
                              {Fault::replay, LinkFault::stall},
                              {Fault::deafen, LinkFault::deaf}}) {
    SCOPED_TRACE(static_cast<int>(of.fault));
    ForceRig rig({{1200, 100, of.fault}});
    rig.tick(700);
    rig.tick(480, {2.0, 0.0, 0.0});
    ASSERT_NEAR(rig.handle.force().x, 2.0, 1e-9);
    // Until the link sees it, tick by tick.
    int ticks = 0;
    while (rig.faults(of.seen) == 0 && ticks < 100) {
      rig.tick(1, {2.0, 0.0, 0.0});
      ++ticks;
    }
    ASSERT_LT(ticks, 60) << "it is never seen";
    EXPECT_EQ(rig.link->status().force, Vec3{});
    if (of.fault != Fault::deafen) {
      EXPECT_EQ(force_in(rig.world.record.back().bytes), Vec3{});
      EXPECT_EQ(rig.handle.force(), Vec3{}) << "off arrived";
    }
    rig.tick(45, {2.0, 0.0, 0.0});
    EXPECT_EQ(rig.handle.force(), Vec3{}) << "and where it could not, the ttl ended it";
    rig.tick(800, {2.0, 0.0, 0.0});
    EXPECT_EQ(rig.link->status().force, Vec3{}) << "deep in the clay nothing comes back";
    rig.tick(50);
    rig.tick(800, {2.0, 0.0, 0.0});
    EXPECT_NEAR(rig.handle.force().x, 2.0, 1.1e-3) << "but once it was clear of it";
    expect_gentle(rig.world.record, rig.link->def());
  }
}

TEST(HidLink, ReportsInTheWrongOrderAreReadOnceAndOldOnesNot) {
  ForceRig rig({{1200, 200, Fault::reorder}});
  rig.tick(1150);
  const auto before = rig.link->status().sample.reports;
  rig.tick(300, {1.0, 0.0, 0.0});
  const auto taken = rig.link->status().sample.reports - before;
  EXPECT_NEAR(static_cast<double>(taken), 200.0, 5.0) << "of each two the newer one";
  expect_gentle(rig.world.record, rig.link->def());
}

TEST(HidLink, FaultsOfTheProgramAreZeroForceToo) {
  struct OfUs {
    LinkFault seen;
    void (*cause)(ForceRig&);
  };
  const OfUs all[] = {
      {LinkFault::not_a_number,
       [](ForceRig& rig) {
         rig.tick(2, {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
       }},
      {LinkFault::stuck_tick,
       [](ForceRig& rig) {
         rig.feels = false;
         rig.tick(12, {2.0, 0.0, 0.0});
         rig.feels = true;
       }},
      {LinkFault::frozen_main,
       [](ForceRig& rig) {
         rig.beats = false;
         rig.tick(502, {2.0, 0.0, 0.0});
         rig.beats = true;
       }},
      {LinkFault::stood_still, [](ForceRig& rig) { rig.hand->read(0.08); }},
  };
  for (const OfUs& of : all) {
    SCOPED_TRACE(static_cast<int>(of.seen));
    ForceRig rig;
    rig.tick(700);
    rig.tick(300, {2.0, 0.0, 0.0});
    ASSERT_NEAR(rig.handle.force().x, 2.0, 1e-9);
    of.cause(rig);
    EXPECT_GE(rig.faults(of.seen), 1u);
    EXPECT_EQ(rig.handle.force(), Vec3{});
    rig.tick(50);
    rig.tick(800, {2.0, 0.0, 0.0});
    EXPECT_NEAR(rig.handle.force().x, 2.0, 1.1e-3);
    expect_gentle(rig.world.record, rig.link->def());
  }
}

TEST(HidLink, AHandleThatIsElsewhereAtOnceIsNotBelieved) {
  std::vector<stand_in::TrackPoint> points(1000, {kHome, true});
  points.push_back({kHome, false});
  points.resize(3000, {kHome + Vec3{0.05, 0, 0}, false});
  for (std::size_t n = 1001; n < points.size(); ++n) points[n].active = n > 1001;
  Rig rig(std::make_unique<SimulatedHandle>(stand_in::Track(points)));
  ASSERT_TRUE(rig.open());
  rig.tick(990);
  rig.tick(30, {1.0, 0.0, 0.0});
  EXPECT_EQ(rig.faults(LinkFault::jump), 1u);
}

TEST(HidLink, AHandleThatRunsAwayIsLetGoOf) {
  // It goes 2 mm each millisecond, from one moment on: no leap is as far as 20 mm.
  std::vector<stand_in::TrackPoint> points(3000, {kHome, true});
  for (std::size_t n = 1000; n < points.size(); ++n)
    points[n] = {
        kHome + Vec3{0.002 * static_cast<double>(std::min<std::size_t>(n - 1000, 40)), 0, 0},
        n == 1000 || n > 1040};
  Rig rig(std::make_unique<SimulatedHandle>(stand_in::Track(points)));
  ASSERT_TRUE(rig.open());
  rig.tick(990);
  EXPECT_EQ(rig.faults(LinkFault::too_fast), 0u);
  rig.tick(30, {1.0, 0.0, 0.0});
  EXPECT_GE(rig.faults(LinkFault::too_fast), 10u);
  EXPECT_EQ(rig.faults(LinkFault::jump), 0u);
  EXPECT_EQ(rig.link->status().force, Vec3{});
}

TEST(HidLink, UnpluggedAtFullForceItsMotorsStopAndTheLinkSaysThatItIsLost) {
  ForceRig rig({{1200, 5000, Fault::unplug}});
  rig.tick(700);
  rig.tick(600, {2.0, 0.0, 0.0});
  EXPECT_TRUE(rig.link->status().sample.lost);
  EXPECT_EQ(rig.link->status().force, Vec3{});
  EXPECT_EQ(rig.handle.force(), Vec3{});
  EXPECT_FALSE(rig.tick().active);
}

TEST(HidLink, TheProgramsEndIsTheForcesEnd) {
  ForceRig rig;
  rig.tick(700);
  rig.tick(300, {2.0, 0.0, 0.0});
  ASSERT_GT(rig.handle.force().x, 1.9);
  rig.hand.reset();
  rig.link.reset();
  EXPECT_EQ(rig.handle.force(), Vec3{});
}

// Ten thousand times at full force: the bytes that went out are looked at one by one.
TEST(HidLink, TenThousandTimesUnpluggedAndPluggedInAgainNoForceIsAboveItsLimits) {
  stand_in::World world;
  world.keeps = true;
  world.away_ms = 20;
  DeviceDef def = measured();
  def.engage_time = 0.05;
  auto& socket = world.plug(std::make_unique<SimulatedHandle>(still(kHome, 100'000'000)));
  auto& handle = static_cast<SimulatedHandle&>(*socket.device);
  DeviceWatch watch(stand_in::bus_of(world), HidLink::Turning::by_hand,
                    [&def](DeviceKind) { return def; });
  double strongest = 0.0;
  std::uint64_t outputs = 0;
  for (int cycle = 0; cycle < 10'000; ++cycle) {
    watch.look();
    auto arrived = watch.arrived();
    ASSERT_EQ(arrived.size(), 1u) << cycle;
    auto link = std::shared_ptr<HidLink>(std::move(arrived[0]));
    HidHand hand(link);
    HandFeedback felt;
    felt.contact = true;
    // Unplugged somewhere on the way up, or at full force.
    const int lives = 40 + cycle * 37 % 160;
    for (int ms = 0; ms < lives; ++ms) {
      felt.force = felt.touch.push = {ms < 20 ? 0.0 : 9.0, ms < 20 ? 0.0 : -3.0, 0.0};
      hand.read(1e-3);
      hand.feel(felt);
      strongest = std::max(strongest, length(handle.force()));
      ASSERT_LE(length(handle.force()), def.cap() + 2e-3);
    }
    socket.faults = {{socket.ms + 1, 30, Fault::unplug}};
    for (int ms = 0; ms < 3; ++ms) {
      hand.read(1e-3);
      hand.feel(felt);
    }
    ASSERT_EQ(handle.force(), Vec3{}) << cycle;
    ASSERT_TRUE(link->status().sample.lost);
    expect_gentle(world.record, def);
    for (const auto& wire : world.record) outputs += wire.out ? 1 : 0;
    if (::testing::Test::HasFailure()) return;
    world.record.clear();
    watch.gone(socket.path);
    watch.look();  // It is away: nothing comes,
    ASSERT_TRUE(watch.arrived().empty()) << cycle;
  }
  EXPECT_GT(strongest, 2.9);
  EXPECT_GT(outputs, 500'000u);
}

TEST(DeviceWatch, TwoHandsAndADialComeAtOnceAndWhatGoesComesAgain) {
  stand_in::World world;
  world.clock = stand_in::World::Clock::real;
  world.plug(std::make_unique<SimulatedHandle>(still(kHome, 100000)));
  world.plug(std::make_unique<SimulatedHandle>(still(kHome, 100000)), {{300, 1500, Fault::unplug}});
  world.plug(std::make_unique<stand_in::SimulatedDial>(300));
  DeviceWatch watch(stand_in::bus_of(world), HidLink::Turning::by_thread,
                    [](DeviceKind) { return measured(); });
  std::vector<std::unique_ptr<HidLink>> links;
  int came = 0, lost = 0;
  for (int n = 0; n < 600 && (came < 4 || lost < 1); ++n) {
    for (auto& link : watch.arrived()) {
      ++came;
      links.push_back(std::move(link));
    }
    std::erase_if(links, [&](const auto& link) {
      link->heartbeat();
      if (!link->status().sample.lost) return false;
      ++lost;
      watch.gone(link->listing().path);
      return true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(came, 4);
  EXPECT_EQ(lost, 1);
  for (const auto& link : links) {
    for (int n = 0; n < 1000 && link->status().sample.reports <= 10; ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_GT(link->status().sample.reports, 10u) << link->listing().name;
  }
  EXPECT_TRUE(watch.problems().empty());
}

TEST(DeviceWatch, ADeviceThatDoesNotAnswerAsOneIsToldOfOnceWithWhatToDo) {
  class Mute final : public stand_in::SimulatedDevice {
   public:
    HidListing listing() const override {
      return {"", 0x16c0, 0x27d9, 0xff00, 1, false, "Mute", ""};
    }
    std::optional<stand_in::Bytes> tick() override { return std::nullopt; }
    bool take(const stand_in::Bytes&) override { return true; }
  };
  stand_in::World world;
  world.plug(std::make_unique<Mute>());
  DeviceWatch watch(stand_in::bus_of(world), HidLink::Turning::by_hand, default_def);
  watch.look();
  watch.look();
  EXPECT_TRUE(watch.arrived().empty());
  const auto problems = watch.problems();
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].what.find("does not answer"), std::string::npos);
}

}  // namespace
}  // namespace onggi::device::hid_link_test
