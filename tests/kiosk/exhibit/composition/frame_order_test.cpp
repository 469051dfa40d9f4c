#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "tests/kiosk/exhibit/composition/watched_renderer.h"
#include "tests/kiosk/exhibit/composition/whole_kiosk.h"
#include "tests/kiosk/program/commands/doomed_server.h"

// The order of Kiosk's parts within a frame, at its opening and at its end. Each test names the
// line whose move it guards; each was seen red with that line moved. Other orders have their tests
// where their parts have theirs: the counts and the end of a visit in kiosk_test.cpp, the dark
// frame in night_test.cpp, its sound in sound_order_test.cpp.

namespace onggi::exhibit::frame_order_test {
namespace {

using screens::ScreenId;
using view::InputEvent;

/// A stepped kiosk whose renderer is watched.
class FrameOrder : public WholeKiosk {
 protected:
  void change(KioskOptions& options) override {
    options.renderer =
        [this](const render::WindowOptions& window) -> Result<std::unique_ptr<render::Renderer>> {
      if (window.opening) opening_ = window.opening(640, 360);
      auto real = render::Renderer::create(window);
      if (!real) return tl::unexpected(real.error());
      return std::make_unique<test::WatchedRenderer>(std::move(*real), watch_);
    };
  }
  /// A finger that touches the middle of the screen and lifts, in the next frame.
  void touch() {
    for (const auto kind : {InputEvent::Kind::pointer_down, InputEvent::Kind::pointer_up})
      watch_.input.push_back({.kind = kind, .x = 320, .y = 180, .glass = true});
  }
  static std::set<view::PictureId> pictures_on(const view::Frame& frame) {
    std::set<view::PictureId> ids;
    for (const view::Item& item : frame.items)
      if (const auto* picture = std::get_if<view::Picture>(&item)) ids.insert(picture->id);
    return ids;
  }

  test::Watch watch_;
  view::Frame opening_;  ///< What the window may show before its shaders are compiled.
};

// Guards read_settings() before the window: its words are there before the first picture is.
TEST_F(FrameOrder, TheWindowHasWordsFromTheStart) {
  ASSERT_EQ(opening_.items.size(), 1u);
  const auto& text = std::get<view::Text>(opening_.items.front());
  EXPECT_EQ(text.text, "Getting the vessels ready.");
  EXPECT_EQ(text.box.w, 640);
  EXPECT_FALSE(opening_.pot) << "only the words' shader is there";
}

// Guards `wheel_host_->collect()` before `renderer_->update_clay(...)`, and that nothing collects
// again until the frame is drawn: the clay on the glass, what the screens say of it and a postcard
// would be of different ticks.
TEST_F(FrameOrder, TheGlassShowsTheClayOfTheTickThatTheScreensSpeakOf) {
  press("attract.begin");
  press("choose.card.0");
  press("choose.throw");
  until([&] { return kiosk_->visit().sight().has_value(); });
  const auto on_the_wheel = [&] {
    std::uint64_t ticks = 0;
    EXPECT_TRUE(kiosk_->wheel_host().with_scene([&](Scene& s) { ticks = s.counters().ticks; }));
    return ticks;
  };
  const auto seen = [&] { return kiosk_->wheel_host().view().status.ticks; };
  std::uint64_t newest = 0, uploaded = 0;
  int drawn = 0;
  watch_.called = [&](const char* call) {
    if (std::string(call) != "update_clay") return;
    uploaded = seen();
    EXPECT_EQ(uploaded, newest) << "what the wheel has come to is collected first";
    kiosk_->advance(3);  // The real wheel goes on while a frame is made.
  };
  watch_.drawn = [&](const view::Frame&) {
    EXPECT_EQ(seen(), uploaded) << "and nothing newer until it is drawn";
    ++drawn;
  };
  for (int n = 0; n < 10; ++n) {
    kiosk_->advance(40);
    newest = on_the_wheel();
    kiosk_->frame(now_ += 0.04, true);
  }
  watch_.called = {};
  EXPECT_EQ(drawn, 10);
}

// Guards `renderer_->update_clay(...)` before `keeping_->draw_keepsake(...)`, which draws a
// postcard of the clay that the renderer has, and before `keeping_->draw_turning(...)`.
TEST_F(FrameOrder, APostcardAndAPictureThatTurnsAreDrawnOfThisFramesClay) {
  bool uploaded = false;
  int postcards = 0, turning = 0;
  watch_.called = [&](const char* call) {
    if (std::string(call) == "update_clay") uploaded = true;
  };
  watch_.drawn_offscreen = [&](const view::Frame& frame) {
    ++(frame.width == TurntableRecorder::kSide ? turning : postcards);
    EXPECT_TRUE(uploaded) << frame.width << " x " << frame.height;
  };
  const auto fresh_frame = [&] {
    uploaded = false;
    frame();
    return turning >= 3;
  };
  ask_to_keep_a_pot(false, [&] { uploaded = false; });
  until(fresh_frame);
  EXPECT_GT(postcards, 0);
}

// Guards `keeping_->draw_keepsake(...)` before `visit_->frame(...)`: the screen shows the picture
// that it makes. Until then the screen before it still covers most of the page.
TEST_F(FrameOrder, APostcardIsOnTheScreenInTheFrameInWhichItIsMade) {
  ask_to_keep_a_pot(false, [&] { watch_.made = 0; });
  for (int n = 0; n < 5 && watch_.made == 0; ++n) frame();  // Words, room, room, card.
  ASSERT_NE(watch_.made, 0u) << "a postcard was made in the last frame";
  EXPECT_TRUE(pictures_on(kiosk_->shown()).contains(watch_.made));
  EXPECT_GT(kiosk_->shown().fade, 0.5f);
}

// Guards `keeping_->draw_turning(last_frame_)` after `visit_->frame(...)`: with the frame before it
// would draw, which takes long, while screens fade.
TEST_F(FrameOrder, NoPictureThatTurnsIsDrawnWhileScreensFade) {
  ask_to_keep_a_pot(false);
  int turning = 0, fading = 0;
  bool drew = false;
  watch_.drawn_offscreen = [&](const view::Frame& frame) {
    drew = drew || frame.width == TurntableRecorder::kSide;
  };
  const auto look = [&](int frames) {
    for (int n = 0; n < frames; ++n) {
      drew = false;
      frame();
      fading += kiosk_->shown().fade > 0 ? 1 : 0;
      turning += drew ? 1 : 0;
      EXPECT_FALSE(drew && kiosk_->shown().fade > 0) << "frame " << n;
    }
  };
  until([&] { return frame(), drew || kiosk_->shown().fade <= 0; });
  look(5);
  for (const char* control : {"comfort", "comfort.close", "comfort"}) {
    kiosk_->visit().activate(control, now_);
    look(4);
  }
  EXPECT_GT(turning, 0);
  EXPECT_GT(fading, 0);
}

// Guards `access_input_->frame(...)` after `visit_->frame(...)`, whose frame it adds to, and before
// `renderer_->draw(last_frame_)`.
TEST_F(FrameOrder, TheRingOfTheOneSwitchIsOnTheGlassInEveryFrame) {
  press("attract.begin");
  press("comfort");
  press("comfort.one_switch");
  press("comfort.close");
  int rings = 0;
  watch_.drawn = [&](const view::Frame& frame) {
    const auto* last = frame.items.empty() ? nullptr : std::get_if<view::Box>(&frame.items.back());
    rings += last != nullptr && last->fill.a == 0 && last->border > 0 ? 1 : 0;
  };
  for (int n = 0; n < 10; ++n) kiosk_->frame(now_ += 0.04, true);
  EXPECT_EQ(rings, 10);
}

// Guards `sound_->sing(...)` after `access_input_->frame(...)`, which says whether a song is due:
// sung a frame later, the visitor may have left the wheel, and with it the outline to sing.
TEST_F(FrameOrder, ASongThatFallsDueIsSungInItsFrame) {
  press("attract.begin");
  press("comfort");
  press("comfort.spoken");
  press("comfort.close");
  press("choose.card.0");
  press("choose.throw");
  until([&] { return kiosk_->visit().control("throw.tell").has_value(); });
  constexpr int kFrames = 1500;  // a minute: what is told at the wheel is told by then
  // First by hand: a song does fall due when it is asked for.
  kiosk_->visit().activate("throw.tell", now_);
  bool due = false;
  for (int n = 0; n < kFrames && !due; ++n) {
    view::Frame shown = kiosk_->visit().frame(640, 360);
    kiosk_->access_input().frame(kiosk_->visit(), shown, now_ += 0.04);
    due = kiosk_->access_input().sings();
  }
  ASSERT_TRUE(due);
  kiosk_->visit().activate("throw.tell", now_);
  for (int n = 0; n < kFrames; ++n) {
    frame();
    ASSERT_FALSE(kiosk_->access_input().sings()) << "frame " << n << " left one over";
  }
}

/// It is touched in its first frame.
class TouchedAtOnce : public FrameOrder {
 protected:
  void change(KioskOptions& options) override {
    FrameOrder::change(options);
    touch();
  }
};

// Guards `draw_next_picture(...)` before `visit_->frame(...)`: cards get their pictures there.
TEST_F(TouchedAtOnce, TheShelfHasItsPicturesInTheFirstFrameThatShowsIt) {
  ASSERT_EQ(kiosk_->visit().screen(), ScreenId::choose);
  const auto shown = pictures_on(kiosk_->shown());
  EXPECT_TRUE(shown.contains(kiosk_->shelf().cards().at(0).picture));
  EXPECT_FALSE(shown.contains(0));
}

/// One with a mission that changes with the day, and two vessels.
class DailyKiosk : public FrameOrder {
 protected:
  void change(KioskOptions& options) override {
    FrameOrder::change(options);
    std::filesystem::create_directories(folder_ / "shelf");
    std::filesystem::copy("content/vessels/tea_bowl", folder_ / "shelf/tea_bowl",
                          std::filesystem::copy_options::recursive);
    std::ofstream(folder_ / "missions.toml")
        << "[[mission]]\nid = \"it\"\nkind = \"today\"\non = true\n"
        << "title = { en = \"It\" }\nabout = { en = \"Do.\" }\n";
    before_ = "missions = \"" + (folder_ / "missions.toml").string() + "\"\n";
    options.wall = [this] { return wall_; };
  }
  const std::string& todays() const {
    return kiosk_->card(kiosk_->missions().cards().at(0).card)->vessel->id;
  }
  std::time_t wall_ = 1'777'900'000;  // 2026-05-04, about noon in any museum
};

// Guards `look_at_shelf(now)`, which asks whether nobody is here, before the input: the list that
// a touch chooses from is today's, and never changes under a finger.
TEST_F(DailyKiosk, TheFirstTouchOfADayMeetsThatDaysMissions) {
  const std::string yesterdays = todays();
  frame();
  ASSERT_EQ(todays(), yesterdays);
  wall_ += 86'400;
  touch();
  frame();
  ASSERT_EQ(kiosk_->visit().screen(), ScreenId::choose) << "somebody is here now";
  EXPECT_NE(todays(), yesterdays);
  wall_ += 86'400;
  for (int n = 0; n < 3; ++n) frame();
  EXPECT_NE(todays(), yesterdays) << "while they are, it stays";
}

/// A thread of this process is called `name`.
bool runs(const std::string& name) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream comm(task.path() / "comm");
    std::string its;
    if (std::getline(comm, its) && its == name) return true;
  }
  return false;
}

/// One whose X server ends.
class LostScreen : public FrameOrder {
 protected:
  void SetUp() override {}
  void TearDown() override {
    ::unsetenv("TMPDIR");
    FrameOrder::TearDown();
  }
  /// Ends the process, as Xlib does.
  void lose_it(commands::DoomedServer& server) {
    ::setenv("DISPLAY", server.name().c_str(), 1);
    FrameOrder::SetUp();
    ask_to_keep_a_pot(false);
    for (int n = 0; n < 5; ++n) frame();  // its postcard is drawn
    watch_.called = [](const char* call) { std::fprintf(stderr, "asked to %s\n", call); };
    server.end();
    for (int n = 0; n < 100; ++n) kiosk_->frame(now_ += 0.04, true);
  }
};

// Guards `keeping_->lose_screen()` before `close_visit()` where the screen is lost: what ends a
// visit must not ask a renderer whose display is gone.
TEST_F(LostScreen, AVisitThatEndsWithItsScreenDropsNoPicture) {
  commands::DoomedServer server;
  if (server.name().empty()) GTEST_SKIP() << "Xvfb is not installed";
  ::setenv("TMPDIR", (folder_ / "").c_str(), 1);  // the other process removes nothing
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      lose_it(server), ::testing::ExitedWithCode(1),
      ::testing::AllOf(::testing::HasSubstr("X server is gone"), ::testing::HasSubstr("Kept "),
                       ::testing::Not(::testing::HasSubstr("asked to drop_picture"))));
}

/// A kiosk on the clock, whose scene looks for its grid.
class TunedKiosk : public OneJar {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "auto.toml") << "quality = \"auto\"\n[clay]\nrows = 321\n[walls]\n";
    KioskOptions options;
    options.window = {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"};
    options.tune.grids = {{100, 90}};
    options.tune.truth = {900, 700, 2000.0};  // long enough for the visitor to reach the wheel
    options.tune.scene_rows = 800;
    options.tune.passes = 10;
    open("paper", "turning = false\n", options,
         "[vessel_scenes]\nmoon_jar = \"" + (folder_ / "auto.toml").string() + "\"\n");
  }
  void press(const std::string& control) {
    for (int n = 0; n < 500 && !kiosk_->visit().control(control); ++n)
      kiosk_->frame(now_ += 0.04, false);
    ASSERT_TRUE(kiosk_->visit().control(control)) << control;
    kiosk_->visit().activate(control, now_);
  }
};

// Guards `scenes_->take_up_tuned()` before the requests: a pot that is asked for in the frame in
// which a grid is found has it.
TEST_F(TunedKiosk, APotHasTheGridThatWasFoundBeforeItWasAskedFor) {
  press("attract.begin");
  press("choose.card.0");
  press("choose.throw");
  ASSERT_TRUE(runs("onggi-tune")) << "the search ended before the pot was asked for";
  for (int n = 0; n < 12'000 && runs("onggi-tune"); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_FALSE(runs("onggi-tune"));
  // A worker makes the lump.
  for (int n = 0; n < 1000 && kiosk_->doing().pot.clay.rows != 100; ++n) {
    kiosk_->frame(now_ += 0.04, false);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(kiosk_->doing().card, 0);
  EXPECT_EQ(kiosk_->doing().pot.clay.rows, 100);
}

/// Hand devices on a bus that tells when it goes.
class PluggedKiosk : public OneJar {
 protected:
  struct Socket final : device::HidBus {
    explicit Socket(std::vector<bool>& gone) : gone_(gone), one_(1) {}
    ~Socket() override { gone_.push_back(runs("onggi-wheel")); }
    std::vector<device::HidListing> list() override { return one_.list(); }
    std::unique_ptr<device::HidPort> open(const std::string& path) override {
      return one_.open(path);
    }
    std::vector<bool>& gone_;
    Bus one_;
  };
  void SetUp() override {
    KioskOptions options;
    options.window = {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"};
    open("paper", "turning = false\n", options);
  }
  std::unique_ptr<device::HidBus> plugged() override { return std::make_unique<Socket>(gone_); }
  std::vector<bool> gone_;  ///< Did the wheel turn when the bus went?
};

// Guards `wheel_host_` above `devices_` in the class: members go last to first, and a device's hand
// is the wheel's.
TEST_F(PluggedKiosk, HandDevicesGoBeforeTheWheelThatTheyLead) {
  for (int n = 0; n < 2000 && kiosk_->doing().device_moves.value_or(0) == 0; ++n) {
    kiosk_->frame(now_ += 1, false);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_GT(kiosk_->doing().device_moves.value_or(0), 0u);
  ASSERT_TRUE(gone_.empty());
  kiosk_.reset();
  EXPECT_FALSE(runs("onggi-wheel"));
  EXPECT_EQ(gone_, std::vector<bool>{true});
}

// Guards the order of Kiosk's members: the last of the class goes first. Sound's thread reads the
// wheel, the visit points at nine parts, and workers of keepsakes hold theirs.
TEST(KioskMembers, WhatIsUsedOutlivesItsUsers) {
  const std::string header = commands::content("kiosk/exhibit/composition/kiosk.h");
  const auto at = [&](const std::string& member) {
    const auto here = std::min(header.find("> " + member + ";"), header.find(" " + member + ";"));
    EXPECT_NE(here, std::string::npos) << member;
    return here;
  };
  for (const auto& [used, users] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"exhibit_", {"scenes_", "shelf_", "missions_", "counter_", "keeping_", "visit_"}},
           {"scenes_", {"shelf_", "missions_", "pot_"}},
           {"languages_", {"keeping_", "visit_"}},
           {"lesson_", {"visit_"}},
           {"build_lesson_", {"visit_"}},
           {"renderer_", {"pot_", "keeping_", "visit_"}},
           {"wheel_host_", {"sound_", "devices_", "pot_", "keeping_", "visit_"}},
           {"devices_", {"visit_"}},
           {"shelf_", {"visit_"}},
           {"missions_", {"visit_"}},
           {"todays_", {"keeping_", "visit_"}},
           {"counter_", {"keeping_"}}})
    for (const std::string& user : users) EXPECT_LT(at(used), at(user)) << used << ' ' << user;
}

}  // namespace
}  // namespace onggi::exhibit::frame_order_test
