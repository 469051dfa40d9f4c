#include "kiosk/visit/screens/coil_hand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/scene/lump.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::coil_hand_test {
namespace {

using view::InputEvent;

/// Somebody with a coil at a real wheel, on which a floor lies for a jar.
struct Builder {
  Builder() {
    def.clay.rows = 240;
    def.clay.sectors = 64;
    def.wheel.acceleration = 1000.0;
    def.volume.emplace();
    def.building.emplace();
    def.clay = lump_for(jar(0.06), def);
    host.start(std::make_unique<Scene>(std::move(*Scene::create(def))));
    host.hold(loop::InHand::coil);
    host.wheel(2.5);
    camera = view::frame_pot(1280, 720, {340, 60, 600, 600}, 0.2, 0.06);
    frames(0.6);  // a hand is off for a moment when it takes a coil
  }
  const ClayView& clay() const { return host.view().clay; }
  double coil() const { return def.building->coil; }
  double rim() const { return clay().rim_height(); }

  void frames(double seconds) {
    for (double t = 0; t < seconds - 1e-9; t += 0.016) {
      hand.follow(clay(), 0.016, belongs);
      host.hand(0, hand.input(camera, clay()));
      host.advance(16);
      host.collect();
    }
  }
  /// A finger at a place in the plane through the axis.
  void finger(InputEvent::Kind kind, Vec3 at, std::uint8_t which = 0) {
    const auto pixel = *camera.project(at);
    InputEvent event{kind, pixel.first, pixel.second, 0, view::Key::none, false};
    event.finger = which;
    hand.pointer(event, camera, clay());
  }
  void down(double x, double y) { finger(InputEvent::Kind::pointer_down, {x, y, 0}); }
  void move(double x, double y) { finger(InputEvent::Kind::pointer_move, {x, y, 0}); }
  void up() { finger(InputEvent::Kind::pointer_up, {0, 0, 0}); }
  std::size_t laid() const {
    const auto& centre = host.view().coil.centre;
    return centre.size() - static_cast<std::size_t>(std::ranges::count(centre, 0.0f));
  }

  std::optional<double> belongs;
  SceneDef def;
  loop::SteppedWheel host;
  view::Camera camera;
  CoilHand hand{BuildingDef{}.coil};
};

TEST(CoilHand, AFingerThatHoldsStillLaysRingOnRingWhileTheWheelTurns) {
  Builder b;
  const double before = b.rim();
  b.down(0.04, 0.01);
  b.frames(1.2);
  EXPECT_NEAR(static_cast<double>(b.laid()), 61.0, 8.0) << "half a ring";
  b.frames(9.0);
  EXPECT_GT(b.rim(), before + 3 * 0.8 * b.coil()) << "in four turns";
  b.up();
  b.frames(0.5);
  const double then = b.rim();
  const std::size_t lies = b.laid();
  b.frames(3.0);
  EXPECT_NEAR(b.rim(), then, 1e-4) << "a hand that let go lays nothing more";
  EXPECT_NEAR(static_cast<double>(b.laid()), static_cast<double>(lies), 1.0);
}

// A hand that touched the new rim on its way up left a lone ball of clay there.
TEST(CoilHand, WhatLiesIsOnePieceFromRingToRing) {
  Builder b;
  b.down(0.04, 0.01);
  for (double t = 0; t < 9; t += 0.016) {
    b.frames(0.016);
    const auto& centre = b.host.view().coil.centre;
    int pieces = 0;
    for (std::size_t n = 0; n < centre.size(); ++n)
      pieces += centre[n] != 0.0f && centre[(n + 1) % centre.size()] == 0.0f;
    ASSERT_LE(pieces, 1) << "after " << t << " s";
  }
}

TEST(CoilHand, WhereverOnThePotTheFingerIsTheCoilIsOnItsRim) {
  for (const Vec2 at : {Vec2{0.04, 0.01}, {-0.04, 0.15}, {0.0, 0.002}, {0.01, -0.02}, {0.3, 0.1}}) {
    Builder b;
    b.down(at.x, at.y);
    b.frames(1.0);
    EXPECT_GT(b.laid(), 30u) << at.x << ", " << at.y;
    for (const float centre : b.host.view().coil.centre)
      if (centre != 0.0f) {
        EXPECT_NEAR(double{centre}, CoilHand::middle_of_rim(b.clay(), b.coil()), 0.5 * b.coil());
      }
  }
}

TEST(CoilHand, AFingerThatGoesRoundLaysARingOnAWheelThatStands) {
  for (const double way : {1.0, -1.0}) {
    Builder b;
    b.host.wheel(0);
    b.frames(0.5);
    const double before = b.rim(), height = b.rim() + 0.5 * b.coil();
    const double middle = CoilHand::middle_of_rim(b.clay(), b.coil());
    const auto there = [&](double turn) {
      const double a = 0.5 * 3.14159265 + way * 2 * 3.14159265 * turn;  // from the front
      return Vec3{middle * std::cos(a), height, middle * std::sin(a)};
    };
    b.finger(InputEvent::Kind::pointer_down, there(0));
    for (double turn = 0; turn < 1.3 && b.rim() < before + 0.5 * b.coil(); turn += 0.002) {
      b.finger(InputEvent::Kind::pointer_move, there(turn));
      b.frames(0.016);
    }
    b.frames(0.3);
    EXPECT_GT(b.rim(), before + 0.8 * b.coil()) << way;
  }
}

TEST(CoilHand, SidewaysTheFingerOpensOrClosesTheWall) {
  const auto lean = [](double beside) {
    Builder b;
    b.down(0.04, 0.02);
    b.frames(3.0);
    const double middle = CoilHand::middle_of_rim(b.clay(), b.coil());
    b.up();
    b.frames(0.2);
    b.down(middle, 0.1);
    b.move(middle + beside, 0.1);
    b.frames(6.0);
    return CoilHand::middle_of_rim(b.clay(), b.coil()) - middle;
  };
  EXPECT_GT(lean(0.010), 0.003);
  EXPECT_LT(lean(-0.010), -0.003);
  EXPECT_NEAR(lean(0.060), lean(0.010), 0.001) << "by half a coil at most";
}

// A hurried finger made a corner in the ring, and the rim had a notch where nothing would lie.
TEST(CoilHand, AHurriedFingerMovesTheCoilGently) {
  Builder b;
  b.down(0.04, 0.02);
  b.frames(0.5);
  const auto out = [&] {
    const Vec3 at = b.hand.input(b.camera, b.clay()).position;
    return length(Vec2{at.x, at.z});
  };
  double before = out();
  b.move(0.06, 0.02);
  for (int n = 0; n < 40; ++n) {
    b.frames(0.016);
    ASSERT_LT(std::abs(out() - before), 0.02 * 0.016 + 1e-6);
    before = out();
  }
}

TEST(CoilHand, TheCoilLiesWhereTheVesselWantsItAsFarAsTheWallAllows) {
  Builder b;
  b.down(0.04, 0.02);
  b.frames(3.0);
  b.up();
  b.frames(0.3);
  const double middle = CoilHand::middle_of_rim(b.clay(), b.coil());
  for (const double beside : {0.003, -0.003, 0.05, -0.05}) {
    b.belongs = middle + beside;
    b.down(0.04, 0.02);
    b.frames(0.1);
    const Vec3 at = b.hand.input(b.camera, b.clay()).position;
    const double lies = length(Vec2{at.x, at.z}) - middle;
    if (std::abs(beside) < 0.5 * b.coil())
      EXPECT_NEAR(lies, beside, 1e-6);
    else
      EXPECT_NEAR(lies, std::copysign(0.3 * b.coil(), beside), 0.001) << "where the wall ends";
    b.up();
  }
}

TEST(CoilHand, KeysSetItDownAndMoveItAndEscapeLiftsIt) {
  Builder b;
  b.hand.move_by_keys(-1, 0.002);
  ASSERT_TRUE(b.hand.active());
  EXPECT_LT(b.hand.input(b.camera, b.clay()).position.x, 0) << "on the side of the key hand";
  b.frames(3.5);
  EXPECT_GT(b.rim(), 0.010 + 0.8 * b.coil());
  const double at = length(b.hand.input(b.camera, b.clay()).position);
  b.hand.move_by_keys(-1, 0.002);
  b.frames(0.2);
  EXPECT_GT(length(b.hand.input(b.camera, b.clay()).position), at + 0.001);
  b.hand.lift();
  EXPECT_FALSE(b.hand.input(b.camera, b.clay()).active);
}

TEST(CoilHand, LaysOneRingByItselfAndNoMore) {
  Builder b;
  b.hand.lay_a_ring(1, b.clay());
  EXPECT_TRUE(b.hand.by_itself());
  b.frames(8.0);
  EXPECT_FALSE(b.hand.active());
  EXPECT_NEAR(b.rim(), 0.010 + 0.89 * b.coil(), 0.002) << "one ring";
  EXPECT_LT(b.laid(), 30u) << "and hardly the beginning of another";
}

TEST(CoilHand, ASecondFingerChangesNothing) {
  Builder b;
  b.down(0.04, 0.01);
  const HandInput one = b.hand.input(b.camera, b.clay());
  b.finger(InputEvent::Kind::pointer_down, {-0.04, 0.1, 0}, 1);
  b.finger(InputEvent::Kind::pointer_move, {-0.02, 0.1, 0}, 1);
  b.finger(InputEvent::Kind::pointer_up, {-0.02, 0.1, 0}, 1);
  EXPECT_EQ(b.hand.input(b.camera, b.clay()), one);
}

}  // namespace
}  // namespace onggi::screens::coil_hand_test
