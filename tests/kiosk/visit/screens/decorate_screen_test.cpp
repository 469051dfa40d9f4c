#include "kiosk/visit/screens/decorate_screen.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/kiosk/visit/screens/decorator.h"
#include "tests/kiosk/visit/screens/layout_check.h"

namespace onggi::screens::decorate_screen_test {
namespace {

TEST(DecorateScreen, ComesAfterTheResultAndMayBeSkipped) {
  Decorator v;
  v.touch("result.keep");
  EXPECT_EQ(v.visit->screen(), ScreenId::decorate);
  EXPECT_NE(words_in(v.frame).find("Leave it plain"), std::string::npos);
  v.touch("decorate.on");
  EXPECT_EQ(v.visit->screen(), ScreenId::kiln);
  EXPECT_EQ(v.visit->decoration(), nullptr);
  v.touch("kiln.glaze.0");
  v.touch("kiln.keep");
  for (const Request& request : v.requests())
    if (const auto* wish = std::get_if<MakeKeepsake>(&request)) {
      EXPECT_FALSE(wish->decorated);
    }
}

TEST(DecorateScreen, APrintedPotThatIsLeftPlainKeepsItsPrints) {
  Visitor v(2, nullptr, true);
  v.offer("onggi");
  for (ShelfCard& card : v.shelf) card.wheel.prints.emplace().paddle = PrintsDef::grid;
  Print print;
  print.low = 0.06, print.high = 0.1;
  print.half = 0.5;
  print.wide = print.tall = 0.02;
  print.deep = 0.002;
  v.view.prints = {print};
  v.make_result();
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  ASSERT_NE(v.visit->decoration(), nullptr) << "they are seen at once";
  v.touch("result.keep");
  EXPECT_NE(words_in(v.frame).find("Leave it plain"), std::string::npos);
  const std::uint64_t printed = v.visit->decorated_pot()->surface().hash();
  v.touch("decorate.on");
  EXPECT_EQ(v.visit->screen(), ScreenId::kiln);
  ASSERT_NE(v.visit->decoration(), nullptr);
  v.touch("kiln.glaze.0");
  v.frames(12);
  EXPECT_TRUE(v.visit->decoration()->fired());
  v.touch("kiln.keep");
  bool kept = false;
  for (const Request& request : v.requests())
    if (const auto* wish = std::get_if<MakeKeepsake>(&request)) {
      kept = true;
      ASSERT_TRUE(wish->decorated);
      EXPECT_EQ(wish->decorated->surface().hash(), printed);
      EXPECT_TRUE(wish->decorated_how.empty()) << "nobody decorated it";
    }
  EXPECT_TRUE(kept);
}

// Else a finger that rests on the pot for three seconds would turn "Read aloud" on.
TEST(DecorateScreen, AFingerThatRestsOnThePotIsAtWorkWhateverTheToolAndOneBesideItIsNot) {
  Decorator v;
  v.touch("result.keep");
  view::InputEvent e;
  e.kind = view::InputEvent::Kind::pointer_down;
  for (const auto& [id, control] : v.visit->controls()) {
    if (!id.starts_with("decorate.tool.")) continue;
    v.touch(id);
    std::tie(e.x, e.y) = v.middle();
    EXPECT_TRUE(v.visit->works(e)) << id;
    e.x = e.y = 3;
    EXPECT_FALSE(v.visit->works(e)) << id;
  }
  e.kind = view::InputEvent::Kind::key_down, e.key = view::Key::up;
  EXPECT_TRUE(v.visit->works(e)) << "it moves the mark";
  e.key = view::Key::enter;
  EXPECT_FALSE(v.visit->works(e));
}

TEST(DecorateScreen, SomeToolsStandBehindAButtonAndNeverMoreThanSixAreShown) {
  for (const auto& file : std::filesystem::directory_iterator("content/ways")) {
    Decorator v(file.path().stem().string());
    v.touch("result.keep");
    const auto& tools = v.pot()->way().tools;
    const auto shown = [&](bool more) {
      int count = 0;
      for (int n = 0; n < static_cast<int>(tools.size()); ++n) {
        const bool on = v.visit->control("decorate.tool." + std::to_string(n)).has_value();
        EXPECT_EQ(on, tools[static_cast<std::size_t>(n)].more == more) << file.path() << n;
        count += on;
      }
      EXPECT_LE(count, 6) << file.path();
      return count;
    };
    const int first = shown(false);
    ASSERT_EQ(v.visit->control("decorate.more").has_value(),
              first < static_cast<int>(tools.size()));
    if (first == static_cast<int>(tools.size())) continue;
    v.touch("decorate.more");
    EXPECT_TRUE(v.pot()->held().more);
    EXPECT_EQ(shown(true), static_cast<int>(tools.size()) - first);
    v.touch("decorate.more");
    EXPECT_FALSE(v.pot()->held().more);
  }
}

TEST(DecorateScreen, WhereNoWayIsOfferedTheResultLeadsToTheKiln) {
  Decorator v("");
  v.touch("result.keep");
  EXPECT_EQ(v.visit->screen(), ScreenId::kiln);
  v.touch("back");
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
}

TEST(DecorateScreen, AFingerOnThePotCutsAndTheKeepsakeHasItInWords) {
  Decorator v;
  v.touch("result.keep");
  v.stroke(20, 40);
  ASSERT_NE(v.visit->decoration(), nullptr);
  EXPECT_EQ(v.pot()->did().size(), 1u);
  EXPECT_NE(words_in(v.frame).find("To the kiln"), std::string::npos);
  v.touch("decorate.on");
  v.touch("kiln.glaze.0");
  v.frames(12);
  EXPECT_TRUE(v.visit->decoration()->fired());
  v.touch("kiln.keep");
  bool kept = false;
  for (const Request& request : v.requests())
    if (const auto* wish = std::get_if<MakeKeepsake>(&request)) {
      kept = true;
      ASSERT_TRUE(wish->decorated);
      EXPECT_FALSE(wish->decorated->bare());
      EXPECT_FALSE(wish->decorated_how.empty());
    }
  EXPECT_TRUE(kept);
}

TEST(DecorateScreen, AFingerBesideThePotTurnsItAndLeavesNoMark) {
  Decorator v;
  v.touch("result.keep");
  v.frames(1);
  const double before = v.frame.pot->clay_angle;
  const view::Rect pot = *v.visit->control("decorate.mark");
  const float x = pot.x + pot.w + 20, y = pot.y + 40;
  v.down(x, y);
  v.move(x + 100, y);
  v.show();
  v.up(x + 100, y);
  v.show();
  EXPECT_NE(v.frame.pot->clay_angle, before);
  EXPECT_TRUE(v.pot()->bare());
}

TEST(DecorateScreen, ThePotTurnsUnderARestingFingerAndTheBandCloses) {
  Decorator v("porcelain");
  v.touch("result.keep");
  ASSERT_EQ(v.way->tools[0].hand, decoration::WayTool::ring);
  const double before = v.frame.pot->clay_angle;
  const auto [x, y] = v.middle();
  v.down(x, y);
  v.frames(0.5);
  EXPECT_GT(std::abs(v.frame.pot->clay_angle - before), 0.5);
  v.up(x, y);
  v.frames(4);
  const auto& surface = v.pot()->surface();
  int painted = 0, row = 0;
  for (int j = 0; j < surface.rows(); ++j)
    if (surface.slip(j, 0).word() != 0) row = j;
  for (int i = 0; i < surface::kSectors; ++i) painted += surface.slip(row - 2, i).word() != 0;
  EXPECT_EQ(painted, surface::kSectors);
}

/// Cells that the stone has been on, when the finger has gone up 150 pixels in a second.
std::vector<bool> burnished(int frames_a_second) {
  Decorator v("burnished");
  v.touch("result.keep");
  EXPECT_EQ(v.way->tools[1].id, "burnish");
  const auto [x, y] = v.middle();
  v.down(x, y);
  v.up(x, y);
  v.frames(5);
  v.touch("decorate.tool.1");
  v.down(x, y);
  constexpr int kMoves = 30;
  const int moves_a_frame = kMoves / frames_a_second;
  for (int n = 1; n <= kMoves; ++n) {
    v.move(x, y - 5.0f * static_cast<float>(n));
    if (n % moves_a_frame == 0) v.frame_after(1.0 / frames_a_second);
  }
  const auto& surface = v.pot()->surface();
  std::vector<bool> out;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < surface::kSectors; ++i) out.push_back(surface.burnish(j, i) > 0);
  return out;
}

// A ring that follows the finger was a staircase on a machine that draws five frames a second.
TEST(DecorateScreen, ARingThatFollowsTheFingerIsAsSmoothOnASlowMachine) {
  const std::vector<bool> fast = burnished(30), slow = burnished(5);
  ASSERT_EQ(fast.size(), slow.size());
  int shining = 0, unlike = 0;
  for (std::size_t n = 0; n < fast.size(); ++n) {
    shining += fast[n];
    unlike += fast[n] != slow[n];
  }
  EXPECT_GT(shining, 10'000);
  EXPECT_LT(unlike, shining / 50);
}

TEST(DecorateScreen, UndoHasOnePlaceAndTakesTheLastTouchBack) {
  Decorator v;
  v.touch("result.keep");
  EXPECT_FALSE(v.visit->control("decorate.undo"));
  v.stroke(10, 30);
  const view::Rect there = *v.visit->control("decorate.on");
  v.touch("decorate.undo");
  EXPECT_TRUE(v.pot()->bare());
  EXPECT_EQ(v.visit->control("decorate.on")->y, there.y);
  v.stroke(10, 30);
  v.key(view::Key::restore);
  EXPECT_TRUE(v.pot()->bare());
}

TEST(DecorateScreen, AToolThatNeedsAnotherSaysWhich) {
  Decorator v;
  v.touch("result.keep");
  int waiting = 0;
  while (v.way->tools[static_cast<std::size_t>(waiting)].needs < 0) ++waiting;
  v.touch("decorate.tool." + std::to_string(waiting));
  EXPECT_NE(words_in(v.frame).find("Use this first:"), std::string::npos);
  v.stroke(10, 30);
  EXPECT_TRUE(v.pot()->bare());
}

TEST(DecorateScreen, ItGoesByKeyboardAlone) {
  Decorator v;
  v.touch("result.keep");
  for (int n = 0; n < 8 && v.visit->focus() != "decorate.mark"; ++n) v.key(view::Key::right);
  ASSERT_EQ(v.visit->focus(), "decorate.mark");
  v.key(view::Key::enter);
  EXPECT_FALSE(v.pot()->bare());
  v.key(view::Key::up);
  v.key(view::Key::right);
  v.key(view::Key::enter);
  v.frames(1);
  EXPECT_EQ(v.pot()->did()[0].times, 2);
}

TEST(DecorateScreen, WhoHearsThePageMovesAMarkByButtons) {
  Decorator v("porcelain");
  v.exhibit.screen.spoken = true;
  v.touch("result.keep");
  v.touch("decorate.higher");
  v.touch("decorate.here");
  v.frames(4);
  EXPECT_FALSE(v.pot()->bare());
}

TEST(DecorateScreen, WhoComesBackFindsTheDecorationAndFreshClayHasNone) {
  Decorator v;
  v.touch("result.keep");
  v.stroke(10, 30);
  v.touch("back");
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
  EXPECT_NE(v.visit->decoration(), nullptr);
  v.touch("result.keep");
  EXPECT_FALSE(v.pot()->bare());
  v.touch("back");
  v.touch("result.again");
  v.touch("leaving.go");
  EXPECT_EQ(v.visit->decoration(), nullptr);
  v.frames(1);
  v.touch("throw.done");
  v.touch("result.keep");
  EXPECT_TRUE(v.pot()->bare());
}

TEST(DecorateScreen, NextVisitorFindsNothingOfIt) {
  Decorator v;
  v.touch("result.keep");
  v.stroke(10, 30);
  v.frames(v.exhibit.idle.result_after + v.exhibit.idle.countdown + 1);
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_EQ(v.visit->decoration(), nullptr);
  EXPECT_EQ(v.pot(), nullptr);
}

TEST(DecorateScreen, AfterAGoodWhileItSaysSoGentlyAndTakesNothingAway) {
  Decorator v;
  v.touch("result.keep");
  v.stroke(10, 30);
  v.frames(50);
  v.stroke(-10, 30);
  v.frames(45);
  EXPECT_NE(words_in(v.frame).find("When you like it, fire it."), std::string::npos);
  EXPECT_EQ(v.visit->screen(), ScreenId::decorate);
}

TEST(DecorateScreen, ATouchWhileARingClosesIsNotLost) {
  Decorator v("porcelain");
  v.touch("result.keep");
  const auto [x, y] = v.middle();
  v.down(x, y);
  v.show();
  v.up(x, y);
  v.show();
  ASSERT_TRUE(v.pot()->busy());
  v.down(x, y + 60);
  v.show();
  v.up(x, y + 60);
  v.frames(4);
  ASSERT_EQ(v.pot()->did().size(), 1u);
  EXPECT_EQ(v.pot()->did()[0].times, 2);
}

TEST(DecorateScreen, ShowMeDrawsAnExampleAndTakesItBack) {
  Decorator v;
  v.touch("result.keep");
  v.touch("decorate.show");
  v.frames(2.0);
  EXPECT_NE(v.visit->decoration(), nullptr);
  EXPECT_NE(words_in(v.frame).find("Watch the finger"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("Leave it plain"), std::string::npos);
  v.frames(5.0);
  EXPECT_EQ(v.visit->decoration(), nullptr);
  EXPECT_EQ(words_in(v.frame).find("Watch the finger"), std::string::npos);
}

TEST(DecorateScreen, ATouchEndsTheExampleAndDrawsAtOnce) {
  Decorator v;
  v.touch("result.keep");
  v.touch("decorate.show");
  v.frames(1.5);
  v.stroke(20, 40);
  EXPECT_FALSE(v.pot()->shows_example());
  ASSERT_EQ(v.pot()->did().size(), 1u);
  EXPECT_EQ(v.pot()->did()[0].times, 1);
  v.frames(7);
  EXPECT_FALSE(v.pot()->bare());
  v.touch("decorate.undo");
  EXPECT_TRUE(v.pot()->bare());
}

TEST(DecorateScreen, ShowMeGoesByKeysAndASecondPressEndsIt) {
  Decorator v;
  v.touch("result.keep");
  for (int n = 0; n < 30 && v.visit->focus() != "decorate.show"; ++n) v.key(view::Key::next);
  v.key(view::Key::enter);
  v.frames(1.5);
  EXPECT_TRUE(v.pot()->shows_example());
  EXPECT_EQ(v.visit->reading().words.front(), "Decorate your pot");
  v.key(view::Key::enter);
  EXPECT_FALSE(v.pot()->shows_example());
  EXPECT_TRUE(v.pot()->bare());
}

TEST(DecorateScreen, WhoGoesOnDuringAnExampleTakesNothingOfItAlong) {
  Decorator v;
  v.touch("result.keep");
  v.touch("decorate.show");
  v.frames(1.5);
  v.touch("decorate.on");
  EXPECT_EQ(v.visit->screen(), ScreenId::kiln);
  EXPECT_TRUE(v.pot()->bare());
  EXPECT_EQ(v.visit->decoration(), nullptr);
}

TEST(DecorateScreen, TheButtonForMoreToolsAlsoNamesTheWayBack) {
  Decorator v;
  v.touch("result.keep");
  EXPECT_NE(words_in(v.frame).find("More tools"), std::string::npos);
  v.touch("decorate.more");
  EXPECT_EQ(words_in(v.frame).find("More tools"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("First tools"), std::string::npos);
  v.touch("decorate.more");
  EXPECT_NE(words_in(v.frame).find("More tools"), std::string::npos);
}

TEST(DecorateScreen, TwoFingersTurnAndTiltThePotAndDrawNothing) {
  using Kind = view::InputEvent::Kind;
  Decorator v;
  v.touch("result.keep");
  const auto [x, y] = v.middle();
  v.frames(1);
  const view::PotView before = *v.frame.pot;
  v.finger(0, Kind::pointer_down, x - 40, y);
  v.finger(0, Kind::pointer_move, x - 38, y);
  v.show();
  v.finger(1, Kind::pointer_down, x + 40, y);
  for (const int finger : {0, 1})
    v.finger(finger, Kind::pointer_move, x + 60 + 80.0f * static_cast<float>(finger), y + 60);
  v.show();
  v.finger(1, Kind::pointer_up, x + 140, y + 60);
  v.finger(0, Kind::pointer_move, x + 80, y + 60);
  v.finger(0, Kind::pointer_up, x + 80, y + 60);
  v.show();
  EXPECT_TRUE(v.pot()->bare());
  EXPECT_GT(v.frame.pot->camera.elevation, before.camera.elevation + 0.1);
  EXPECT_LT(v.frame.pot->clay_angle, before.clay_angle - 0.3);
  // One finger then draws where it is, on the tilted pot.
  v.finger(0, Kind::pointer_down, x, y);
  v.finger(0, Kind::pointer_move, x + 20, y + 40);
  v.finger(0, Kind::pointer_up, x + 20, y + 40);
  v.show();
  EXPECT_FALSE(v.pot()->bare());
}

TEST(DecorateScreen, NothingOfAnyWayIsCutAtAnySize) {
  for (const auto& file : std::filesystem::directory_iterator("content/ways"))
    for (const auto& [width, height] : {std::pair{1920, 1080}, {1080, 1920}, {1024, 600}}) {
      Decorator v(file.path().stem().string());
      v.width = width;
      v.height = height;
      v.show();
      v.touch("result.keep");
      v.frames(1.0);
      walk_decorating(
          v, [&](const std::string& name) { check_layout(v, v.plain, name); }, v.way->tools.size());
      v.touch("decorate.on");
      v.frames(1.0);
      check_layout(v, v.plain, "kiln after " + v.way->id);
    }
}

}  // namespace
}  // namespace onggi::screens::decorate_screen_test
