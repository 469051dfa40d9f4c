// A tick of the default scene (400 x 360) at several poses. ns_per_element is the time over the
// elements visited.
#include <benchmark/benchmark.h>

#include <string>

#include "engine/scene/scene.h"

namespace {

using onggi::Hands;
using onggi::Scene;
using onggi::SideWish;
using onggi::Vec3;

struct Pose {
  const char* name;
  Vec3 at;
  bool second_hand;
};

constexpr Pose kPoses[] = {
    {"lifted clear, beside the wall", {0.075, 0.1, 0}, false},
    {"outside, light touch", {0.0625, 0.1, 0}, false},
    {"outside, 2 mm deep and moving", {0.0610, 0.1, 0}, false},
    {"inside, d = 15 mm", {0.015, 0.1, 0}, false},
    {"inside, at the axis", {0.004, 0.1, 0}, false},
    {"both hands on the wall", {0.0625, 0.1, 0}, true},
};

void tick(benchmark::State& state) {
  const Pose& pose = kPoses[state.range(0)];
  onggi::SceneDef def;
  def.clay.rows = static_cast<int>(state.range(1));
  def.clay.sectors = static_cast<int>(state.range(2));
  auto scene = Scene::create(def);
  if (!scene) {
    state.SkipWithError("the scene was refused");
    return;
  }
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.hand[0].active = true;
  hands.hand[1] = {{-0.015, 0.1, 0}, pose.second_hand, SideWish::inside};
  for (int n = 0; n < 1500; ++n) {
    hands.hand[0].position = {0.075 + (pose.at.x - 0.075) * n / 1500.0, 0.3 - 0.2 * n / 1500.0, 0};
    if (pose.at.x < 0.05) hands.hand[0].position = pose.at;
    scene->step(hands, 0.001);
  }
  const auto before = scene->counters();
  double t = 0.0;
  for (auto _ : state) {
    t += 0.001;
    // Up and down the wall, so that there is always fresh clay to press.
    const double swing = t - static_cast<double>(static_cast<long>(t * 2.0)) * 0.5;
    hands.hand[0].position = pose.at + Vec3{0, 0.1 * (swing < 0.25 ? swing : 0.5 - swing), 0};
    benchmark::DoNotOptimize(scene->step(hands, 0.001));
  }
  const auto after = scene->counters();
  const auto visited = static_cast<double>(after.visited_elements - before.visited_elements);
  using benchmark::Counter;
  state.counters["visited"] = Counter(visited, Counter::kAvgIterations);
  state.counters["touched"] =
      Counter(static_cast<double>(after.touched_elements - before.touched_elements),
              Counter::kAvgIterations);
  state.counters["ns_per_element"] =
      Counter(visited * 1e-9, static_cast<Counter::Flags>(Counter::kIsRate | Counter::kInvert));
  state.SetLabel(std::string(pose.name) + ", " + std::to_string(state.range(1)) + " x " +
                 std::to_string(state.range(2)));
}
BENCHMARK(tick)
    ->ArgsProduct({{0, 1, 2, 3, 4, 5}, {400}, {360}})
    ->Args({1, 1600, 720})
    ->Args({4, 1600, 720});

}  // namespace
