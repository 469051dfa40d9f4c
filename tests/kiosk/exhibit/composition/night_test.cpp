#include "kiosk/exhibit/composition/night.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "tests/kiosk/exhibit/composition/one_jar.h"

namespace onggi::exhibit::night_test {
namespace {

settings::Hours daily() {
  settings::Hours hours;
  hours.kept = true;
  hours.week.fill({{600, 1080}});
  return hours;
}

files::LocalMoment clock(int hour, int minute = 0, int year = 2026) {
  return {year, 5, 4, 60 * hour + minute};
}

TEST(Night, ClosingTimeWaitsForTheVisitorWhoIsHere) {
  Night night(daily());
  EXPECT_FALSE(night.look(0, clock(17, 59), true, false));
  EXPECT_FALSE(night.look(60, clock(18, 0), false, true)) << "somebody throws";
  EXPECT_FALSE(night.look(1000, clock(18, 20), false, false));
  EXPECT_TRUE(night.look(1001, clock(18, 20), true, false)) << "and has gone";
  EXPECT_FALSE(night.look(50'000, clock(10), true, false)) << "it comes back by itself";
}

TEST(Night, ATouchWakesItForAWhileWhateverTheClockOnTheWallDoes) {
  Night night(daily());
  EXPECT_TRUE(night.look(0, clock(23), true, false));
  EXPECT_FALSE(night.look(1, clock(23), true, true));
  EXPECT_FALSE(night.look(Night::kAwake, clock(23), true, false));
  // Put back by an hour meanwhile, and by ten years: waits go by the other clock.
  EXPECT_TRUE(night.look(Night::kAwake + 2, clock(22), true, false));
  EXPECT_FALSE(night.look(Night::kAwake + 3, clock(23, 0, 2016), true, false))
      << "a clock that is years behind closes no museum";
  EXPECT_TRUE(night.look(Night::kAwake + 4, clock(23), true, false));
}

// Shown by the real kiosk: the wall's clock is the test's.
class DarkKiosk : public OneJar {
 protected:
  void SetUp() override { open_by_day(); }
  void open_by_day() {
    KioskOptions options;
    options.window = {.width = 960, .height = 540, .visible = false, .title = "Onggi tests"};
    options.wall = [this] { return wall_; };
    open("first_touch", "", options, "[hours]\nevery_day = \"10:00-18:00\"\n");
  }
  void frame(double seconds) { kiosk_->frame(now_ += seconds); }
  /// The moment of an hour of 2026-05-04 here.
  static std::time_t at(int hour) {
    std::tm local{};
    local.tm_year = 126, local.tm_mon = 4, local.tm_mday = 4, local.tm_hour = hour;
    local.tm_isdst = -1;
    return std::mktime(&local);
  }

  std::time_t wall_ = at(12);
};

/// One that is switched on at night.
class NightKiosk : public DarkKiosk {
 protected:
  void SetUp() override {}
};

TEST_F(NightKiosk, OfADiskThatRefusesToCountVisitsTheLogTellsAtOnceAndNotInTheMorning) {
  wall_ = at(23);
  counted_ = true;
  std::filesystem::create_directories(folder_ / "kept/onggi.sqlite/in/the/way");
  testing::internal::CaptureStderr();
  open_by_day();
  for (int n = 0; n < 20; ++n) frame(0.1);
  const std::string log = testing::internal::GetCapturedStderr();
  if (IsSkipped()) return;
  ASSERT_TRUE(kiosk_->doing().dark);
  EXPECT_NE(log.find("onggi.sqlite"), std::string::npos) << log;
}

// A device's thread lets go of its force when the frames stand still, so that it must be looked
// after in the dark, too; and what is done to it wakes the screen.
TEST_F(NightKiosk, InTheDarkHandDevicesAreLookedAfterInEachFrame) {
  pucks_ = 1;
  wall_ = at(12);
  open_by_day();
  if (IsSkipped()) return;
  wall_ = at(19);
  // Its thread takes its turns when the machine lets it, and finding the device wakes the screen.
  const auto until = [&](const auto& done) {
    for (int n = 0; n < 300 && !done(); ++n) {
      frame(10);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return done();
  };
  ASSERT_TRUE(
      until([&] { return kiosk_->doing().dark && kiosk_->doing().device_moves.value_or(0) > 0; }));
  const auto before = kiosk_->doing().device_moves;
  EXPECT_TRUE(until([&] { return kiosk_->doing().device_moves > before; }));
  EXPECT_TRUE(kiosk_->doing().dark);
}

/// A hand is on its puck's first button, or not.
class PressedKiosk : public NightKiosk {
 protected:
  struct Puck final : device::HidPort {
    explicit Puck(const std::atomic<bool>& held) : held_(held) {}
    int read(std::span<std::uint8_t> report, int timeout_ms) noexcept override {
      std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
      if (down_ == held_) return 0;
      down_ = !down_;
      report[0] = 3;
      report[1] = down_ ? 1 : 0;
      return 2;
    }
    bool write(device::Report) noexcept override { return true; }
    int feature(std::uint8_t, std::span<std::uint8_t>) noexcept override { return -1; }
    const std::atomic<bool>& held_;
    bool down_ = false;
  };
  struct Hub final : device::HidBus {
    explicit Hub(const std::atomic<bool>& held) : held_(held) {}
    std::vector<device::HidListing> list() override { return Bus(1).list(); }
    std::unique_ptr<device::HidPort> open(const std::string&) override {
      return std::make_unique<Puck>(held_);
    }
    const std::atomic<bool>& held_;
  };
  std::unique_ptr<device::HidBus> plugged() override { return std::make_unique<Hub>(held_); }
  /// Makes frames until `done`, as its thread gets its turns.
  template <class Done>
  bool until(double seconds, const Done& done) {
    for (int n = 0; n < 300 && !done(); ++n) {
      frame(seconds);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return done();
  }
  std::atomic<bool> held_{false};
};

// Guards `look_after_devices(now)` before update_night(), and the dark frame's return before the
// input: a device wakes the screen too, and what was pressed in the dark was not seen.
TEST_F(PressedKiosk, AButtonOfADeviceWakesTheScreenAndChoosesNothing) {
  open_by_day();
  if (IsSkipped()) return;
  wall_ = at(19);
  ASSERT_TRUE(until(
      1, [&] { return kiosk_->doing().dark && kiosk_->doing().device_moves.value_or(0) > 0; }));
  held_ = true;
  ASSERT_TRUE(until(0.01, [&] { return !kiosk_->doing().dark; }));
  held_ = false;
  for (int n = 0; n < 10; ++n) frame(0.05);
  EXPECT_EQ(kiosk_->visit().screen(), screens::ScreenId::attract);
  held_ = true;
  EXPECT_TRUE(until(0.01, [&] { return kiosk_->visit().screen() != screens::ScreenId::attract; }))
      << "the next one is meant";
}

int brightest(const view::Image& image) {
  int most = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) most = std::max<int>(most, image.rgba[i]);
  return most;
}

TEST_F(DarkKiosk, AtNightEveryPixelIsBlackTheClayRestsAndTheMorningFindsItAsItWas) {
  frame(1);
  EXPECT_GT(brightest(kiosk_->picture()), 150);
  wall_ = at(19);
  frame(1);
  ASSERT_TRUE(kiosk_->doing().dark);
  EXPECT_EQ(brightest(kiosk_->picture()), 0);
  ASSERT_TRUE(kiosk_->wheel_host().refresh_every_row());
  const auto ticks = kiosk_->wheel_host().status().ticks;
  const auto wakes = kiosk_->wheel_host().status().deadlines.wakes;
  for (int n = 0; n < 4; ++n) frame(3600);
  EXPECT_EQ(kiosk_->wheel_host().status().ticks, ticks) << "no clay is thrown for nobody";
  EXPECT_GT(kiosk_->wheel_host().status().deadlines.wakes, wakes) << "but the loop lives";
  wall_ = at(10);
  frame(1);
  frame(0.1);
  EXPECT_FALSE(kiosk_->doing().dark);
  EXPECT_GT(brightest(kiosk_->picture()), 150);
}

/// Where a pixel differs from the one beside or below it as print does from paper.
std::vector<bool> edges(const view::Image& image) {
  const auto w = static_cast<std::size_t>(image.width), h = static_cast<std::size_t>(image.height);
  const auto light = [&](std::size_t x, std::size_t y) {
    const std::uint8_t* p = &image.rgba[4 * (y * w + x)];
    return (p[0] + 2 * p[1] + p[2]) / 4;
  };
  std::vector<bool> edge(w * h);
  for (std::size_t y = 0; y + 1 < h; ++y)
    for (std::size_t x = 0; x + 1 < w; ++x)
      edge[y * w + x] = std::abs(light(x, y) - light(x + 1, y)) > 40 ||
                        std::abs(light(x, y) - light(x, y + 1)) > 40;
  return edge;
}

// An attract that nobody interrupts, over an afternoon: what stands longest in one place.
TEST_F(DarkKiosk, NothingWithAnEdgeStandsInOnePlaceForHours) {
  std::vector<int> times;
  long first = 0;
  constexpr int kFrames = 10;
  for (int n = 0; n < kFrames; ++n) {
    frame(n == 0 ? 0.1 : 900);
    const std::vector<bool> edge = edges(kiosk_->picture());
    times.resize(edge.size());
    for (std::size_t i = 0; i < edge.size(); ++i) times[i] += edge[i] ? 1 : 0;
    if (n == 0) first = std::count(edge.begin(), edge.end(), true);
  }
  ASSERT_GT(first, 2000) << "there are words";
  const auto stand = std::count(times.begin(), times.end(), kFrames);
  EXPECT_LT(stand, first / 100) << stand << " of " << first;
}

}  // namespace
}  // namespace onggi::exhibit::night_test
