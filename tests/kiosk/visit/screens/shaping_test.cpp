#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engine/scene/lump.h"
#include "engine/scene/replay.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/visit/screens/throwing_controls.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::shaping_test {
namespace {

using view::InputEvent;

/// A visit on a real wheel with real clay: thirty frames a second, a thousand ticks.
class Studio {
 public:
  explicit Studio(bool springs_back = false) : springs(springs_back) {
    auto language = content::Language::read("content/languages/en.toml");
    if (language) languages_.push_back(*language);
    vessel_.labels["en"] = {"Jar", "", "", "", "A jar.", ""};
    shelf_.push_back({&vessel_, 0, jar(0.08), 1.0, {}});
    VisitInputs world;
    world.exhibit = &exhibit_;
    world.languages = &languages_;
    world.shelf = &shelf_;
    world.measure = &measure_;
    world.wheel = &wheel_host.view();
    world.wheel_commands = &wheel_host;
    visit = std::make_unique<Visit>(world);
    run(0.2);
    event(InputEvent::Kind::pointer_down, 5, 5);
    event(InputEvent::Kind::pointer_up, 5, 5);
    run(0.2);
    press("choose.card.0");
    press("choose.throw");
    run(1.5);  // The wheel comes up to speed.
  }

  /// The wheel turns and the screens look away: rows are on their way.
  void turn_unseen(int ticks) { wheel_host.advance(ticks); }
  std::optional<MakeKeepsake> keepsake;

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 30)); ++i) {
      now_ += 1.0 / 30;
      wheel_host.advance(33);
      wheel_host.collect();
      visit->update(now_);
      while (auto request = visit->take_request()) {
        if (const auto* start = std::get_if<StartPot>(&*request)) begin(*start);
        if (const auto* keep = std::get_if<MakeKeepsake>(&*request)) keepsake = *keep;
      }
      frame = visit->frame(1280, 720);
    }
  }

  void event(InputEvent::Kind kind, float x, float y) {
    visit->input({kind, x, y, 0, view::Key::none, false}, now_);
  }

  void press(const std::string& control) {
    for (const std::string& way : {std::string("throw.less"), way_into_drawer(control)})
      if (control != way && !visit->control(control) && visit->control(way)) press(way);
    const auto r = visit->control(control);
    ASSERT_TRUE(r) << control;
    event(InputEvent::Kind::pointer_down, r->x + 3, r->y + 3);
    run(0.1);
    event(InputEvent::Kind::pointer_up, r->x + 3, r->y + 3);
    run(0.1);
  }

  /// A finger along straight lines between points (metres: right of the axis, height).
  void stroke(const std::vector<Vec2>& way, double seconds_each) {
    const auto at = [&](Vec2 p) { return *frame.pot->camera.project({p.x, p.y, 0}); };
    const auto [x0, y0] = at(way.front());
    event(InputEvent::Kind::pointer_down, x0, y0);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const int steps = static_cast<int>(seconds_each * 30);
      for (int k = 1; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        const auto [x, y] = at(way[i] + (way[i + 1] - way[i]) * t);
        event(InputEvent::Kind::pointer_move, x, y);
        run(1.0 / 30);
      }
    }
    event(InputEvent::Kind::pointer_up, 0, 0);
    run(0.2);
  }

  bool springs;
  loop::SteppedWheel wheel_host;
  std::unique_ptr<Visit> visit;
  view::Frame frame;

 private:
  void begin(const StartPot& start) {
    SceneDef def;
    def.clay = lump_for(shelf_[0].target, def);
    def.clay.rows = 120;
    def.clay.sectors = 96;
    if (springs) def.springback = SpringbackDef{.share = 0.3, .time = 1.0};
    auto scene = Scene::create(def);
    ASSERT_TRUE(scene);
    if (start.scripted) return;
    wheel_host.start(std::make_unique<Scene>(std::move(*scene)));
    wheel_host.record("jar", 1);
  }

  double now_ = 10;
  settings::Exhibit exhibit_;
  std::vector<content::Language> languages_;
  content::Vessel vessel_;
  std::vector<ShelfCard> shelf_;
  PlainMeasure measure_;
};

TEST(Shaping, AFingerDraggedInwardsBringsTheWallToWhereItIs) {
  Studio studio;
  const Profile before = studio.wheel_host.view().clay.profile();
  const double r = before.outer_at(0.14);
  // Two centimetres in, held for two turns of the wheel.
  studio.stroke({{r - 0.01, 0.14}, {r - 0.02, 0.14}, {r - 0.02, 0.14}}, 1.0);
  const Profile after = studio.wheel_host.view().clay.profile();
  EXPECT_NEAR(after.outer_at(0.14), r - 0.02, 0.001);
  EXPECT_NEAR(after.outer_at(0.05), before.outer_at(0.05), 2e-4);
}

TEST(Shaping, AStrokeUpwardsDrawsAnEvenGroove) {
  Studio studio;
  const double r = studio.wheel_host.view().clay.profile().outer_at(0.1);
  studio.stroke({{r, 0.06}, {r - 0.005, 0.06}, {r - 0.005, 0.14}}, 2.5);
  const Profile after = studio.wheel_host.view().clay.profile();
  // Quicker than the clay yields (13 mm of height a turn), so it is not as deep as the finger went;
  // but it is the same depth all along.
  const double depth = r - after.outer_at(0.07);
  EXPECT_GT(depth, 0.002);
  EXPECT_LE(depth, 0.0055);
  for (const double h : {0.09, 0.11, 0.13}) EXPECT_NEAR(r - after.outer_at(h), depth, 0.0003);
}

TEST(Shaping, FromInsideAFingerDraggedOutwardsWidensThePot) {
  Studio studio;
  studio.press("throw.inside");
  const Profile before = studio.wheel_host.view().clay.profile();
  const double r = before.inner_at(0.1);
  studio.stroke({{r, 0.1}, {r + 0.03, 0.1}, {r + 0.03, 0.1}}, 1.5);
  const Profile after = studio.wheel_host.view().clay.profile();
  EXPECT_GT(after.inner_at(0.1), before.inner_at(0.1) + 0.02);
  EXPECT_GE(after.outer_at(0.1), before.outer_at(0.1));
  EXPECT_GT(after.outer_at(0.1), after.inner_at(0.1));
}

TEST(Shaping, TheSameStrokeOnTheLeftDoesTheSame) {
  Studio right, left;
  const double r = right.wheel_host.view().clay.profile().outer_at(0.12);
  right.stroke({{r, 0.12}, {r - 0.008, 0.12}, {r - 0.008, 0.12}}, 1.0);
  left.stroke({{-r, 0.12}, {-r + 0.008, 0.12}, {-r + 0.008, 0.12}}, 1.0);
  EXPECT_NEAR(right.wheel_host.view().clay.profile().outer_at(0.12),
              left.wheel_host.view().clay.profile().outer_at(0.12), 4e-4);
}

TEST(Shaping, AFreshLumpAndBringingItBack) {
  Studio studio;
  const double r = studio.wheel_host.view().clay.profile().outer_at(0.12);
  studio.stroke({{r, 0.12}, {r - 0.01, 0.12}, {r - 0.01, 0.12}}, 1.0);
  const double worked = studio.wheel_host.view().clay.profile().outer_at(0.12);
  studio.press("throw.renew");
  studio.run(1.0);
  EXPECT_NEAR(studio.wheel_host.view().clay.profile().outer_at(0.12), r, 1e-5);
  studio.press("throw.restore");
  studio.run(1.0);
  EXPECT_NEAR(studio.wheel_host.view().clay.profile().outer_at(0.12), worked, 1e-5);
  studio.press("throw.restore");  // the stroke too
  studio.run(1.0);
  EXPECT_NEAR(studio.wheel_host.view().clay.profile().outer_at(0.12), r, 1e-5);
}

TEST(Shaping, TheScoreOnTheScreenIsThatOfTheKeptPotAndOfItsReplayToTheBit) {
  Studio studio(true);
  const double r = studio.wheel_host.view().clay.profile().outer_at(0.1);
  studio.stroke({{r, 0.06}, {r - 0.008, 0.06}, {r - 0.008, 0.14}}, 0.8);
  studio.turn_unseen(60);  // The clay springs back, and its rows are on their way.
  studio.press("throw.done");
  ASSERT_EQ(studio.visit->screen(), ScreenId::result);
  const score::Score on_screen = studio.visit->score();
  studio.run(3);  // A visitor reads; the clay would spring back further.
  studio.press("result.keep");
  studio.run(0.2);
  ASSERT_TRUE(studio.keepsake);
  EXPECT_EQ(studio.keepsake->score.points, on_screen.points);
  const auto points_of = [](const Profile& made) {
    return score::judge(jar(0.08), made, true, 1.0, settings::Rubric{}).points;
  };
  std::uint64_t hash = 0;
  ASSERT_TRUE(studio.wheel_host.with_scene([&](Scene& scene) {
    hash = scene.state_hash();
    EXPECT_EQ(points_of(scene.clay().profile()), on_screen.points);
  }));
  const auto replay = Replay::read(studio.wheel_host.replay(hash), "kept");
  ASSERT_TRUE(replay.has_value());
  std::unique_ptr<Scene> again;
  const auto outcome = run_replay(*replay, &again);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->replayed_hash, hash);
  EXPECT_EQ(points_of(again->clay().profile()), on_screen.points);
}

TEST(Shaping, BackAtTheWheelThePotGoesOn) {
  Studio studio;
  const double r = studio.wheel_host.view().clay.profile().outer_at(0.12);
  studio.stroke({{r, 0.12}, {r - 0.01, 0.12}}, 0.5);
  studio.press("throw.done");
  studio.run(1);
  const std::uint64_t rested = studio.wheel_host.status().ticks;
  studio.run(1);
  EXPECT_EQ(studio.wheel_host.status().ticks, rested);
  studio.press("back");
  studio.run(1);
  EXPECT_GT(studio.wheel_host.status().ticks, rested + 500);
}

}  // namespace
}  // namespace onggi::screens::shaping_test
