#include "kiosk/picture/render/tool_painter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

// What a hand holds is drawn as the body that the engine presses with, where the engine has it.

namespace onggi::render::testing::tool_painter_test {
namespace {

using AHand = StudioTest;

struct Box {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  void take(double x, double y) {
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
};

/// Points that cover the surface of a hand's working body, by its description (HandView).
std::vector<Vec3> surface_of(const HandView& hand) {
  const Vec3 third = cross(hand.along, hand.across);
  std::vector<Vec3> points;
  constexpr int kTurn = 48;
  for (int i = 0; i < kTurn; ++i) {
    const double a = 2 * 3.14159265358979 * i / kTurn;
    for (int k = -12; k <= 12; ++k) {
      const double s = k / 12.0, ring = std::sqrt(1 - s * s);
      const Vec3 round = std::cos(a) * hand.across + std::sin(a) * third;
      switch (hand.body) {
        case BodyKind::ball:
        case BodyKind::capsule:
          points.push_back(hand.at + hand.radius * (ring * round + s * hand.along) +
                           (s > 0 && hand.body == BodyKind::capsule ? hand.length : 0.0) *
                               hand.along);
          break;
        case BodyKind::box:
          points.push_back(hand.at + (i % 2 == 0 ? 0.5 : -0.5) * hand.length * hand.along +
                           (i % 4 < 2 ? 0.5 : -0.5) * hand.thickness * hand.across +
                           s * hand.radius * third);
          break;
        case BodyKind::cylinder:
          points.push_back(hand.at + 0.5 * s * hand.thickness * hand.across +
                           hand.radius * (std::cos(a) * hand.along + std::sin(a) * third));
          break;
        case BodyKind::wire:
          points.push_back(hand.at + 0.5 * s * hand.length * hand.along);
          break;
      }
    }
  }
  return points;
}

/// A hand of a real scene that holds its `tool` before the camera, high over the wheel.
HandView held(const char* name, Vec3 handle, double roll) {
  SceneDef def;
  def.clay.rows = 40;
  def.clay.sectors = 32;
  Scene scene = std::move(*Scene::create(def));
  Hands hands;
  hands.hand[0].active = true;
  hands.hand[0].position = {0.03, 0.30, 0.06};
  hands.hand[0].handle = handle;
  hands.hand[0].roll = roll;
  for (std::size_t k = 0; k < def.tools.size(); ++k)
    if (def.tools[k].name == name) hands.hand[0].tool = static_cast<std::uint8_t>(k + 1);
  scene.step(hands, 0.001);
  return scene.hand(0);
}

struct Held {
  const char* name;
  bool more;  ///< A finger or a handle goes on beyond the body.
};
constexpr Held kTools[] = {{"sphere", true},      {"fingertip", true}, {"flat_rib", false},
                           {"curved_rib", false}, {"needle", true},    {"loop_trimmer", true},
                           {"sponge", false},     {"wire", true}};

TEST_F(AHand, EveryToolIsDrawnAsItsBodyWhereItIsHoweverItIsHeld) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(
      grid_of(40, 32, 0.05, 0.01), [](double) { return 0.03; }, 0.005, 0.0));
  view::Frame frame = frame_with_pot(1600, 1600, 0.5, 0.2);
  const view::Image empty = r.draw_offscreen(frame);
  for (const Held& tool : kTools)
    for (const auto& [handle, roll] :
         {std::pair{Vec3{}, 0.0}, {Vec3{0.3, 0.8, 0.2}, 0.0}, {Vec3{-0.6, 0.5, 0.7}, 1.1}}) {
      const HandView hand = held(tool.name, handle, roll);
      ASSERT_EQ(hand.name, tool.name);
      ASSERT_TRUE(hand.present);
      frame.pot->hands[0] = hand;
      const view::Image image = r.draw_offscreen(frame);
      Box drawn, body;
      const auto unlike = [&](int x, int y) {
        const Pixel p = pixel_at(image, x, y), q = pixel_at(empty, x, y);
        return std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 18;
      };
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          if (unlike(x, y)) drawn.take(x + 0.5, y + 0.5);
      for (const Vec3& p : surface_of(hand)) {
        const auto at = *frame.pot->camera.project(p);
        body.take(at.first, at.second);
      }
      // A finger's edge is soft.
      const double soft = tool.more ? 5.0 : 2.0;
      const std::string which = std::string(tool.name) + ", rolled " + std::to_string(roll);
      EXPECT_LT(drawn.left, body.left + soft) << which;
      EXPECT_GT(drawn.right, body.right - soft) << which;
      EXPECT_LT(drawn.top, body.top + soft) << which;
      EXPECT_GT(drawn.bottom, body.bottom - soft) << which;
      if (!tool.more) {
        EXPECT_GT(drawn.left, body.left - 2.0) << which;
        EXPECT_LT(drawn.right, body.right + 2.0) << which;
        EXPECT_GT(drawn.top, body.top - 2.0) << which;
        EXPECT_LT(drawn.bottom, body.bottom + 2.0) << which;
      }
      // And nothing is farther away than the picture makes room for.
      const auto middle = *frame.pot->camera.project(hand.at);
      const double room = ToolPainter::reach(hand) * 1.15 * image.height /
                          (frame.pot->camera.distance * 2 * std::tan(frame.pot->camera.fov / 2));
      for (const auto& [x, y] : {std::pair{drawn.left, drawn.top}, {drawn.right, drawn.bottom}}) {
        EXPECT_LT(std::abs(x - middle.first), room + 3.0) << which;
        EXPECT_LT(std::abs(y - middle.second), room + 3.0) << which;
      }
    }
}

double vase(double t) { return 0.040 + 0.022 * std::sin(3.0 * t + 0.1); }

// For people to look at: every tool at the wall of a vase, as a potter holds it.
TEST_F(AHand, EveryToolAtTheWall) {
  Renderer& r = renderer();
  const ClayDef grid = grid_of(400, 360, 0.20, 0.010);
  r.show_clay(thrown_clay(grid, vase, 0.005, 0.0002));
  for (const Held& tool : kTools) {
    HandView hand = held(tool.name, {}, 0.0);
    view::Frame frame = frame_with_pot(kWidth, kHeight, 0.20, 0.066);
    frame.pot->wheel_angle = frame.pot->clay_angle = 1.2;
    frame.pot->wetness = 0.3;
    const view::Image without = r.draw_offscreen(frame);
    SceneDef def;
    def.clay = grid;
    def.clay.outer_radius = 0.062;
    Scene scene = std::move(*Scene::create(def));
    Hands hands;
    hands.hand[0].active = true;
    hands.hand[0].side = SideWish::outside;
    hands.hand[0].tool = hand.tool;
    const double off = hand.body == BodyKind::box ? 0.5 * hand.thickness : hand.radius;
    hands.hand[0].position = {0.92 * (0.0615 + off), 0.11, 0.39 * (0.0615 + off)};
    if (hand.body == BodyKind::wire) hands.hand[0].position = {0.0, 0.004, 0.075};
    scene.step(hands, 0.001);
    frame.pot->hands[0] = scene.hand(0);
    const view::Image image = r.draw_offscreen(frame);
    keep_for_looking(image, std::string("tool_") + tool.name);
    EXPECT_NE(image.rgba, without.rgba) << tool.name;
  }
}

// A grey wedge stood outside the shoulder, and the rim was torn into steps.
TEST(AFinger, WithinAPotStaysWithinItsWallUnderAShoulderAndANeck) {
  Levels jar;
  jar.height = 0.2;
  for (int n = 0; n < kLevels; ++n) {
    const float y = 0.2f * (static_cast<float>(n) + 0.5f) / kLevels;
    const float shoulder = std::clamp((y - 0.12f) / 0.05f, 0.0f, 1.0f);
    jar.inner[static_cast<std::size_t>(n)] = 0.07f - 0.04f * shoulder;
    jar.outer[static_cast<std::size_t>(n)] = jar.inner[static_cast<std::size_t>(n)] + 0.006f;
  }
  HandView hand;
  hand.radius = 0.008;
  const auto inner = [&](double y) {
    return jar.inner[static_cast<std::size_t>(std::clamp(y / 0.2, 0.0, 0.999) * kLevels)];
  };
  for (double y = 0.02; y < 0.19; y += 0.005) {
    hand.at = {0.0, y, -(inner(y) - 0.008)};
    const glm::vec3 lean = finger_lean(hand, jar);
    EXPECT_NEAR(glm::length(lean), 1.0f, 1e-6f);
    EXPECT_GT(lean.y, 0.5f);
    for (float along = 0.010f; along < 0.024f; along += 0.002f) {
      const glm::vec3 at = glm::vec3(0, y, hand.at.z) + along * lean;
      if (at.y > 0.2f) break;
      EXPECT_LT(std::fabs(at.z), inner(at.y) - 0.003f) << y << ", " << along;
    }
  }
}

}  // namespace
}  // namespace onggi::render::testing::tool_painter_test
