#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/kiosk/exhibit/composition/one_jar.h"

namespace onggi::exhibit::sound_order_test {
namespace {

using screens::ScreenId;

/// A kiosk on the clock, with a kiln, opening hours, and a sound card that writes a file.
class HeardKiosk : public OneJar {
 protected:
  void SetUp() override {
    ::setenv("SDL_AUDIODRIVER", "disk", 1);
    ::setenv("SDL_DISKAUDIOFILE", (folder_ / "played").c_str(), 1);
    KioskOptions options;
    options.window = {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"};
    options.wall = [this] { return wall_; };
    open("studio", "turning = false\n", options,
         "[hours]\nevery_day = \"10:00-18:00\"\n[sound]\nvolume = 1.0\n");
  }
  void TearDown() override {
    OneJar::TearDown();
    for (const char* name : {"SDL_AUDIODRIVER", "SDL_DISKAUDIOFILE"}) ::unsetenv(name);
  }
  void frame() {
    kiosk_->frame(now_ += 0.02, false);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  void press(const std::string& control) {
    for (int n = 0; n < 5000 && !kiosk_->visit().control(control); ++n) frame();
    ASSERT_TRUE(kiosk_->visit().control(control)) << control;
    kiosk_->visit().activate(control, now_);
    frame();
  }
  static std::time_t at(int hour) {
    std::tm local{};
    local.tm_year = 126, local.tm_mon = 4, local.tm_mday = 4, local.tm_hour = hour;
    local.tm_isdst = -1;
    return std::mktime(&local);
  }
  std::vector<float> played() const {
    const std::string bytes = commands::content(folder_ / "played");
    std::vector<float> out(bytes.size() / sizeof(float));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(float));
    return out;
  }
  /// The loudest of the last quarter of a second, once two more seconds have been played.
  float loudness() {
    const std::size_t before = played().size();
    std::vector<float> sound;
    for (int n = 0; n < 20'000; ++n) {
      frame();
      if (n % 50 == 0 && (sound = played()).size() > before + 2 * 48'000) break;
    }
    EXPECT_GT(sound.size(), before + 2 * 48'000) << "the card plays";
    float loudest = 0;
    for (std::size_t n = sound.size() - 12'000; n < sound.size(); ++n)
      loudest = std::max(loudest, std::abs(sound[n]));
    return loudest;
  }
  std::time_t wall_ = at(12);
};

// Guards `sound_->frame(...)` before the dark frame's return: the last frame of the day had a kiln
// on the screen, and nothing else would tell the card that it burns no more.
TEST_F(HeardKiosk, AKilnThatBurnsAtClosingTimeIsSilentInTheDark) {
  press("attract.begin");
  press("choose.card.0");
  press("choose.throw");
  for (int n = 0; n < 5000 && !kiosk_->visit().sight(); ++n) frame();
  for (int n = 0; n < 100; ++n) frame();
  press("throw.show");  // there must be a pot to call done
  const auto touched = [&] { return kiosk_->wheel_host().status().feedback.hand[0].contact; };
  for (int n = 0; n < 5000 && !touched(); ++n) frame();
  frame();
  press("throw.done");
  press("result.keep");
  ASSERT_EQ(kiosk_->visit().screen(), ScreenId::kiln);
  EXPECT_GT(loudness(), 5e-3f);
  ASSERT_EQ(kiosk_->visit().screen(), ScreenId::kiln);
  kiosk_->visit().close(now_);  // its visitor leaves at once
  wall_ = at(19);
  frame();
  ASSERT_TRUE(kiosk_->doing().dark);
  EXPECT_LT(loudness(), 1e-4f);
}

}  // namespace
}  // namespace onggi::exhibit::sound_order_test
