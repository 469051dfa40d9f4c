// The data of the figure of engine/docs/effects.md: each effect doing what it is for. Equal bits on
// every machine.
// usage: onggi_figure_effects OUT.csv
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

#include "engine/effects/kiln.h"
#include "engine/effects/wobble.h"
#include "engine/math/portable.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"

namespace {

using namespace onggi;

std::FILE* out = nullptr;

void point(const char* effect, const std::string& series, double x, double y) {
  std::fprintf(out, "%s,%s,%.5f,%.5f\n", effect, series.c_str(), x, y);
}

SceneDef bare() {
  SceneDef def;
  def.clay.keep_undo = false;
  each_effect(def, [](auto& effect) { effect.reset(); });
  return def;
}

Scene made(const SceneDef& def) { return std::move(*Scene::create(def)); }

// Steps of 1 ms; `look` every `every` of them.
void run(Scene& scene, double seconds, const std::function<Hands(double)>& hands, int every = 0,
         const std::function<void(double)>& look = {}) {
  for (int n = 0; n < static_cast<int>(seconds * 1000.0); ++n) {
    scene.step(hands(0.001 * n), 0.001);
    if (every > 0 && n % every == 0) look(0.001 * n);
  }
}

Hands finger(double out_to, double height, double wheel = 12.0) {
  Hands hands;
  hands.wheel_speed = wheel;
  hands.hand[0] = {{out_to, height, 0}, true, SideWish::outside};
  return hands;
}

Hands nothing(double wheel = 12.0) {
  Hands hands;
  hands.wheel_speed = wheel;
  return hands;
}

void outline(const char* effect, const char* series, const Clay& clay, double low, double high) {
  for (int j = 0; j < clay.rows(); ++j)
    if (clay.row_height(j) >= low && clay.row_height(j) <= high)
      point(effect, series, 1e3 * double{clay.outer(j)[0]}, 1e3 * clay.row_height(j));
}

void friction() {
  const FrictionDef def;
  for (double slip = -0.05; slip <= 0.0501; slip += 0.001)
    for (const bool wet : {false, true})
      point("friction", wet ? "wet" : "dry", slip,
            effects::friction_force({1, 0, 0}, 1.0, {0, 0, slip},
                                    effects::friction_coefficient(def, wet ? 1.0 : 0.0),
                                    def.slip_speed)
                .z);
}

void moisture() {
  SceneDef def = bare();
  def.moisture = MoistureDef{.sponge_height = 0.05};
  Scene scene = made(def);
  run(
      scene, 120.0,
      [](double t) {
        Hands hands = finger(0.09, 0.1);
        hands.water = (t > 5.0 && t < 7.0) || (t > 70.0 && t < 70.5);
        return hands;
      },
      500,
      [&](double t) {
        point("moisture", "beside the sponge", t, scene.wetness_of(200));
        point("moisture", "far from it", t, scene.wetness_of(360));
      });
}

void walls_and_volume() {
  for (const bool with : {false, true}) {
    SceneDef def = bare();
    def.clay.inner_radius = 0.035;
    if (with) {
      def.walls.emplace();
      def.volume.emplace();
    }
    Scene scene = made(def);
    auto script = std::move(*make_script("pull_tall", {.scene = def}));
    run(scene, script->duration(), [&](double t) { return script->at(t, scene.clay()); });
    const Profile p = scene.clay().profile();
    const char* series = with ? "with" : "without";
    for (const ProfilePoint& at : p.points)
      point("volume", series, 1e3 * at.outer, 1e3 * at.height);
    for (auto at = p.points.rbegin(); at != p.points.rend(); ++at)
      point("volume", series, 1e3 * at->inner, 1e3 * at->height);
  }
}

void propagation() {
  for (const bool with : {false, true}) {
    SceneDef def = bare();
    if (with) def.propagation.emplace();
    Scene scene = made(def);
    run(scene, 3.0, [](double t) { return finger(0.063 - 0.001 * std::min(t, 2.0), 0.1); });
    outline("propagation", with ? "with" : "without", scene.clay(), 0.08, 0.12);
  }
}

void springback() {
  for (const double share : {0.0, 0.15, 0.4}) {
    SceneDef def = bare();
    def.springback = SpringbackDef{.share = share};
    Scene scene = made(def);
    const int row = scene.clay().first_row_above(0.1);
    run(
        scene, 4.0, [](double t) { return t < 0.1 ? finger(0.062, 0.1, 0.0) : nothing(0.0); }, 10,
        [&](double t) {
          point("springback", std::to_string(static_cast<int>(100.0 * share)) + " %", t,
                1e3 * (0.055 - double{scene.clay().outer(row)[0]}));
        });
  }
}

void smoothing() {
  SceneDef def = bare();
  def.smoothing.emplace();
  def.volume.emplace();
  Scene scene = made(def);
  auto script = std::move(*make_script("rib_smooth", {.scene = def}));
  bool line = true;
  run(scene, script->duration(), [&](double t) {
    if (line && script->phase(t) == "rib") {
      line = false;
      outline("smoothing", "before", scene.clay(), 0.06, 0.14);
    }
    return script->at(t, scene.clay());
  });
  outline("smoothing", "after", scene.clay(), 0.06, 0.14);
}

void wobble() {
  for (const bool pressed : {false, true}) {
    SceneDef def = bare();
    def.wobble.emplace();
    def.volume.emplace();
    Scene scene = made(def);
    auto script = std::move(*make_script("centre", {.scene = def}));
    const int row = scene.clay().rows() / 2;
    run(
        scene, script->duration(),
        [&](double t) { return pressed ? script->at(t, scene.clay()) : nothing(25.0); }, 50,
        [&](double t) {
          const effects::OffCentre off = effects::off_centre_of(scene.clay(), row);
          point("wobble", pressed ? "pressed" : "left alone", t,
                1e3 * std::sqrt(off.x * off.x + off.z * off.z));
        });
  }
}

// A cylinder opened with one finger, until a ring is wider than the scene lets it be. Seen as what
// the finger feels.
void tearing() {
  for (const bool with : {false, true}) {
    SceneDef def = bare();
    def.clay.rows = 200;
    def.clay.sectors = 180;
    def.clay.inner_radius = 0.045;
    def.clay.wall_min = 0.002;
    def.volume.emplace();
    def.walls = WallsDef{.tear_strain = with ? 0.3 : 0.0};
    Scene scene = made(def);
    const auto opened = [](double t) { return 0.035 + 0.001 * std::clamp(t - 1.0, 0.0, 30.0); };
    double sum = 0.0;
    double radius = 0.0;
    int ticks = 0;
    for (int n = 0; n < 26000; ++n) {
      const double t = 0.001 * n;
      Hands hands = nothing(18.0);
      hands.hand[0] = {{opened(t), 0.1, 0}, true, SideWish::inside};
      sum += length(scene.step(hands, 0.001).hand[0].force);
      radius += opened(t) + def.tool.radius;
      if (++ticks < 250) continue;
      point("tearing", with ? "with" : "without", 1e3 * radius / ticks, sum / ticks);
      sum = radius = 0.0;
      ticks = 0;
    }
  }
}

void kiln() {
  for (const ClayBody& body : clay_bodies()) {
    const KilnDef def{body.drying_shrinkage, body.firing_shrinkage};
    for (double step = 0.0; step <= 2.001; step += 0.05)
      point("kiln", std::string(body.name), step,
            100.0 * size_after(def, {std::min(step, 1.0), std::max(step - 1.0, 0.0)}));
  }
}

void slump() {
  for (const double height : {0.25, 0.45, 0.5, 0.6}) {
    SceneDef def = bare();
    def.clay.rows = 200;
    def.clay.height = height;
    def.clay.inner_radius = 0.045;
    def.clay.floor_thickness = 0.0;
    def.volume.emplace();
    def.slump = SlumpDef{.yield_stress = 5000.0};
    def.moisture.emplace();
    Scene scene = made(def);
    run(
        scene, 40.0,
        [&](double t) {
          Hands hands;
          hands.water = height < 0.3 && t > 20.0 && t < 21.0;  // this one is soaked
          return hands;
        },
        100,
        [&](double t) {
          point("slump", std::to_string(static_cast<int>(100.0 * height)) + " cm", t,
                1e2 * scene.clay().rim_height());
        });
  }
}

// Five rings of coil on a disc.
SceneDef coils() {
  SceneDef def = bare();
  def.clay.rows = 20;
  def.clay.height = def.clay.floor_thickness = 0.010;
  def.volume.emplace();
  def.building.emplace();
  return def;
}
void play(Scene& scene, const char* name) {
  const auto script = std::move(*make_script(name, {.scene = scene.def()}));
  run(scene, script->duration(), [&](double t) { return script->at(t, scene.clay()); });
}
void both_faces(const Clay& clay, const char* effect, const char* series) {
  for (int j = clay.floor_rows(); j < clay.rows(); ++j)
    point(effect, series, 1e3 * double{clay.outer(j)[0]}, 1e3 * clay.row_height(j));
  for (int j = clay.rows() - 1; j >= clay.floor_rows(); --j)
    point(effect, series, 1e3 * double{clay.inner(j)[0]}, 1e3 * clay.row_height(j));
}

// Then pinched between two fingers that go up round by round.
void building() {
  Scene scene = made(coils());
  play(scene, "coil_up");
  both_faces(scene.clay(), "building", "laid");
  const double middle = 0.0487, finger = scene.def().tool.radius, gap = 0.0095;
  run(scene, 30.0, [&](double t) {
    Hands hands;
    hands.wheel_speed = 12.0;
    const double height = 0.02 + (scene.clay().rim_height() - 0.022) * t / 30.0;
    const double lean = 0.04 * (height - 0.01);
    hands.hand[0] = {{middle + lean + 0.5 * gap + finger, height, 0}, true, SideWish::outside};
    hands.hand[1] = {{middle + lean - 0.5 * gap - finger, height, 0}, true, SideWish::inside};
    return hands;
  });
  both_faces(scene.clay(), "building", "pinched");
}

// Or beaten, with soft clay, once up the wall: 23 blows.
void beating() {
  SceneDef def = coils();
  def.beating = BeatingDef{0.08, 0.03, 16e3};
  Scene scene = made(def);
  play(scene, "coil_up");
  both_faces(scene.clay(), "beating", "laid");
  play(scene, "beat");
  both_faces(scene.clay(), "beating", "beaten");
}

}  // namespace

int main(int argc, char** argv) {
  out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_effects OUT.csv (a file that can be written)\n");
    return 2;
  }
  std::fprintf(out,
               "# What each effect does, on the default lump: engine/docs/effects.md.\n"
               "effect,series,x,y\n");
  friction();
  moisture();
  walls_and_volume();
  propagation();
  springback();
  smoothing();
  wobble();
  slump();
  tearing();
  kiln();
  building();
  beating();
  return std::fclose(out) == 0 ? 0 : 1;
}
