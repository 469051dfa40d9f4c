// What a hand at a force device feels: how rough and how late its force is, of every tool in every
// scene of config/scenes, beside the printed model's; and what wet, stiff, thin and an edge do to
// it. Equal bits on every machine. usage: onggi_figure_feel OUT.csv [--quick]   in the project's
// root; --quick: one scene, few tools
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "kiosk/collection/settings/scene_file.h"
#include "tests/support/force_quality.h"

namespace {

using namespace onggi;

constexpr double kBest = 257.0, kLeast = 19.0;  // N/m: what the best and the least device bear
constexpr std::size_t kSettles = 400;           // ms
std::FILE* out = nullptr;

// One row for all kinds: what, which, then figures; what is not there is left empty.
void quality(const char* scene, const std::string& tool, const test::ForceQuality& q) {
  std::fprintf(out, "tool,%s,%s,%.4f,%.4f,%.4f,%.3f,%.4f,\n", scene, tool.c_str(), q.mean,
               1e3 * q.increment, 1e3 * q.above_50, 1e3 * q.lag, 1e3 * q.own);
}

// Mean over the push of the force inwards, of what pulls sideways, and how the first grows.
void felt(const char* what, const SceneDef& def, bool wet) {
  test::SlowPush push;
  push.wet = wet;
  push.coupling = kBest;
  double in = 0.0, side = 0.0, most = 0.0;
  const std::vector<Vec3> force = test::push_slowly(def, push);
  for (std::size_t n = kSettles; n < force.size(); ++n) {
    in += force[n].x / static_cast<double>(force.size() - kSettles);
    side += std::fabs(force[n].z) / static_cast<double>(force.size() - kSettles);
    most = std::max(most, length(force[n]));
  }
  std::fprintf(out, "clay,%s,,%.4f,%.4f,%.4f,,,\n", what, in, side, most);
}

// A ball 2 mm deep in the wall goes up over the lip at 20 mm/s.
void rim(const SceneDef& given) {
  SceneDef def = given;
  def.guard = {22.2, 1e5, 0.05};
  def.wheel.acceleration = 100.0;
  auto scene = Scene::create(def);
  if (!scene) return;
  Hands hands;
  hands.wheel_speed = 6.28;
  for (int n = 0; n < 1000; ++n) scene->step(hands, 0.001);
  HandInput& hand = hands.hand[0];
  hand.active = true;
  hand.side = SideWish::outside;
  for (int n = 0; n < 1900; ++n) {
    const double below = 0.022 - 2e-5 * n;
    const double in = 0.002 * std::min(1.0, n / 200.0);
    hand.position = {def.clay.outer_radius + def.tool.radius - in, def.clay.height - below, 0.0};
    const Vec3 force = scene->step(hands, 0.001).hand[0].force;
    if (n % 5 == 0) std::fprintf(out, "rim,,,%.4f,%.4f,%.4f,,,\n", -1e3 * below, force.x, force.y);
  }
}

// 160 ms of the force less what it is in the mean of 41 of them: what trembles.
void trembling(const char* whose, const std::vector<Vec3>& force) {
  constexpr std::size_t kBegins = 1200, kEnds = 1360, kHalf = 20;
  if (force.size() < kEnds + kHalf) return;
  for (std::size_t n = kBegins; n < kEnds; ++n) {
    double mean = 0.0;
    for (std::size_t k = n - kHalf; k <= n + kHalf; ++k) mean += force[k].x / (2 * kHalf + 1);
    std::fprintf(out, "trace,%s,,%zu,%.4f,,,,\n", whose, n - kBegins, 1e3 * (force[n].x - mean));
  }
}

SceneDef scene_named(const char* name) {
  SceneDef def = settings::read_scene("config/scenes/" + std::string(name) + ".toml").def;
  def.clay.keep_undo = false;
  return def;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || (out = std::fopen(argv[1], "w")) == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_feel OUT.csv [--quick]\n");
    return 2;
  }
  const bool quick = argc > 2 && std::strcmp(argv[2], "--quick") == 0;
  std::fprintf(out, "kind,which,tool,a,b,c,d,e,f\n");
  const test::PrintedQuality printed = test::printed_quality(SceneDef());
  quality("as printed", "raw", printed.raw);
  quality("as printed", "behind 10 Hz", printed.filtered);
  for (const char* name : {"first_touch", "studio", "master"}) {
    if (quick && std::strcmp(name, "first_touch") != 0) continue;
    const SceneDef def = scene_named(name);
    quality(name, "printed behind 10 Hz", test::printed_quality(def).filtered);
    for (std::size_t tool = 0; tool <= def.tools.size(); ++tool) {
      const std::string called = tool == 0 ? "ball" : def.tools[tool - 1].name;
      if (called == "wire" || (quick && tool > 1)) continue;
      const auto number = static_cast<std::uint8_t>(tool);
      quality(name, called, test::scenes_quality(def, number, kBest));
      if (tool == 0) quality(name, "ball as it comes", test::scenes_quality(def, number));
      if (tool == 0)
        quality(name, "ball through 19 N/m", test::scenes_quality(def, number, kLeast));
    }
  }

  const SceneDef first = scene_named("first_touch");
  felt("dry", first, false);
  felt("wet", first, true);
  SceneDef other = first;
  other.contact.stiffness *= 2.0;
  felt("twice the stiffness", other, false);
  other = first;
  other.contact.relaxation_time *= 2.0;
  felt("gives way in twice the time", other, false);
  other = first;
  other.clay.inner_radius = other.clay.outer_radius - 0.005;
  felt("a wall of 5 mm", other, false);
  const SceneDef studio = scene_named("studio");
  for (const double thickness : {0.033, 0.008, 0.005, 0.003}) {
    other = studio;
    other.clay.wall_min = 0.001;
    other.clay.inner_radius = other.clay.outer_radius - thickness;
    char name[40];
    std::snprintf(name, sizeof name, "studio: a wall of %.0f mm", 1e3 * thickness);
    felt(name, other, false);
  }
  rim(first);
  test::SlowPush push;
  std::vector<Vec3> own = test::push_slowly(first, push);
  trembling("a scene's own", own);
  push.coupling = kBest;
  trembling("at the hand", test::push_slowly(first, push));
  return std::fclose(out) == 0 ? 0 : 1;
}
