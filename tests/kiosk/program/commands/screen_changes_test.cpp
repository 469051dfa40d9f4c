#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "kiosk/picture/render/window.h"
#include "tests/kiosk/program/commands/bare_screen.h"

namespace onggi::commands::screen_changes_test {
namespace {

constexpr double kSoon = 5.0;  // s, that a museum would wait

/// To the pixel beside it.
void expect_at(std::pair<int, int> is, int x, int y, const std::string& why) {
  EXPECT_NEAR(is.first, x, 1) << why;
  EXPECT_NEAR(is.second, y, 1) << why;
}

TEST(ScreenChanges, APictureFillsTheMonitorThatIsThereAndAFingerFallsWhereItTouches) {
  const ScratchFolder folder;
  const auto screen = BareScreen::start();
  if (!screen) GTEST_SKIP() << "no Xorg with a dummy screen could be started";
  const std::string log = (folder / "log").string(),
                    exhibit = write_exhibit(folder, "first_touch", "");
  // As after a start without a monitor that is plugged in then: X itself lights none.
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --off"));
  auto kiosk = run_on(*screen, "--config " + exhibit, log);
  ASSERT_TRUE(kiosk);
  EXPECT_TRUE(screen->window_becomes("640x480+0+0", kSoon)) << screen->window();
  EXPECT_NE(content(log).find("it shows 640 x 480"), std::string::npos) << content(log);

  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --mode 800x600"));
  EXPECT_TRUE(screen->window_becomes("800x600+0+0", kSoon)) << screen->window();
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --off"));
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  EXPECT_EQ(screen->text("xrandr").find('*'), std::string::npos)
      << "what a script switched off stays off";
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --mode 640x480"));
  EXPECT_TRUE(screen->window_becomes("640x480+0+0", kSoon)) << screen->window();

  // A screen of X larger than the monitor: a second one lay beside it.
  expect_at(screen->touch(0.5, 0.25), 320, 120, content(log));
  ASSERT_TRUE(screen->xrandr("--fb 1280x960"));
  expect_at(screen->touch(0.5, 0.25), 640, 240, "X alone spreads the glass over all of it");
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  expect_at(screen->touch(0.75, 0.25), 480, 120, content(log));
  EXPECT_EQ(screen->window(), "640x480+0+0");
  kiosk->end(SIGTERM);
  EXPECT_EQ(kiosk->status(), 0) << content(log);
}

/// What reaches the screens of fingers on the glass.
class Glass {
 public:
  explicit Glass(render::Window& window) : window_(window) {}
  /// The last that is heard of a finger comes to be this, soon.
  bool hears(view::InputEvent::Kind kind, std::uint8_t finger, float x, float y) {
    for (int n = 0; n < 500; ++n) {
      for (const view::InputEvent& event : window_.poll())
        if (event.glass) last_.at(event.finger) = event;
      const view::InputEvent& last = last_.at(finger);
      if (last.glass && last.kind == kind && std::hypot(last.x - x, last.y - y) < 1.5f) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

 private:
  render::Window& window_;
  std::array<view::InputEvent, 10> last_;
};

TEST(ScreenChanges, TwoFingersOnTheGlassAreTwoHandsAndTheOneThatStaysIsNotLetGo) {
  using Kind = view::InputEvent::Kind;
  const auto screen = BareScreen::start();
  if (!screen) GTEST_SKIP() << "no Xorg with a dummy screen could be started";
  setenv("DISPLAY", screen->display().c_str(), 1);
  auto window = render::Window::create({.width = 640, .height = 480});
  ASSERT_TRUE(window);
  EXPECT_EQ((*window)->fingers(), 10);
  Glass glass(**window);
  screen->put(1, 0.25, 0.5);
  EXPECT_TRUE(glass.hears(Kind::pointer_down, 0, 160, 240));
  screen->put(2, 0.75, 0.5);
  EXPECT_TRUE(glass.hears(Kind::pointer_down, 1, 480, 240));
  for (int n = 1; n <= 20; ++n) {
    screen->move(1, 0.25 + 0.005 * n, 0.5 - 0.01 * n);
    screen->move(2, 0.75 - 0.005 * n, 0.5 - 0.01 * n);
  }
  EXPECT_TRUE(glass.hears(Kind::pointer_move, 0, 224, 144));
  EXPECT_TRUE(glass.hears(Kind::pointer_move, 1, 416, 144));
  screen->lift(1, 0.35, 0.3);
  EXPECT_TRUE(glass.hears(Kind::pointer_up, 0, 224, 144));
  screen->move(2, 0.5, 0.5);
  EXPECT_TRUE(glass.hears(Kind::pointer_move, 1, 320, 240));
  screen->put(3, 0.1, 0.1);
  EXPECT_TRUE(glass.hears(Kind::pointer_down, 0, 64, 48)) << "whoever comes takes the free place";
  screen->lift(2, 0.5, 0.5);
  EXPECT_TRUE(glass.hears(Kind::pointer_up, 1, 320, 240));
  screen->lift(3, 0.1, 0.1);
  EXPECT_TRUE(glass.hears(Kind::pointer_up, 0, 64, 48));
}

/// The largest byte of what the screen shows, alpha aside.
int brightest(const BareScreen& screen) {
  const std::string dump = screen.text("xwd -root -silent");
  if (dump.size() < 100) return -1;
  const auto word = [&](std::size_t n) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<std::uint8_t>(dump[4 * n + i]);
    return static_cast<std::size_t>(value);
  };
  int most = 0;
  for (std::size_t i = word(0) + 12 * word(19); i < dump.size(); ++i)
    if (i % 4 != (word(0) + 3) % 4) most = std::max<int>(most, static_cast<std::uint8_t>(dump[i]));
  return most;
}

bool comes(const std::string& log, const std::string& line) {
  for (int n = 0; n < 100 && content(log).find(line) == std::string::npos; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  return content(log).find(line) != std::string::npos;
}

TEST(ScreenChanges, AKioskThatIsClosedIsBlackAndATouchWakesIt) {
  const ScratchFolder folder;
  const auto screen = BareScreen::start();
  if (!screen) GTEST_SKIP() << "no Xorg with a dummy screen could be started";
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --mode 640x480"));
  const std::string log = (folder / "log").string(),
                    exhibit = write_exhibit(folder, "first_touch",
                                            "[store]\ncount = false\n[hours]\nevery_day = "
                                            "\"closed\"\n");
  auto kiosk = run_on(*screen, "--config " + exhibit, log);
  ASSERT_TRUE(kiosk);
  ASSERT_TRUE(comes(log, "The museum is closed")) << content(log);
  EXPECT_EQ(brightest(*screen), 0);
  screen->touch(0.5, 0.5);
  ASSERT_TRUE(comes(log, "The screen is on again.")) << content(log);
  int light = 0;
  for (int n = 0; n < 50 && light <= 150; ++n) light = brightest(*screen);
  EXPECT_GT(light, 150);
  kiosk->end(SIGTERM);
  EXPECT_EQ(kiosk->status(), 0) << content(log);
}

}  // namespace
}  // namespace onggi::commands::screen_changes_test
