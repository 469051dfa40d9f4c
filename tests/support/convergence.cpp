#include "tests/support/convergence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/support/effect_scenes.h"

namespace onggi::refinement {
namespace {

constexpr int kHeights = 256;
constexpr double kClear = 0.001;  // m: where a stroke begins and ends
constexpr double kStroke = 1.0;   // s
constexpr double kWheel = 12.0;   // rad/s

// 0..1 over 0..1 with three even derivatives: no corner for an order to break on.
double eased(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * t * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t)));
}

// A finger on one face: in by `deep` from clear, up the wall, and out again.
HandInput finger(const SceneDef& def, WallSide side, double deep, double u) {
  const double way =
      (kClear + deep) * (eased((u - 0.05) / 0.35) - eased((u - 0.65) / 0.3)) - kClear;
  HandInput hand;
  hand.active = true;
  const bool outside = side == WallSide::outside;
  hand.side = outside ? SideWish::outside : SideWish::inside;
  const double from = outside ? def.clay.outer_radius + def.tool.radius - way
                              : def.clay.inner_radius - def.tool.radius + way;
  hand.position = {from, def.clay.height * (0.35 + 0.15 * eased(u)), 0.0};
  return hand;
}

Stroke stroke(const SceneDef& def, bool both, double deep, bool water = false) {
  return {kStroke, [=](double t) {
            Hands hands;
            hands.wheel_speed = kWheel;
            hands.water = water && t < 0.5 * kStroke;
            hands.hand[0] = finger(def, WallSide::outside, deep, t / kStroke);
            if (both) hands.hand[1] = finger(def, WallSide::inside, deep, t / kStroke);
            return hands;
          }};
}

// The same with a sponge, which is larger.
Stroke sponge_stroke(const SceneDef& def, double deep) {
  std::size_t n = 0;
  while (def.tools[n].name != "sponge") ++n;
  const double larger = find_tool_shape("sponge")->usual.radius - def.tool.radius;
  const Stroke of_finger = stroke(def, false, deep);
  return {kStroke, [=](double t) {
            Hands hands = of_finger.hands(t);
            hands.hand[0].tool = static_cast<std::uint8_t>(n + 1);
            hands.hand[0].position.x += larger;
            return hands;
          }};
}

// A wall of 1 cm that can be pressed from both sides, and a guard that leaves forces alone.
SceneDef on_a_wall(SceneDef def) {
  def.clay.rows = 200;
  def.clay.sectors = 180;
  def.clay.inner_radius = 0.045;
  def.clay.keep_undo = false;
  def.wheel.acceleration = 1000.0;
  return def;
}

double mean_order(double coarsest, double finest) {
  return finest > 0.0 && coarsest > 0.0 ? 0.5 * std::log2(coarsest / finest) : 0.0;
}

Refined refined(const std::array<Outcome, 4>& of) {
  const Apart first = apart(of[0], of[1]);
  const Apart last = apart(of[2], of[3]);
  Refined out;
  out.order = {mean_order(first.shape, last.shape), mean_order(first.force, last.force),
               mean_order(first.impulse, last.impulse)};
  out.finest = last;
  return out;
}

}  // namespace

Outcome outcome_of(const Work& work, double tick, int rows) {
  SceneDef def = work.def;
  def.clay.sectors = rows * def.clay.sectors / def.clay.rows;
  def.clay.rows = rows;
  Result<Scene> made = Scene::create(def);
  if (!made) {
    std::fprintf(stderr, "%s: %s\n", made.error().where.c_str(), made.error().what.c_str());
    std::abort();
  }
  Scene& scene = *made;
  Outcome out;
  const long ticks = std::lround(work.stroke.seconds / tick);
  const long window = std::lround(kWindow / tick);
  std::array<Vec3, kMaxHands> sum{};
  for (long n = 1; n <= ticks; ++n) {
    const Feedback felt = scene.step(work.stroke.hands(tick * static_cast<double>(n)), tick);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += tick * felt.hand[k].force;
    out.impulse += tick * felt.hand[0].force;
    if (n % window != 0) continue;
    for (Vec3& impulse : sum) {
      out.force.push_back((1.0 / kWindow) * impulse);
      impulse = {};
    }
  }
  // Between the floor, whose top lies where a row does, and the rim, which may have sunk.
  const Profile p = scene.clay().profile();
  for (int k = 0; k < kHeights; ++k) {
    const double h = def.clay.height * (0.1 + 0.8 * k / kHeights);
    out.outline.push_back(p.outer_at(h));
    out.outline.push_back(p.inner_at(h));
  }
  return out;
}

Apart apart(const Outcome& a, const Outcome& b) {
  Apart d;
  for (std::size_t n = 0; n < a.outline.size(); ++n) {
    const double by = a.outline[n] - b.outline[n];
    d.shape += by * by;
  }
  d.shape = std::sqrt(d.shape / static_cast<double>(a.outline.size()));
  for (std::size_t n = 0; n < a.force.size(); ++n) {
    const Vec3 by = a.force[n] - b.force[n];
    d.force += dot(by, by);
  }
  d.force = std::sqrt(d.force / static_cast<double>(a.force.size()));
  d.impulse = length(a.impulse - b.impulse) / length(b.impulse);
  return d;
}

Refined refine_ticks(const Work& work) {
  const int rows = work.def.clay.rows;
  const std::array<Outcome, 4> of{outcome_of(work, 1e-3, rows), outcome_of(work, 5e-4, rows),
                                  outcome_of(work, 2.5e-4, rows), outcome_of(work, 1.25e-4, rows)};
  Refined out = refined(of);
  for (const double tick : {2e-3, 2.5e-3, 5e-3})
    out.impulse_off = std::max(out.impulse_off, apart(outcome_of(work, tick, rows), of[3]).impulse);
  for (const int n : {0, 1})
    out.impulse_off =
        std::max(out.impulse_off, apart(of[static_cast<std::size_t>(n)], of[3]).impulse);
  return out;
}

Refined refine_grids(const Work& work) {
  const std::array<Outcome, 4> of{outcome_of(work, 1e-3, 100), outcome_of(work, 1e-3, 200),
                                  outcome_of(work, 1e-3, 400), outcome_of(work, 1e-3, 800)};
  Refined out = refined(of);
  out.impulse_off = apart(of[0], of[3]).impulse;
  return out;
}

std::vector<Work> effect_works() {
  constexpr double kDeep = 0.0015;
  SceneDef base = on_a_wall(bare());
  base.clay.wall_min = 0.002;
  base.guard = {22.0, 1e5, 0.05};
  std::vector<Work> works{{"contact", base, stroke(base, false, kDeep)}};
  for (const EffectTrial& effect : effect_trials()) {
    if (effect.name == "kiln") continue;  // no stage of the tick
    SceneDef def = base;
    effect.add(def);
    if (effect.name == "slump") def.slump->yield_stress = 1500.0;
    works.push_back({effect.name, def, stroke(def, false, kDeep, effect.name == "moisture")});
    if (effect.name == "smoothing") works.back().stroke = sponge_stroke(def, kDeep);
    if (effect.name == "walls")
      works.push_back({"walls, two hands", def, stroke(def, true, 0.001)});
  }
  return works;
}

std::vector<Work> scene_works(const std::string& name, SceneDef def) {
  if (!def.paper) def = on_a_wall(std::move(def));
  def.clay.rows = 200;
  def.clay.sectors = 180;
  std::vector<Work> works{{name, def, stroke(def, false, 0.0015)}};
  if (!def.paper) works.push_back({name + ", two hands", def, stroke(def, true, 0.001)});
  return works;
}

}  // namespace onggi::refinement
