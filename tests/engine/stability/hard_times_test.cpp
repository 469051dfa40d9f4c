#include "tests/engine/stability/cases.h"

#include <algorithm>

// Times, speeds and numbers that are none. The printed model stands beside ours where it fails.
namespace onggi::stability::hard_times_test {
namespace {

// A finger that goes up the wall and down again, from outside and from within.
std::vector<Stroke> up_the_wall(int ticks, double wheel_speed) {
  return {stroke({0.061, 0.02, 0.0}, {0.061, 0.18, 0.0}, ticks, wheel_speed),
          stroke({0.016, 0.18, 0.0}, {0.016, 0.02, 0.0}, ticks, wheel_speed)};
}

TEST(HardTimes, TicksOfAnyLength) {
  for (const SceneDef& def : {small(), everything(small())})
    for (const double longest : {0.005, 0.001, 1e-4, 1e-5}) {
      Trial trial{def, 3, up_the_wall(4000, 12.0)};
      for (Stroke& stroke : trial.strokes) stroke.dt = longest, stroke.ragged = true;
      expect_stable(trial);
    }
}

// Row 10 of engine/docs/paper.md: a share is taken each tick, not each second.
TEST(HardTimes, TheSamePressCutIntoOtherTicks) {
  const auto left = [](const SceneDef& def, double dt) {
    Scene scene = std::move(*Scene::create(def));
    Hands hands;
    hands.hand[0] = {{0.061, 0.1, 0.0}, true};
    for (double time = 0.0; time < 0.0199; time += dt) scene.step(hands, dt);
    const auto row = scene.clay().outer(scene.clay().first_row_above(0.1));
    return 0.053 - double{*std::ranges::min_element(row)};  // of the press, negative
  };
  SceneDef def = small(100, 96);
  const auto spread = [&](const SceneDef& of) {
    const double slow = left(of, 0.005);
    return std::fabs(left(of, 0.0005) - slow) / std::fabs(slow);
  };
  EXPECT_LT(spread(def), 0.02);
  EXPECT_GT(spread(printed(def)), 0.5);
}

TEST(HardTimes, TicksThatAreNoTime) {
  std::vector<Stroke> strokes = up_the_wall(200, 12.0);
  for (const double dt : {0.0, -0.0, -1.0, kDenormal, -kDenormal, 1e-300, 1e-30, 1e-9, 9.99e-7,
                          1e300, std::numeric_limits<double>::infinity(), kNan, 0.00500001}) {
    strokes.push_back(stroke({0.061, 0.1, 0.0}, {0.059, 0.11, 0.004}, 20));
    strokes.back().dt = dt;
  }
  expect_stable({small(), 1, strokes});
  expect_stable({everything(small()), 1, strokes});
}

TEST(HardTimes, EverySpeedOfTheWheelBothWays) {
  for (const SceneDef& def : {small(), everything(small())}) {
    std::vector<Stroke> strokes;
    for (const double rpm : {0.0, 1.0, 60.0, 167.0, 168.0, 300.0, 599.0, 600.0})
      for (const double way : {1.0, -1.0})
        strokes.push_back(stroke({0.0615, 0.05, 0.0}, {0.0605, 0.15, 0.0}, 300,
                                 way * rpm * portable::kPi / 30.0));
    expect_stable({def, 1, strokes});
  }
  // Row 16: above a sector a tick the printed model skips elements.
  const auto gaps = [](const SceneDef& def) {
    Scene scene = std::move(*Scene::create(def));
    Hands hands;
    hands.wheel_speed = kFastest;
    for (int n = 0; n < 1000; ++n) scene.step(hands, 0.001);
    hands.hand[0] = {{0.0629, 0.1, 0.0}, true};
    for (int n = 0; n < 12; ++n) scene.step(hands, 0.001);
    const auto row = scene.clay().outer(scene.clay().first_row_above(0.1));
    int left = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t next = (i + 1) % row.size();
      const std::size_t last = (i + row.size() - 1) % row.size();
      left += row[i] == 0.055f && (row[next] < 0.055f) && (row[last] < 0.055f);
    }
    return left;
  };
  SceneDef def = small(100, 360);
  def.wheel.acceleration = 1000.0;
  EXPECT_EQ(gaps(def), 0);
}

TEST(HardTimes, AWheelThatReverses) {
  for (const SceneDef& def : {small(), everything(small())}) {
    std::vector<Stroke> strokes;
    for (int n = 0; n < 40; ++n)
      strokes.push_back(stroke({0.061, 0.1, 0.0}, {0.060, 0.12, 0.0}, 1 + 3 * n,
                               n % 2 == 0 ? kFastest : -kFastest));
    Trial trial{def, 1, strokes};
    trial.def.wheel.acceleration = 1000.0;
    expect_stable(trial);
  }
}

TEST(HardTimes, AHandThatIsNoNumber) {
  std::vector<Stroke> strokes;
  for (const double odd :
       {kNan, -kNan, std::numeric_limits<double>::infinity(), 1e300, -1e300, 11.0}) {
    for (double Vec3::*part : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      strokes.push_back(stroke({0.061, 0.1, 0.0}, {0.061, 0.12, 0.0}, 40));
      strokes.push_back(held({0.061, 0.1, 0.0}, 3));
      strokes.back().hand[0].begins.position.*part = odd;
      strokes.push_back(held({0.061, 0.1, 0.0}, 3));
      strokes.back().hand[0].begins.handle.*part = odd;
    }
    strokes.push_back(held({0.061, 0.1, 0.0}, 3));
    strokes.back().hand[0].begins.roll = odd;
    strokes.push_back(held({0.061, 0.1, 0.0}, 3, odd));
    strokes.push_back(held({0.061, 0.1, 0.0}, 3));
    strokes.back().hand[0].begins.tool = 200;
  }
  expect_stable({small(), 1, strokes});
  expect_stable({everything(small()), 1, strokes});
}

// Row 22: the recursion of its filter keeps a sample that is no number for ever.
TEST(HardTimes, OneBadSampleIsForgottenAndThePrintedModelNeverForgets) {
  const auto recovers = [](const SceneDef& def) {
    Scene scene = std::move(*Scene::create(def));
    Hands hands;
    hands.wheel_speed = 6.0;
    double felt = 0.0;
    for (int n = 0; n < 2000; ++n) {
      hands.hand[0] = {{n == 500 ? 0.0 : 0.0629, 0.1, 0.0}, true};
      scene.clear_faults();
      const Feedback out = scene.step(hands, 0.001);
      if (n > 1500 && (out.faults & kFaultForce) == 0)
        felt = std::max(felt, length(out.hand[0].force));
    }
    return felt > 1e-9;
  };
  SceneDef def = small(100, 96);
  def.contact.relaxation_time = 1.0;
  SceneDef paper = printed(def);
  paper.paper->c_eta = 1000.0;
  EXPECT_TRUE(recovers(def));
  EXPECT_FALSE(recovers(paper));
}

TEST(HardTimes, NumbersSoSmallThatProcessorsStumble) {
  SceneDef def = everything(small());
  def.moisture->drying_time = 1.0;  // wetness falls towards 0 for ever
  std::vector<Stroke> strokes;
  for (const double by : {kDenormal, 1e-310, 1e-200, 1e-40, 1e-12}) {
    strokes.push_back(stroke({0.0630 - 1e-7, 0.1, 0.0}, {0.0630 - 1e-7 - by, 0.1 + by, by}, 300));
    strokes.back().water = true;
    strokes.push_back(stroke({by, 0.1, -by}, {-by, 0.1, by}, 100, by));
    strokes.push_back(Stroke{.ticks = 2000, .dt = 0.005});
  }
  expect_stable({def, 1, strokes});
}

TEST(HardTimes, ADayAtTheWheel) {
  SceneDef def = everything(small(40, 32));
  def.slump->yield_stress = 2e4;  // it stands while nobody looks
  def.clay.keep_undo = true;
  Scene scene = std::move(*Scene::create(def));
  lab::InvariantChecker watch(scene);
  // Each hour a minute of work and a new lump now and then; between, the wheel turns on.
  constexpr double kTick = 0.005;
  constexpr int kHour = 720'000;
  constexpr int kWork = 3000;
  Hands hands;
  for (int hour = 0; hour < 24; ++hour) {
    lab::TrialPlan plan;
    plan.ticks = kWork;
    plan.strokes = 12;
    const Trial work = lab::random_hands(def, static_cast<std::uint64_t>(hour), plan);
    std::optional<Breach> breach;
    work.play([&](const TickRecord& record) {
      const Feedback felt = scene.step(record.hands, record.dt);
      breach = watch.after(scene, record.dt, felt);
      return !breach;
    });
    ASSERT_FALSE(breach) << hour << " h: " << breach->what;
    hands.wheel_speed = hour % 2 == 0 ? 20.0 : -20.0;
    std::uint32_t faults = 0;
    for (int n = 0; n < kHour; ++n) faults |= scene.step(hands, kTick).faults;
    EXPECT_EQ(faults & kFaultForce, 0u);
    watch.resume(scene);
    breach = watch.whole(scene);
    ASSERT_FALSE(breach) << hour << " h: " << breach->what;
  }
  EXPECT_GT(scene.time(), 24 * 3600.0);
}

}  // namespace
}  // namespace onggi::stability::hard_times_test
