#include "engine/lab/closed_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/contact/paper_model.h"
#include "engine/force/guard.h"
#include "engine/force/leather_hand.h"
#include "engine/lab/sampled_theory.h"
#include "engine/math/portable.h"

namespace onggi::lab {

namespace {

bool has_scene(LoopWall wall) {
  return wall == LoopWall::engine || wall == LoopWall::filtered_engine ||
         wall == LoopWall::rendered;
}

/// A wall: places in, forces out.
class Wall {
 public:
  explicit Wall(const LoopPlan& plan) : plan_(plan), last_(plan.begins) {
    decay_ = portable::exp(-LoopPlan::kSeconds / theory::kRelaxation);
    if (plan.wall == LoopWall::leather) level_.emplace(std::vector<Vec2>{{1.0, 0.0}, {0.0, 0.0}});
    if (!has_scene(plan.wall) && !level_) return;
    if (has_scene(plan.wall))
      if (auto made = Scene::create(plan.scene)) scene_.emplace(std::move(*made));
    limits_.stiffness = plan.coupling;
    limits_.max_force = plan.scene.guard.max_force;
    limits_.mass = plan.device.mass;
    limits_.own_damping = plan.passivity ? plan.device.damping : 1e9;
    limits_.delay = plan.told_delay < 0 ? plan.device.delay : plan.told_delay;
  }
  bool stands() const { return !has_scene(plan_.wall) || scene_.has_value(); }

  Vec3 answer(Vec3 at) {
    if (level_) {
      felt_.touch = leather_.meet(*level_, plan_.tool,
                                  haptics_.tool(at, LoopPlan::kSeconds, limits_), 1.0, {});
      return guarded();
    }
    if (!scene_) return spring(at);
    const bool rendered = plan_.wall == LoopWall::rendered;
    Hands hands;
    hands.wheel_speed = plan_.wheel;
    hands.hand[0].active = true;
    hands.hand[0].position = rendered ? haptics_.tool(at, LoopPlan::kSeconds, limits_) : at;
    hands.hand[0].paddle = plan_.paddle;
    hands.hand[0].anvil = plan_.paddle ? 1.0 : 0.0;
    const double beat = plan_.beats > 0.0 ? std::fmod(time_ / plan_.beats, 1.0) : 1.0;
    hands.hand[0].blow = beat < 1.0 / 3.0;
    time_ += LoopPlan::kSeconds;
    felt_ = scene_->step(hands, LoopPlan::kSeconds).hand[0];
    if ((felt_.blow > 0.0) != struck_) haptics_.strike(felt_.blow, felt_.blow_out);
    struck_ = felt_.blow > 0.0;
    if (plan_.wall == LoopWall::filtered_engine) return filter_.filter(felt_.force);
    return rendered ? guarded() : felt_.force;
  }

  const HandFeedback& felt() const { return felt_; }

 private:
  Vec3 guarded() {
    const Vec3 force = haptics_.feel(felt_.touch, 1.0, limits_);
    bool finite = true;
    const GuardDef& guard = plan_.scene.guard;
    return guard_.step(force, LoopPlan::kSeconds,
                       {guard.max_force, guard.max_slew, guard.engage_time}, finite);
  }

  Vec3 spring(Vec3 at) {
    const Vec3 wanted{0.0, -plan_.stiffness * (at.y - plan_.begins.y), 0.0};
    if (plan_.wall == LoopWall::filtered_spring) return filter_.filter(wanted);
    if (plan_.wall == LoopWall::spring) return wanted;
    force_.y = decay_ * force_.y - plan_.stiffness * (at.y - last_.y);
    last_ = at;
    return force_;
  }

  const LoopPlan& plan_;
  std::optional<Scene> scene_;
  std::optional<force::LeatherOutline> level_;
  force::LeatherHand leather_;
  force::HapticLimits limits_;
  force::Haptics haptics_;
  force::Guard guard_;
  PaperFilter filter_;
  HandFeedback felt_;
  Vec3 last_, force_;
  double decay_ = 0.0;
  double time_ = 0.0;  // s
  bool struck_ = false;
};

/// Half of the widest way along an axis, less any even drift: a hand that sinks into worked clay
/// does not swing.
double swing_of(std::span<const Vec3> places) {
  const auto count = static_cast<double>(places.size());
  if (places.size() < 2) return 0.0;
  double most = 0.0;
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const double middle = 0.5 * (count - 1.0);
    double sum = 0.0, slope = 0.0, square = 0.0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const double t = static_cast<double>(n) - middle;
      sum += places[n].*axis;
      slope += t * (places[n].*axis - places[0].*axis);
      square += t * t;
    }
    double low = 0.0, high = 0.0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const double t = static_cast<double>(n) - middle;
      const double off = places[n].*axis - sum / count - slope / square * t;
      low = std::min(low, off);
      high = std::max(high, off);
    }
    most = std::max(most, 0.5 * (high - low));
  }
  return most;
}

}  // namespace

const char* name_of(LoopWall wall) {
  switch (wall) {
    case LoopWall::spring:
      return "spring";
    case LoopWall::maxwell:
      return "maxwell";
    case LoopWall::filtered_spring:
      return "filtered_spring";
    case LoopWall::engine:
      return "engine";
    case LoopWall::filtered_engine:
      return "filtered_engine";
    case LoopWall::leather:
      return "leather";
    case LoopWall::rendered:
      break;
  }
  return "rendered";
}

LoopResult run_loop(const LoopPlan& plan) {
  LoopResult result;
  Wall wall(plan);
  if (!wall.stands()) {
    result.swing = std::numeric_limits<double>::infinity();
    return result;
  }
  Handle handle(plan.device, plan.hand, plan.begins, LoopPlan::kSeconds);
  handle.kick(plan.kick);
  const int ticks = static_cast<int>(plan.seconds / LoopPlan::kSeconds + 0.5);
  const int quarter = ticks / 4;
  std::vector<Vec3> earlier, before, last;
  Vec3 sum, was;
  for (int n = 0; n < ticks; ++n) {
    const Vec3 force = wall.answer(handle.told());
    handle.go(force, plan.push, plan.rest);
    if (n >= ticks - 3 * quarter && n < ticks - 2 * quarter) earlier.push_back(handle.at());
    if (n >= ticks - 2 * quarter && n < ticks - quarter) before.push_back(handle.at());
    if (n >= ticks - quarter) {
      last.push_back(handle.at());
      result.force_step = std::max(result.force_step, length(force - was));
      sum += force;
    }
    was = force;
    if (!(length(handle.at() - plan.begins) < 1.0)) {
      result.swing = std::numeric_limits<double>::infinity();
      return result;
    }
  }
  result.swing = swing_of(last);
  result.before = swing_of(before);
  result.earlier = swing_of(earlier);
  result.force_mean = length((1.0 / std::max(1, quarter)) * sum);
  return result;
}

double driven_power(const LoopPlan& plan, double way, int cycles) {
  Wall wall(plan);
  if (!wall.stands()) return -std::numeric_limits<double>::infinity();
  Handle handle(plan.device, plan.hand, plan.begins, LoopPlan::kSeconds);
  double begun = 0.0, motor = 0.0;
  Vec3 clay, held;
  // As many ticks before as it lasts, so that the stored energy is the same at both ends.
  for (int n = 0; n < 2 * kLedTicks; ++n) {
    if (n == kLedTicks) begun = handle.lost() - handle.work() + motor;
    const Vec3 force = wall.answer(handle.told());
    const double angle = 2.0 * portable::kPi * ((cycles * (n + 1)) % kLedTicks) / kLedTicks;
    handle.lead(force, plan.begins + way * portable::sin(angle) * plan.lead);
    motor += LoopPlan::kSeconds * dot(held, clay);
    held = force;
    clay = wall.felt().touch.clay;
  }
  return (handle.lost() - handle.work() + motor - begun) / (kLedTicks * LoopPlan::kSeconds);
}

double least_damping(const LoopPlan& plan, double way) {
  // From 7 to 483 Hz, out of step with the ticks, so that every phase comes.
  constexpr int kCycles[] = {5, 14, 30, 59, 97, 148, 215, 281, 338};
  double least = std::numeric_limits<double>::infinity();
  for (const int cycles : kCycles) {
    const double half = portable::kPi * cycles / kLedTicks;
    const double speed = 2.0 * way * portable::sin(half) / LoopPlan::kSeconds;  // chord's amplitude
    least = std::min(least, driven_power(plan, way, cycles) / (0.5 * speed * speed));
  }
  return least;
}

}  // namespace onggi::lab
