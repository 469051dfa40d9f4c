#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "engine/scene/scene.h"

namespace onggi::effects_test {

inline Scene made(const SceneDef& def, Vectors kind = best_vectors()) {
  Result<Scene> scene = Scene::create(def, kind);
  EXPECT_TRUE(scene) << (scene ? "" : to_text(scene.error()));
  return std::move(*scene);
}

/// Hands of somebody who has never seen clay: anywhere, on anything, at any speed.
class RandomHands {
 public:
  explicit RandomHands(std::uint64_t seed) : random_(seed) {}
  const Hands& next() {
    for (std::size_t n = 0; n < hands_.hand.size(); ++n) {
      HandInput& hand = hands_.hand[n];
      if (random_.uniform() < (hand.active ? 0.0005 : 0.01)) hand.active = !hand.active;
      if (random_.uniform() < 0.002) hand.side = static_cast<SideWish>(random_.bits() % 3);
      if (random_.uniform() < 0.005) {
        const double angle = random_.uniform(0.0, 6.28);
        const double out = random_.uniform(0.0, 0.075);
        goal_[n] = {out * portable::cos(angle), random_.uniform(0.0, 0.25),
                    out * portable::sin(angle)};
        speed_[n] = random_.uniform() < 0.1 ? 0.004 : 0.0002;
      }
      const Vec3 way = goal_[n] - hand.position;
      const double far = length(way);
      if (far > 1e-6) hand.position += std::min(1.0, speed_[n] / far) * way;
    }
    if (random_.uniform() < 0.002) hands_.wheel_speed = random_.uniform(-31, 31);
    if (random_.uniform() < 0.002) hands_.water = !hands_.water;
    return hands_;
  }
  double seconds() { return random_.uniform() < 0.1 ? random_.uniform(1e-5, 0.005) : 0.001; }

 private:
  Random random_;
  Hands hands_;
  std::array<Vec3, kMaxHands> goal_;
  std::array<double, kMaxHands> speed_{};
};

/// A wall reshaped is rounded six times, by up to 7.5 nm each at 16 cm, and again at every sweep.
inline constexpr float kRounding = 2e-7f;

/// Rows are stacked, the floor's top lies where it belongs, and no wall is thinner or wider than it
/// may be.
inline void expect_whole(const Clay& clay) {
  const ClayDef& def = clay.def();
  double edge = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    ASSERT_GT(clay.row_thickness(j), 0.0) << j;
    ASSERT_NEAR(clay.row_height(j) - 0.5 * clay.row_thickness(j), edge, 1e-9) << j;
    edge += clay.row_thickness(j);
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
      ASSERT_GE(clay.inner(j)[i], j < clay.floor_rows() ? 0.0f : float(def.radius_min) - kRounding);
      ASSERT_GE(clay.outer(j)[i] - clay.inner(j)[i], float(def.wall_min) - kRounding)
          << j << ' ' << i;
      ASSERT_LE(clay.outer(j)[i], float(def.radius_max) + kRounding) << j << ' ' << i;
    }
  }
  const int floor = clay.floor_rows();
  ASSERT_GE(clay.floor_top(), floor > 0 ? clay.row_height(floor - 1) : 0.0);
  ASSERT_LE(clay.floor_top(), floor < clay.rows() ? clay.row_height(floor) : edge + 1e-9);
}

/// Random hands, the first with `tool`, work `ticks` long on a lump of `def`, which needs volume:
/// no clay is lost.
inline void expect_clay_kept(const SceneDef& def, std::uint64_t seed, int ticks,
                             std::string_view tool = "sphere") {
  Scene scene = made(def);
  const double clay = scene.clay().volume();
  RandomHands random(seed);
  for (int n = 0; n < ticks; ++n) {
    Hands hands = random.next();
    for (std::uint8_t k = 0; k < scene.def().tools.size(); ++k)
      if (scene.def().tools[k].name == tool) hands.hand[0].tool = k + 1;
    scene.step(hands, random.seconds());
    if (n % 500 != 0) continue;
    ASSERT_NEAR(scene.clay().volume() / clay, 1.0, 2e-9) << n;
    ASSERT_NO_FATAL_FAILURE(expect_whole(scene.clay())) << n;
  }
  EXPECT_NE(scene.clay().rim_height(), def.clay.height);
}

}  // namespace onggi::effects_test
