#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/wheel/device/pointer_lead.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/support/open_shelf.h"

// A finger that goes to the line and follows it, from wherever it was set down: the wall never
// moves the other way.

namespace onggi::exhibit::drawn_line_test {
namespace {

constexpr int kFrameTicks = 20;
constexpr double kFrame = kFrameTicks * 1e-3;

struct Pots {
  Profile before, after;
};

/// The lump for `target`, and what comes of it when a finger goes down at `start`, rests there for
/// `rest` s, reaches the line at the foot in `approach` s, follows it to nine tenths of its height
/// in `stroke` s and lifts.
Pots drawn(const Scenes& scenes, const std::string& vessel, const Profile& target, Vec2 start,
           double rest, double approach, double stroke, double side) {
  SceneDef def = scenes.of(vessel);
  def.clay.rows = 100;
  def.clay.sectors = 90;
  def.clay = lump_for(target, def);
  loop::SteppedWheel wheel;
  wheel.start(std::make_unique<Scene>(std::move(*Scene::create(def))));
  wheel.wheel(10);
  const auto turn = [&] {
    wheel.advance(kFrameTicks);
    wheel.collect();
  };
  for (int n = 0; n < 25; ++n) turn();
  const ClayView& clay = wheel.view().clay;
  Pots pots{clay.profile(), {}};
  content::Vessel of;
  of.id = vessel;
  const screens::SceneForVisitor scene = scenes.wheel_of(of);
  device::PointerLead hands({scene.palm, scene.palm_radius}, {0, scene.tool_radius});
  const auto line = [&](double share) {
    const double height = 0.9 * share * target.height();
    return Vec2{side * target.outer_at(height), height};
  };
  hands.grab(start, clay, device::Grip::both);
  const auto frame = [&] {
    hands.follow(clay, kFrame,
                 wheel.view().status.feedback.hand[0].contact ||
                     wheel.view().status.feedback.hand[1].contact);
    const auto input = hands.input({1, 0, 0});
    for (int n = 0; n < kMaxHands; ++n) wheel.hand(n, input[static_cast<std::size_t>(n)]);
    turn();
  };
  for (double t = 0; t < rest; t += kFrame) frame();
  for (double t = 0; t < approach + stroke; t += kFrame) {
    const Vec2 foot = line(0);
    const double there = std::min(1.0, t / approach);
    hands.drag(t < approach ? Vec2{start.x + there * (foot.x - start.x),
                                   start.y + there * (foot.y - start.y)}
                            : line((t - approach) / stroke));
    frame();
  }
  hands.release();
  for (double t = 0; t < 6; t += kFrame) frame();
  pots.after = clay.profile();
  return pots;
}

TEST(ALineFollowed, BegunOnTheWheelsHeadNeverMovesTheWallAway) {
  constexpr double kOff = 0.008,
                   kStray = 0.002;  // m: the line is clearly off the lump; a wall's own give
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto read = settings::read_exhibit("config/exhibit.toml");
  const Scenes scenes(read.exhibit);
  for (const content::Vessel& vessel : content::open_shelf("content/vessels").vessels) {
    const Profile target =
        scaled(vessel.extracted.profile, workspace_scale(vessel.extracted.profile));
    for (int n = 0; n < 8; ++n) {
      const double side = n % 2 == 0 ? 1 : -1;
      const Vec2 start{between(-0.12, 0.12), between(-0.06, 0.0)};
      const Pots pots = drawn(scenes, vessel.id, target, start, n < 4 ? 0.0 : between(0.5, 2.0),
                              between(0.2, 0.8), between(0.5, 3.0), side);
      for (double share = 0.15; share < 0.9; share += 0.05) {
        const double height = share * std::min(pots.before.height(), pots.after.height());
        const double before = pots.before.outer_at(height), after = pots.after.outer_at(height);
        const double line = target.outer_at(height);
        const double wanted = line - before, moved = after - before;
        if (wanted < 0 && std::abs(start.x) > before)
          continue;  // the finger comes from beyond the wall
        const bool away = std::abs(wanted) > kOff && std::copysign(moved, wanted * moved) < -kStray;
        EXPECT_FALSE(away) << vessel.id << " from " << start.x << ", " << start.y << ": by "
                           << moved << " at " << height << " where " << wanted << " was wanted";
      }
    }
  }
}

}  // namespace
}  // namespace onggi::exhibit::drawn_line_test
