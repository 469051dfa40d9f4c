#include "engine/lab/scene_work.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/contact/tool.h"
#include "engine/effects/building.h"
#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr int kHeights = 256;
constexpr double kHandClear = 0.001;  // m: where a stroke begins and ends
constexpr double kWorkSeconds = 1.0;
constexpr double kWorkWheel = 12.0;  // rad/s

// A finger on one face: in by `deep` from clear, up the wall, and out again.
HandInput finger(const SceneDef& def, WallSide side, double deep, double u) {
  const double way =
      (kHandClear + deep) * (eased((u - 0.05) / 0.35) - eased((u - 0.65) / 0.3)) - kHandClear;
  HandInput hand;
  hand.active = true;
  const bool outside = side == WallSide::outside;
  hand.side = outside ? SideWish::outside : SideWish::inside;
  const double from = outside ? def.clay.outer_radius + def.tool.radius - way
                              : def.clay.inner_radius - def.tool.radius + way;
  hand.position = {from, def.clay.height * (0.35 + 0.15 * eased(u)), 0.0};
  return hand;
}

}  // namespace

double eased(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * t * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t)));
}

SceneWork finger_work(std::string name, const SceneDef& def, bool both, double deep, bool water) {
  return {std::move(name), def, kWorkSeconds, [=](double t) {
            Hands hands;
            hands.wheel_speed = kWorkWheel;
            hands.water = water && t < 0.5 * kWorkSeconds;
            hands.hand[0] = finger(def, WallSide::outside, deep, t / kWorkSeconds);
            if (both) hands.hand[1] = finger(def, WallSide::inside, deep, t / kWorkSeconds);
            return hands;
          }};
}

std::optional<SceneWork> evening_work(std::string name, const SceneDef& def, double deep,
                                      bool water) {
  for (std::size_t n = 0; n < def.tools.size(); ++n) {
    const ToolShape* shape = find_tool_shape(def.tools[n].name);
    if (shape == nullptr || !shape->smooths || !shape->round()) continue;
    const double radius = def.tools[n].size.radius;
    SceneWork work = finger_work(std::move(name), def, false, deep, water);
    // With its middle as much farther out, a ball lies as deep as the finger did.
    const double out = (radius > 0.0 ? radius : shape->usual.radius) - def.tool.radius;
    work.hands = [hands = std::move(work.hands), out, tool = n + 1](double t) {
      Hands with = hands(t);
      with.hand[0].tool = static_cast<std::uint8_t>(tool);
      with.hand[0].position.x += out;
      return with;
    };
    return work;
  }
  return std::nullopt;
}

SceneWork coil_work(std::string name, SceneDef def) {
  constexpr double kWander = 0.002, kGoesRound = 1.9;  // m, s
  def.building->pace = 5.0;
  def.building->drift = 0.0;
  const double middle = 0.5 * (def.clay.outer_radius + def.clay.inner_radius);
  const double height = def.clay.height + 0.499 * def.building->coil;
  SceneWork work{
      std::move(name), def, 2.0, [=](double t) {
        Hands hands;
        const double angle = 2.0 * portable::kPi * eased(t / kGoesRound);
        const double out = middle + kWander * portable::sin(2.0 * angle);
        hands.hand[0].position = {out * portable::cos(angle), height, out * portable::sin(angle)};
        hands.hand[0].active = hands.hand[0].coil = t <= kGoesRound;
        return hands;
      }};
  work.outline_from = def.clay.height;
  work.outline_to = def.clay.height + effects::Building::ring_height(*def.building, def.clay);
  return work;
}

SceneWork blow_work(std::string name, const SceneDef& def) {
  return {std::move(name), def, kWorkSeconds, [=](double t) {
            constexpr double kBeat = 0.12;  // s
            Hands hands;
            hands.wheel_speed = kWorkWheel;
            HandInput& hand = hands.hand[0];
            const double beat = t / kBeat;
            const double up = std::floor(beat) / 8.0;
            hand.position = {def.clay.outer_radius + def.tool.radius + 0.002,
                             def.clay.height * (0.3 + 0.4 * up), 0.0};
            hand.active = hand.paddle = true;
            hand.side = SideWish::outside;
            hand.swing = 1.0 - 0.5 * up;
            hand.anvil = 0.5 + 0.5 * up;
            hand.blow = beat - std::floor(beat) >= 0.5;
            return hands;
          }};
}

SceneDef on_a_wall(SceneDef def) {
  def.clay.rows = 200;
  def.clay.sectors = 180;
  def.clay.inner_radius = 0.045;
  def.clay.keep_undo = false;
  def.wheel.acceleration = 1000.0;
  return def;
}

std::vector<SceneWork> scene_works(const std::string& name, SceneDef def) {
  if (!def.paper) def = on_a_wall(std::move(def));
  def.clay.rows = 200;
  def.clay.sectors = 180;
  std::vector<SceneWork> works{finger_work(name, def, false, 0.0015)};
  if (!def.paper) works.push_back(finger_work(name + ", two hands", def, true, 0.001));
  return works;
}

Result<SceneOutcome> outcome_of(const SceneWork& work, double tick, int rows, double (*clock)()) {
  SceneDef def = work.def;
  def.clay.sectors = std::max(16, rows * def.clay.sectors / def.clay.rows);
  def.clay.rows = rows;
  Result<Scene> made = Scene::create(def);
  if (!made) return tl::unexpected(made.error());
  Scene& scene = *made;
  SceneOutcome out;
  const long ticks = std::lround(work.seconds / tick);
  const long window = std::lround(kWorkWindow / tick);
  std::array<Vec3, kMaxHands> sum{};
  for (long n = 1; n <= ticks; ++n) {
    const Hands hands = work.hands(tick * static_cast<double>(n));
    const double begin = clock ? clock() : 0.0;
    const Feedback felt = scene.step(hands, tick);
    if (clock && (felt.hand[0].contact || felt.hand[1].contact))
      out.tick_us.push_back(clock() - begin);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += tick * felt.hand[k].force;
    out.impulse += tick * felt.hand[0].force;
    if (n % window != 0) continue;
    for (Vec3& impulse : sum) {
      out.force.push_back((1.0 / kWorkWindow) * impulse);
      impulse = {};
    }
  }
  // Between the floor, whose top lies at a row's middle, and the rim, which may have sunk.
  const Profile p = scene.clay().profile();
  for (int k = 0; k < kHeights; ++k) {
    const double top = work.outline_to > 0.0 ? work.outline_to : def.clay.height;
    const double h = work.outline_from + (top - work.outline_from) * (0.1 + 0.8 * k / kHeights);
    out.outline.push_back(p.outer_at(h));
    out.outline.push_back(p.inner_at(h));
  }
  return out;
}

Apart apart(const SceneOutcome& a, const SceneOutcome& b) {
  Apart d;
  for (std::size_t n = 0; n < a.outline.size(); ++n) {
    const double by = a.outline[n] - b.outline[n];
    d.shape += by * by;
    d.shape_max = std::max(d.shape_max, std::fabs(by));
  }
  d.shape = std::sqrt(d.shape / static_cast<double>(a.outline.size()));
  for (std::size_t n = 0; n < a.force.size(); ++n) {
    const Vec3 by = a.force[n] - b.force[n];
    d.force += dot(by, by);
  }
  d.force = std::sqrt(d.force / static_cast<double>(a.force.size()));
  const double impulse = length(b.impulse);
  d.impulse = impulse > 0.0 ? length(a.impulse - b.impulse) / impulse : 0.0;
  return d;
}

double volume_apart(const SceneOutcome& a, const SceneOutcome& truth, const ClayDef& fresh) {
  double is = 0.0, should = 0.0, displaced = 0.0;
  for (std::size_t n = 0; n < truth.outline.size(); ++n) {
    const bool outer = n % 2 == 0;
    const double r = outer ? fresh.outer_radius : fresh.inner_radius;
    const double sign = outer ? 1.0 : -1.0;
    is += sign * a.outline[n] * a.outline[n];
    should += sign * truth.outline[n] * truth.outline[n];
    displaced += std::fabs((truth.outline[n] - r) * (truth.outline[n] + r));
  }
  return displaced > 0.0 ? std::fabs(is - should) / displaced : 0.0;
}

}  // namespace onggi::lab
