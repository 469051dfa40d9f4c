#include "tests/support/engine_trace.h"

#include <algorithm>
#include <sstream>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace onggi {

std::string engine_trace(int seconds, Vectors kind) {
  auto scene = Scene::create({}, kind);
  if (!scene) return "";
  std::ostringstream hashes;
  Hands hands;
  hands.wheel_speed = 21.0;
  for (int n = 0; n < 1000 * seconds; ++n) {
    const double t = n * 0.001;
    HandInput& out = hands.hand[0];
    HandInput& in = hands.hand[1];
    out.active = n % 2500 > 100;
    out.position = {0.064 - 0.006 * portable::sin(2.0 * t), 0.02 + 0.03 * t,
                    0.01 * portable::cos(3.0 * t)};
    in.active = n > 2200 && n < 4800;
    in.side = SideWish::inside;
    in.position = {-0.012 - 0.004 * (t - 2.0), 0.15 - 0.02 * t, 0.002 * portable::sin(40.0 * t)};
    // On the rim, and down through the floor.
    if (n >= 3600 && n < 4500) out.position = {0.050, 0.2075 - 0.001 * (t - 3.6), 0.01};
    if (n >= 3400) in.position.y = std::max(in.position.y - 0.08 * (t - 3.4), 0.011);
    hands.water = n % 1500 < 300;
    hands.renew = n == 5000;
    hands.restore = n == 5500;
    if (n == 3000) out.position.z = 1e300;
    scene->step(hands, n % 7 == 0 ? 0.0023 : 0.001);
    if (n % 1000 == 999) hashes << std::hex << scene->state_hash() << '\n';
  }
  return hashes.str();
}

namespace {

// Two rings of coil laid on a wall between two hands, a third one begun, and the last step undone.
std::uint64_t coils_hash(SceneDef def, Vectors kind) {
  def.building.emplace();
  auto scene = Scene::create(def, kind);
  if (!scene) return 0;
  Hands hands;
  hands.wheel_speed = 5.0;
  for (int n = 0; n < 4000; ++n) {
    hands.hand[0].active = true;
    hands.hand[0].coil = n % 1800 < 1500;
    const double out = hands.hand[0].coil ? 0.045 : 0.058;
    hands.hand[0].position = {out,
                              scene->clay().rim_height() + (hands.hand[0].coil ? 0.0064 : -0.01),
                              0.002 * portable::sin(0.01 * n)};
    hands.hand[1] = {
        {-0.03, scene->clay().rim_height() - 0.012, 0.0}, n % 300 > 150, SideWish::inside};
    hands.restore = n == 3800;
    scene->step(hands, n % 5 == 0 ? 0.0016 : 0.001);
  }
  return scene->state_hash();
}

// A wall that is beaten with an anvil, without one, and from inside, and the last step undone.
std::uint64_t blows_hash(SceneDef def, Vectors kind) {
  def.beating.emplace();
  auto scene = Scene::create(def, kind);
  if (!scene) return 0;
  Hands hands;
  hands.wheel_speed = 3.0;
  for (int n = 0; n < 4000; ++n) {
    HandInput& hand = hands.hand[0];
    hand.active = true;
    hand.paddle = n % 700 < 600;
    hand.blow = n % 90 > 60;
    hand.anvil = n < 2000 ? 1.0 : 0.0;
    hand.position = {n < 3000 ? 0.064 : 0.022, 0.05 + 0.00002 * n, 0.003 * portable::sin(0.02 * n)};
    hands.hand[1] = {{0.026, 0.06 + 0.00002 * n, 0.0}, n % 700 > 500 && n < 3000, SideWish::inside};
    hands.restore = n == 3900;
    scene->step(hands, n % 5 == 0 ? 0.0016 : 0.001);
  }
  return scene->state_hash();
}

}  // namespace

std::string tools_trace(Vectors kind) {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 90;
  def.clay.inner_radius = 0.035;
  each_effect(def, [](auto& effect) { effect.emplace(); });
  def.kiln.reset();      // comes when the wheel stands
  def.building.reset();  // at the end
  def.beating.reset();
  def.prints.reset();
  def.moisture->sponge_height = 0.06;
  auto scene = Scene::create(def, kind);
  if (!scene) return "";
  std::ostringstream hashes;
  constexpr int kTicks = 400;
  for (std::size_t tool = 0; tool <= def.tools.size(); ++tool) {
    Hands hands;
    hands.wheel_speed = 14.0;
    const ToolShape& shape = *find_tool_shape(tool == 0 ? "sphere" : def.tools[tool - 1].name);
    const double off = 0.4 * shape.reach(shape.usual);
    for (int n = 0; n < kTicks; ++n) {
      const double t = n / double{kTicks};
      const bool inside = n >= kTicks / 2;
      HandInput& hand = hands.hand[0];
      hand.tool = static_cast<std::uint8_t>(tool);
      hand.active = n % (kTicks / 2) > 10;
      hand.side = inside ? SideWish::inside : SideWish::outside;
      const double away = inside ? std::max(0.038 - off, 0.002) : 0.053 + off;
      hand.position = {away, 0.06 + 0.1 * t, 0.004 * portable::sin(9.0 * t)};
      hand.roll = 0.5 * t;
      if (tool % 2 == 1) hand.handle = {0.4, 1.0, 0.3 * t};
      hands.hand[1].active = n % 150 > 75;
      hands.hand[1].side = SideWish::inside;
      hands.hand[1].position = {-0.029, 0.05 + 0.08 * t, 0.0};
      hands.water = n % 200 < 40;
      scene->step(hands, n % 5 == 0 ? 0.0016 : 0.001);
    }
    hashes << shape.name << ' ' << std::hex << scene->state_hash() << '\n';
  }
  hashes << "coils " << coils_hash(def, kind) << '\n';
  hashes << "blows " << blows_hash(def, kind) << '\n';
  return hashes.str();
}

}  // namespace onggi
