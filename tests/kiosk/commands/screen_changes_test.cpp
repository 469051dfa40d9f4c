#include <gtest/gtest.h>

#include "tests/kiosk/commands/bare_screen.h"

namespace onggi::commands {
namespace {

constexpr double kSoon = 5.0;  // s, that a museum would wait

/// To the pixel beside it.
void expect_at(std::pair<int, int> is, int x, int y, const std::string& why) {
  EXPECT_NEAR(is.first, x, 1) << why;
  EXPECT_NEAR(is.second, y, 1) << why;
}

TEST(ScreenChanges, APictureFillsTheMonitorThatIsThereAndAFingerFallsWhereItTouches) {
  const TemporaryFolder folder;
  const auto screen = BareScreen::start();
  if (!screen) GTEST_SKIP() << "no Xorg with a dummy screen could be started";
  const std::string log = (folder / "log").string(),
                    exhibit = write_exhibit(folder, "first_touch", "");
  // As after a start without a monitor that is plugged in then: X itself lights none.
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --off"));
  auto kiosk = run_on(*screen, "--config " + exhibit, log);
  ASSERT_TRUE(kiosk);
  EXPECT_TRUE(screen->window_becomes("640x480+0+0", kSoon)) << screen->window();
  EXPECT_NE(text_of(log).find("it shows 640 x 480"), std::string::npos) << text_of(log);

  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --mode 800x600"));
  EXPECT_TRUE(screen->window_becomes("800x600+0+0", kSoon)) << screen->window();
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --off"));
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  EXPECT_EQ(screen->text("xrandr").find('*'), std::string::npos)
      << "what a script switched off stays off";
  ASSERT_TRUE(screen->xrandr("--output DUMMY0 --mode 640x480"));
  EXPECT_TRUE(screen->window_becomes("640x480+0+0", kSoon)) << screen->window();

  // A screen of X larger than the monitor: a second one lay beside it.
  expect_at(screen->touch(0.5, 0.25), 320, 120, text_of(log));
  ASSERT_TRUE(screen->xrandr("--fb 1280x960"));
  expect_at(screen->touch(0.5, 0.25), 640, 240, "X alone spreads the glass over all of it");
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  expect_at(screen->touch(0.75, 0.25), 480, 120, text_of(log));
  EXPECT_EQ(screen->window(), "640x480+0+0");
  kiosk->end(SIGTERM);
  EXPECT_EQ(kiosk->status(), 0) << text_of(log);
}

}  // namespace
}  // namespace onggi::commands
