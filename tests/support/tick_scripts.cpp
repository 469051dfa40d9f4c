#include "tests/support/tick_scripts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace onggi {
namespace {

constexpr double kSlow = 18.0;  // rad/s: 172 rpm, a potter's usual pace
constexpr double kFast = 31.4;  // 300 rpm, the wheel's fastest
constexpr double kLowest = 0.03;
constexpr double kHighest = 0.15;

// The tool is the default sphere of 8 mm. Distances are such that it stands 0.5 to 2 mm deep.
constexpr std::array<TickScript, 9> kScripts{{
    {"beside_the_wall", "a hand held 12 mm off the wall, 172 rpm", 0.022, 0.055, 0.075, 0.02, kSlow,
     WallSide::outside, 0, false},
    {"light_touch", "0.5 mm deep outside, 172 rpm", 0.022, 0.055, 0.0625, 0.02, kSlow,
     WallSide::outside, 0, true},
    {"deep_and_moving", "2 mm deep outside and rising, 172 rpm", 0.022, 0.055, 0.061, 0.04, kSlow,
     WallSide::outside, 0, true},
    {"quick_stroke", "0.5 mm deep outside, rising 0.5 m/s at 300 rpm", 0.022, 0.055, 0.0625, 0.5,
     kFast, WallSide::outside, 0, true},
    {"outside_29_mm", "1 mm deep outside a neck, centre 29 mm from the axis", 0.010, 0.022, 0.029,
     0.03, kSlow, WallSide::outside, 0, true},
    {"inside_29_mm", "1 mm deep inside, centre 29 mm from the axis", 0.036, 0.055, 0.029, 0.03,
     kSlow, WallSide::inside, 0, true},
    {"inside_12_mm", "1 mm deep inside, centre 12 mm from the axis", 0.019, 0.055, 0.012, 0.03,
     kSlow, WallSide::inside, 0, true},
    {"both_hands", "the wall between two hands, 0.5 mm deep each", 0.047, 0.055, 0.0625, 0.02,
     kSlow, WallSide::outside, 0.0395, true},
    {"at_the_axis", "0.5 mm from the axis, pressing all round", 0.0075, 0.055, 0.0005, 0.03, kSlow,
     WallSide::inside, 0, true},
}};

}  // namespace

SceneDef TickScript::scene(int rows, int sectors) const {
  SceneDef def;
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.inner_radius = inner_radius;
  def.clay.outer_radius = outer_radius;
  def.clay.keep_undo = false;
  def.wheel.acceleration = 1000.0;  // at speed within 32 ms
  return def;
}

Hands TickScript::hands(int n) const {
  Hands hands;
  hands.wheel_speed = wheel_speed;
  const double height = kLowest + rise * kTickSeconds * n;
  hands.hand[0] = {{distance, height, 0.0},
                   true,
                   side == WallSide::inside ? SideWish::inside : SideWish::outside};
  if (second_distance > 0.0)
    hands.hand[1] = {{second_distance, height, 0.0}, true, SideWish::inside};
  return hands;
}

int TickScript::pass() const {
  return static_cast<int>(std::lround((kHighest - kLowest) / (rise * kTickSeconds)));
}

std::span<const TickScript> tick_scripts() { return kScripts; }

const TickScript& tick_script(std::string_view name) {
  const auto found = std::ranges::find(kScripts, name, &TickScript::name);
  if (found != kScripts.end()) return *found;
  std::fprintf(stderr, "There is no tick script \"%.*s\".\n", static_cast<int>(name.size()),
               name.data());
  std::abort();
}

int renew_clay(Scene& scene, double wheel_speed) {
  Hands hands;
  hands.wheel_speed = wheel_speed;
  hands.renew = true;
  // The first row that it lays is dirty again, and so on to the last: then it is done.
  while (scene.take_dirty_row(0) >= 0) {
  }
  int ticks = 0;
  for (int row = 0; row < scene.clay().rows(); ++ticks) {
    scene.step(hands, kTickSeconds);
    hands.renew = false;
    for (int taken = scene.take_dirty_row(row); taken >= 0; taken = scene.take_dirty_row(row))
      row = taken + 1;
  }
  return ticks;
}

}  // namespace onggi
