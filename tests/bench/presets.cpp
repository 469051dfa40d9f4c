#include "tests/bench/presets.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/collection/settings/scene_file.h"
#include "tests/support/effect_scenes.h"

namespace onggi::bench {
namespace {

constexpr int kResting = 3000;  // ticks after the script, of which the last third counts
constexpr int kPasses = 5;

struct Timed {
  std::vector<double> wall, cpu;
};

Scene made(const SceneDef& def) {
  auto scene = Scene::create(def);
  if (scene) return std::move(*scene);
  std::fprintf(stderr, "%s: %s\n", scene.error().where.c_str(), scene.error().what.c_str());
  std::abort();
}

}  // namespace

std::vector<Preset> presets(int rows, int sectors) {
  std::vector<Preset> out;
  for (const char* name : {"first_touch", "studio", "master"}) {
    settings::SceneRead read = settings::read_scene("config/scenes/" + std::string(name) + ".toml");
    if (!read.problems.empty()) {
      std::fprintf(stderr, "%s\n", to_text(read.problems.front()).c_str());
      std::abort();
    }
    read.def.clay.rows = rows;
    read.def.clay.sectors = sectors;
    out.push_back({name, std::move(read.def)});
  }
  return out;
}

ThrowingTimes measure_throwing(const SceneDef& def, std::string_view name, int passes,
                               int most_ticks) {
  Timed thrown;
  Timed resting;
  std::vector<double> least;  // of each tick, of all passes
  const double clock = clock_ns();
  for (int pass = 0; pass < passes; ++pass) {
    Scene scene = made(def);
    const auto script = std::move(*make_script(name, {.scene = def}));
    const int whole = static_cast<int>(script->duration() / kTickSeconds);
    const int ticks = most_ticks > 0 ? std::min(whole, most_ticks) : whole;
    const int rest = most_ticks > 0 ? std::min(kResting, most_ticks) : kResting;
    for (int n = 0; n < ticks + rest; ++n) {
      const Hands hands = n < ticks ? script->at(kTickSeconds * n, scene.clay()) : Hands{};
      const double cpu_before = thread_ns();
      const double wall = timed([&] { scene.step(hands, kTickSeconds); }) - clock;
      const double cpu = thread_ns() - cpu_before;
      if (n >= ticks && n < ticks + rest * 2 / 3) continue;
      if (n < ticks) {
        const auto at = static_cast<std::size_t>(n);
        if (pass == 0) least.push_back(cpu);
        least[at] = std::min(least[at], cpu);
      }
      Timed& kept = n < ticks ? thrown : resting;
      kept.wall.push_back(wall);
      kept.cpu.push_back(cpu);
    }
  }
  ThrowingTimes out;
  out.wall = times_of(thrown.wall);
  out.cpu = times_of(thrown.cpu);
  out.work = times_of(least);
  out.asleep = times_of(resting.wall).median;
  return out;
}

Figures preset_tails(Effort effort) {
  Figures figures;
  double any_tool = 0.0;
  for (const Preset& preset : presets(400, 360)) {
    double fingers = 0.0;
    double fingers_cpu = 0.0;
    for (const ScriptInfo& info : scripts()) {
      const std::string_view script = info.name;
      if (info.shows.empty()) continue;
      if (!make_script(script, {.scene = preset.def})) continue;  // its tool is not to hand
      const ThrowingTimes t =
          measure_throwing(preset.def, script, effort.few ? 1 : kPasses, effort.few ? 40 : 0);
      const std::string each = preset.name + "_" + std::string(script);
      figures.emplace_back("median_us_400x360_" + each, 1e-3 * t.wall.median);
      add_tail(figures, "400x360_" + each, t.wall.p999);
      figures.emplace_back("work_p999_us_400x360_" + each, 1e-3 * t.work.p999);
      any_tool = std::max(any_tool, t.wall.p999);
      if (!info.needs.tool.empty()) continue;
      fingers = std::max(fingers, t.wall.p999);
      fingers_cpu = std::max(fingers_cpu, t.cpu.p999);
    }
    add_tail(figures, "400x360_" + preset.name, fingers);
    add_tail(figures, "400x360_cpu_" + preset.name, fingers_cpu);
  }
  add_tail(figures, "400x360_any_tool", any_tool);
  return figures;
}

Figures finest_studio(Effort effort) {
  for (const Preset& preset : presets(6400, 2880)) {
    if (preset.name != "studio") continue;
    const ThrowingTimes t =
        measure_throwing(preset.def, "pull_tall", effort.few ? 1 : 3, effort.few ? 12 : 0);
    Figures figures;
    add_tail(figures, "6400x2880_studio", t.wall.p999);
    add_tail(figures, "6400x2880_studio_cpu", t.cpu.p999);
    figures.emplace_back("median_us_6400x2880_studio", 1e-3 * t.wall.median);
    figures.emplace_back("worst_us_6400x2880_studio", 1e-3 * t.wall.worst);
    return figures;
  }
  return {};
}

// After hands, since what never was awake is asleep with ease.
Figures asleep(Effort effort) {
  const int passes = effort.few ? 1 : kPasses;
  const int most = effort.few ? 40 : 0;
  SceneDef base = presets(400, 360).front().def;
  base = bare(base);
  const double without = measure_throwing(base, "pull_tall", passes, most).asleep;
  Figures figures{{"asleep_ns_none", without}};
  double worst = 0.0;
  for (const EffectTrial& effect : effect_trials()) {
    SceneDef def = base;
    effect.add(def);
    const double more = measure_throwing(def, "pull_tall", passes, most).asleep - without;
    figures.emplace_back("asleep_ns_more_" + effect.name, more);
    worst = std::max(worst, more);
  }
  figures.insert(figures.begin(), {"asleep_ns_more_worst", worst});
  return figures;
}

Figures tools_pushed(Effort effort) {
  SceneDef def = presets(400, 360).front().def;
  def.clay.keep_undo = false;
  const auto ticks = static_cast<std::size_t>(effort.few ? 40 : 4000);
  Figures figures;
  for (std::size_t tool = 0; tool <= def.tools.size(); ++tool) {
    const std::string name = tool == 0 ? "ball" : def.tools[tool - 1].name;
    if (name == "wire") continue;  // it cuts, and is not held
    std::vector<double> least(ticks, std::numeric_limits<double>::infinity());
    for (int pass = 0; pass < (effort.few ? 1 : kPasses); ++pass) {
      Scene scene = made(def);
      Hands hands;
      hands.wheel_speed = 12.0;
      HandInput& hand = hands.hand[0];
      hand.tool = static_cast<std::uint8_t>(tool);
      hand.side = SideWish::outside;
      hand.position = {def.clay.outer_radius + 0.12, 0.5 * def.clay.height, 0.0};
      hand.active = true;
      while (!scene.step(hands, kTickSeconds).hand[0].contact) hand.position.x -= 2e-4;
      for (std::size_t n = 0; n < ticks; ++n) {
        hand.position.x -= 2.5e-6;
        const double before = thread_ns();
        scene.step(hands, kTickSeconds);
        least[n] = std::min(least[n], thread_ns() - before);
      }
    }
    const Times times = times_of(least);
    figures.emplace_back("work_us_400x360_" + name, 1e-3 * times.median);
    figures.emplace_back("work_p99_us_400x360_" + name, 1e-3 * times.p99);
  }
  return figures;
}

}  // namespace onggi::bench
