#include "tests/support/force_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/contact/paper_model.h"
#include "engine/effects/wobble.h"
#include "engine/force/haptics.h"
#include "engine/math/portable.h"

namespace onggi::test {

namespace {

constexpr double kWheelSpeed = 2.0 * portable::kPi;  // rad/s, 60 rpm
constexpr double kIn = 0.005;                        // m/s
constexpr double kToAndFro = 0.0003, kTimes = 3.0;   // m, Hz
constexpr double kRunUp = 1.0, kPushed = 1.6;        // s
constexpr std::size_t kSettles = 400;                // ticks until the groove is one
constexpr double kFinest = 1.0 / 16.0;               // of a tick
constexpr int kMostLag = 60;                         // ms

double squares(std::span<const Vec3> force) {
  double sum = 0.0;
  for (const Vec3& f : force) sum += dot(f, f);
  return sum;
}

/// Root mean square of what lies above 50 Hz, after taking a line off and a Hann window.
double above_50(std::span<const Vec3> force) {
  const std::size_t count = force.size();
  if (count < 8) return 0.0;
  double sum = 0.0;
  const auto n_of = static_cast<double>(count);
  std::vector<double> values(count);
  double weight = 0.0;
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const double first = force.front().*axis, last = force.back().*axis;
    weight = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      const double at = static_cast<double>(n) / (n_of - 1.0);
      const double hann = 0.5 - 0.5 * portable::cos(2.0 * portable::kPi * at);
      values[n] = hann * (force[n].*axis - first - at * (last - first));
      weight += hann * hann;
    }
    const auto lowest = static_cast<std::size_t>(std::ceil(50.0 * n_of / 1000.0));
    for (std::size_t k = lowest; k <= count / 2; ++k) {
      // Goertzel: one bin, two additions a value.
      const double angle = 2.0 * portable::kPi * static_cast<double>(k) / n_of;
      const double twice = 2.0 * portable::cos(angle);
      double one = 0.0, two = 0.0;
      for (const double value : values) {
        const double next = value + twice * one - two;
        two = one;
        one = next;
      }
      sum += 2.0 * (one * one + two * two - twice * one * two);
    }
  }
  return std::sqrt(sum / (n_of * weight));
}

/// Each in a Hann window of kSmooth to both sides, which is no later than it.
std::vector<Vec3> smoothed(std::span<const Vec3> force) {
  constexpr int kSmooth = 20;  // ms
  std::array<double, kSmooth + 1> weight;
  for (int k = 0; k <= kSmooth; ++k)
    weight[static_cast<std::size_t>(k)] =
        0.5 + 0.5 * portable::cos(portable::kPi * k / (kSmooth + 1));
  const auto count = static_cast<int>(force.size());
  std::vector<Vec3> out;
  for (int n = 0; n < count; ++n) {
    double whole = 0.0;
    Vec3 sum;
    for (int i = std::max(n - kSmooth, 0); i <= std::min(n + kSmooth, count - 1); ++i) {
      const double share = weight[static_cast<std::size_t>(std::abs(i - n))];
      whole += share;
      sum += share * force[static_cast<std::size_t>(i)];
    }
    out.push_back((1.0 / whole) * sum);
  }
  return out;
}

/// Root mean square of the change from one to the next.
double change(std::span<const Vec3> force) {
  double steps = 0.0;
  for (std::size_t n = 1; n < force.size(); ++n) {
    const Vec3 step = force[n] - force[n - 1];
    steps += dot(step, step);
  }
  return std::sqrt(steps / static_cast<double>(force.size() - 1));
}

/// How many ms later `force` is than `sooner`: where it is most like some share of it, to a tenth
/// by a parabola. A force that is a little smaller is not late. Of both what is slow: elements
/// that come under a tool every 3 ms look alike 3 ms later.
double lag_of(std::span<const Vec3> given, std::span<const Vec3> given_sooner) {
  const std::vector<Vec3> force = smoothed(given), sooner = smoothed(given_sooner);
  const auto off = [&](int ms) {
    double own = 0.0, both = 0.0, others = 0.0;
    for (std::size_t n = kMostLag; n + kMostLag < std::min(force.size(), sooner.size()); ++n) {
      const auto from = static_cast<std::size_t>(static_cast<int>(n) - ms);
      own += dot(force[n], force[n]);
      both += dot(force[n], sooner[from]);
      others += dot(sooner[from], sooner[from]);
    }
    return others > 0.0 ? own - both * both / others : own;
  };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int ms = 1 - kMostLag; ms < kMostLag; ++ms)
    if (const double is = off(ms); is < least) {
      least = is;
      best = ms;
    }
  const double before = off(best - 1), after = off(best + 1);
  const double curve = before - 2.0 * least + after;
  return best + (curve > 0.0 ? 0.5 * (before - after) / curve : 0.0);
}

/// How far from the axis a tool stands, level with the middle of the lump, when it first meets it.
double touches_at(const SceneDef& def, std::uint8_t tool) {
  auto scene = Scene::create(def);
  if (!scene) return 0.0;
  Hands hands;
  hands.hand[0].active = true;
  hands.hand[0].tool = tool;
  hands.hand[0].side = SideWish::outside;
  double at = def.clay.outer_radius + 0.12;
  for (; at > 0.0; at -= 0.0002) {
    hands.hand[0].position = {at, 0.5 * def.clay.height, 0.0};
    if (scene->step(hands, 0.001).hand[0].contact) break;
  }
  return at;
}

}  // namespace

std::vector<Vec3> push_slowly(const SceneDef& given, const SlowPush& push) {
  SceneDef def = given;
  def.guard = {22.2, 1e5, 0.05};
  def.wheel.acceleration = 100.0;
  auto scene = Scene::create(def);
  if (!scene || push.tool > def.tools.size()) return {};
  const double begins = touches_at(def, push.tool);
  const int parts = static_cast<int>(0.001 / push.seconds + 0.5);
  std::vector<Vec3> felt;
  force::Haptics haptics;
  force::HapticLimits limits;
  limits.stiffness = push.coupling;
  limits.max_force = def.guard.max_force;
  limits.own_damping = 1.0;
  Hands hands;
  hands.wheel_speed = kWheelSpeed;
  hands.hand[0].tool = push.tool;
  hands.hand[0].side = SideWish::outside;
  hands.water = push.wet;
  for (double t = 0.0; t < kRunUp; t += push.seconds) scene->step(hands, push.seconds);
  hands.water = false;
  hands.hand[0].active = true;
  const auto count = static_cast<int>(kPushed / 0.001 + 0.5);
  for (int n = 0; n < count; ++n) {
    Vec3 sum;
    for (int part = 0; part < parts; ++part) {
      const double t = 0.001 * n + push.seconds * (part + 1);
      double in = kIn * t;
      in += kToAndFro * portable::sin(2.0 * portable::kPi * kTimes * t);
      const Vec3 hand{begins - in, 0.5 * def.clay.height, 0.0};
      const bool coupled = push.coupling > 0.0;
      hands.hand[0].position = coupled ? haptics.tool(hand, push.seconds, limits) : hand;
      const HandFeedback felt_now = scene->step(hands, push.seconds).hand[0];
      if (coupled) {
        const Vec3 at_hand = haptics.feel(felt_now.touch, 1.0, limits);
        sum += push.spring ? push.coupling * haptics.coupling().stretch() : at_hand;
      } else {
        sum += felt_now.force;
      }
    }
    felt.push_back((1.0 / parts) * sum);
  }
  return felt;
}

ForceQuality quality_of(std::span<const Vec3> force, std::span<const Vec3> sooner) {
  ForceQuality quality;
  if (force.size() <= kSettles + 8) return quality;
  const auto rest = force.subspan(kSettles);
  double sum = 0.0;
  for (const Vec3& f : rest) sum += length(f);
  quality.mean = sum / static_cast<double>(rest.size());
  quality.increment = change(rest);
  quality.own = change(smoothed(rest));
  quality.above_50 = above_50(rest);
  if (squares(rest) > 0.0) quality.lag = 1e-3 * lag_of(rest, sooner.subspan(kSettles));
  return quality;
}

std::vector<Vec3> filtered(std::span<const Vec3> force) {
  PaperFilter filter;
  std::vector<Vec3> out;
  for (const Vec3& f : force) out.push_back(filter.filter(f));
  return out;
}

PrintedQuality printed_quality(const SceneDef& scene) {
  SceneDef def;
  def.clay.height = 0.072;
  def.clay.floor_thickness = 0.0;
  def.clay.wall_min = 0.0005;
  def.clay.inner_radius = def.clay.radius_min = 0.0001;
  def.clay.keep_undo = false;
  auto clay = Clay::create(def.clay);
  if (!clay) return {};
  const PaperModel printed(*clay);
  const double off = scene.wobble ? scene.wobble->off_centre : 0.0;
  for (int j = 0; j < clay->rows(); ++j) effects::lay_off_centre(*clay, j, {off, 0.0});
  // Its c_v at 5e6 N/m^3 is 0.864, for an element of this grid; its c_eta is 1 / (1 - e^(-T0 /
  // tau)).
  const double gives = -portable::expm1(-0.001 / scene.contact.relaxation_time);
  const PaperCoefficients coefficients{1.0 / gives, 0.864 / 5e6 * scene.contact.stiffness, 200.0};
  const double begins = def.clay.outer_radius + off + def.tool.radius;
  const double turn = 0.001 * kWheelSpeed;
  double angle = 0.0;
  std::vector<Vec3> raw;
  for (int n = 0; n < static_cast<int>(kPushed / 0.001 + 0.5); ++n) {
    const double t = 0.001 * (n + 1);
    const double in = kIn * t + kToAndFro * portable::sin(2.0 * portable::kPi * kTimes * t);
    angle += turn;
    if (angle >= 2.0 * portable::kPi) angle -= 2.0 * portable::kPi;
    const Vec3 at{begins - in, 0.5 * def.clay.height, 0.0};
    raw.push_back(
        printed.tick(*clay, WallSide::outside, at, def.tool.radius, angle, turn, coefficients)
            .force);
  }
  return {quality_of(raw, raw), quality_of(filtered(raw), raw)};
}

ForceQuality scenes_quality(const SceneDef& scene, std::uint8_t tool, double coupling) {
  SlowPush push{tool, 0.001, coupling};
  const std::vector<Vec3> force = push_slowly(scene, push);
  push.seconds = 0.001 * kFinest;
  push.spring = true;
  return quality_of(force, push_slowly(scene, push));
}

}  // namespace onggi::test
