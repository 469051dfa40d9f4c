#include "kiosk/visit/screens/paddle_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/script/beating_up.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::paddle_hand_test {
namespace {

using view::InputEvent;

/// Somebody with a paddle at a real wheel, with a thick wall on it.
struct Beater {
  Beater() {
    def.clay.rows = 120;
    def.clay.sectors = 96;
    def.clay.height = 0.12;
    def.clay.outer_radius = 0.055;
    def.clay.inner_radius = 0.043;
    def.wheel.acceleration = 1000.0;
    def.volume.emplace();
    def.beating = BeatingDef{0.08, 0.03, 16e3};
    hand.emplace(def.beating->face, def.tool.radius);
    host.start(std::make_unique<Scene>(std::move(*Scene::create(def))));
    host.hold(loop::InHand::paddle);
    camera = view::frame_pot(1280, 720, {340, 60, 600, 600}, 0.16, 0.06);
    frames(0.6);  // a hand is off for a moment when it takes a paddle
  }
  const ClayView& clay() const { return host.view().clay; }

  void frames(double seconds) {
    for (double t = 0; t < seconds - 1e-9; t += 0.016) {
      hand->follow(0.016);
      host.hand(0, hand->input(camera, clay()));
      for (int n = 0; n < 16; ++n) {
        host.advance(1);
        const double now = host.status().feedback.hand[0].blow;
        blows += now > 0.0 && last == 0.0 ? 1 : 0;
        last = now;
        deepest = std::max(deepest, host.status().feedback.hand[0].depth);
      }
      host.collect();
    }
  }
  /// A finger over a place of the pot's surface, or beside it.
  void finger(InputEvent::Kind kind, Vec3 at, std::uint8_t which = 0) {
    const auto pixel = *camera.project(at);
    InputEvent event{kind, pixel.first, pixel.second, 0, view::Key::none, false};
    event.finger = which;
    hand->pointer(event);
  }

  SceneDef def;
  loop::SteppedWheel host;
  view::Camera camera;
  std::optional<PaddleHand> hand;
  int blows = 0;
  double last = 0.0, deepest = 0.0;
};

TEST(PaddleHand, BeatsWhereTheFingerIsOnTheSideAndInFront) {
  for (const double angle :
       {0.0, 0.9, 1.57, 2.4, 3.14}) {  // from the right over the front to the left
    Beater b;
    const Vec3 touched{0.055 * std::cos(angle), 0.07, 0.055 * std::sin(angle)};
    b.finger(InputEvent::Kind::pointer_down, touched);
    const HandInput hand = b.hand->input(b.camera, b.clay());
    ASSERT_TRUE(hand.active);
    const double out = axis_distance(hand.position);
    EXPECT_NEAR(hand.position.x / out, std::cos(angle), 0.12) << angle;
    EXPECT_NEAR(hand.position.z / out, std::sin(angle), 0.12) << angle;
    EXPECT_NEAR(hand.position.y, 0.07, 0.004) << angle;
    b.frames(2.0);
    EXPECT_EQ(b.blows, 6) << "three a second";
    EXPECT_EQ(b.deepest, 0.0) << "the hand itself presses nothing";
  }
}

TEST(PaddleHand, MakesTheWallThinWhileTheWheelTurnsAndStopsWithTheFinger) {
  Beater b;
  b.host.wheel(2.5);
  b.finger(InputEvent::Kind::pointer_down, {0.055, 0.06, 0});
  b.frames(8.0);
  EXPECT_GT(b.clay().rim_height(), 0.122);
  EXPECT_EQ(b.deepest, 0.0) << "although the wall grew";
  b.finger(InputEvent::Kind::pointer_up, {});
  const int blows = b.blows;
  EXPECT_GT(blows, 20);
  b.frames(2.0);
  EXPECT_EQ(b.blows, blows);
}

// The hand glides after the finger, along a chord of the pot: it must not press on its way.
TEST(PaddleHand, PressesNothingHoweverFastTheFingerGoesRoundOrUp) {
  Beater b;
  const std::uint64_t fresh = b.clay().change();
  b.finger(InputEvent::Kind::pointer_down, {0.055, 0.03, 0});
  for (int n = 0; n < 40; ++n) {
    const double angle = 0.2 * n;
    b.finger(InputEvent::Kind::pointer_move,
             {0.055 * std::cos(angle), 0.02 + 0.002 * n, 0.055 * std::abs(std::sin(angle))});
    b.frames(0.032);
  }
  EXPECT_EQ(b.deepest, 0.0);
  EXPECT_GT(b.blows, 2);
  EXPECT_GT(b.clay().change(), fresh);
}

TEST(PaddleHand, StrikesNoMoreOnceTheFingerIsLiftedWhenever) {
  for (int after = 40; after < 400; after += 30) {
    Beater b;
    b.finger(InputEvent::Kind::pointer_down, {0.055, 0.06, 0});
    b.frames(0.001 * after + 0.3);
    b.finger(InputEvent::Kind::pointer_up, {});
    b.frames(0.016);
    const int blows = b.blows;
    b.frames(1.0);
    EXPECT_EQ(b.blows, blows) << after << " ms";
  }
}

TEST(PaddleHand, DoesNothingBesideThePot) {
  Beater b;
  b.finger(InputEvent::Kind::pointer_down, {0.12, 0.06, 0});
  b.frames(1.5);
  EXPECT_EQ(b.blows, 0);
  b.finger(InputEvent::Kind::pointer_move, {0.055, 0.06, 0});
  b.frames(1.5);
  EXPECT_GT(b.blows, 2) << "and the finger may come to it";
}

TEST(PaddleHand, GoesUpTheWallByItselfAndEnds) {
  Beater b;
  b.host.wheel(2.5);
  b.hand->beat_up(1.0, 6.0);
  EXPECT_TRUE(b.hand->by_itself());
  double low = 1.0, high = 0.0;
  for (int n = 0; n < 7; ++n) {
    const HandInput hand = b.hand->input(b.camera, b.clay());
    if (hand.active) low = std::min(low, hand.position.y), high = std::max(high, hand.position.y);
    b.frames(1.0);
  }
  EXPECT_LT(low, 0.03);
  EXPECT_GT(high, 0.085);
  EXPECT_FALSE(b.hand->active());
  EXPECT_NEAR(b.blows, 17, 2);
}

TEST(PaddleHand, IsMovedByKeysAndStaysOnTheWall) {
  Beater b;
  b.hand->move_by_keys(-1.0, 0.0, b.clay());
  const double middle = b.hand->input(b.camera, b.clay()).position.y;
  EXPECT_LT(b.hand->input(b.camera, b.clay()).position.x, 0.0);
  for (int n = 0; n < 100; ++n) b.hand->move_by_keys(-1.0, 0.004, b.clay());
  const double top = b.hand->input(b.camera, b.clay()).position.y;
  EXPECT_GT(top, middle + 0.02);
  EXPECT_LT(top, b.clay().rim_height());
}

// Who tapped the button again and again beat only the lower half.
TEST(PaddleHand, ThatWasStoppedOnItsWayUpGoesOnFromThere) {
  Beater b;
  b.hand->beat_up(1, 4.0);
  b.frames(2.0);
  const double middle = b.hand->input(b.camera, b.clay()).position.y;
  b.hand->lift();
  b.hand->beat_up(1, 4.0);
  EXPECT_NEAR(b.hand->input(b.camera, b.clay()).position.y, middle, 0.005);
  b.frames(2.5);
  EXPECT_FALSE(b.hand->active()) << "it came to the rim";
  b.hand->beat_up(1, 4.0);
  EXPECT_LT(b.hand->input(b.camera, b.clay()).position.y, middle - 0.02) << "from the foot again";
}

// The wall near foot and rim stayed thick for ever, and so did the arrow there.
TEST(PaddleHand, ReachesAsNearToFootAndRimAsAScriptsPaddle) {
  Beater b;
  const double face = b.def.beating->face;
  b.hand->move_by_keys(1, 0, b.clay());
  b.hand->move_by_keys(1, -1, b.clay());
  EXPECT_NEAR(b.hand->input(b.camera, b.clay()).position.y,
              b.clay().floor_top() + script::PaddleUp::kFromFoot * face, 1e-9);
  b.hand->move_by_keys(1, 1, b.clay());
  EXPECT_NEAR(b.hand->input(b.camera, b.clay()).position.y,
              b.clay().rim_height() - script::PaddleUp::kFromRim * face, 1e-9);
}

}  // namespace
}  // namespace onggi::screens::paddle_hand_test
