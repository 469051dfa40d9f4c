#include "tests/support/hard_trace.h"

#include <cstdint>
#include <limits>
#include <sstream>

#include "engine/force/guard.h"
#include "engine/force/haptics.h"
#include "engine/force/overspeed.h"
#include "engine/lab/trial.h"
#include "engine/math/hash.h"
#include "engine/scene/scene.h"

namespace onggi {
namespace {

void add(StateHash& hash, Vec3 v) {
  for (const double part : {v.x, v.y, v.z}) hash.add(part);
}

void add(StateHash& hash, const HandFeedback& felt) {
  add(hash, felt.force);
  add(hash, felt.touch.push);
  add(hash, felt.touch.clay);
  for (const double v : {felt.depth, felt.touch.stiffness, felt.touch.relaxation, felt.touch.grip})
    hash.add(v);
  hash.add(static_cast<std::uint64_t>(felt.place) * 4 + static_cast<std::uint64_t>(felt.side) * 2 +
           (felt.contact ? 1 : 0));
}

Vec3 anywhere(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Clay that comes and goes, harder and softer, under a hand that rests, works and is thrown.
std::uint64_t handle_hash(std::uint64_t seed, double seconds) {
  Random random(seed);
  force::HapticLimits limits{random.uniform(19.0, 600.0), random.uniform(0.5, 7.9),
                             random.uniform(0.02, 0.3), random.uniform(0.0, 1.0),
                             static_cast<int>(seed % 10)};
  const force::GuardLimits last{limits.max_force, random.uniform(50.0, 1200.0),
                                random.uniform(0.02, 0.5)};
  force::Haptics haptics;
  force::Guard guard;
  force::Overspeed overspeed;
  StateHash hash;
  Vec3 hand = anywhere(random, 0.05);
  Vec3 way;
  force::Touch touch;
  for (int n = 0; n < 1500; ++n) {
    if (n % 50 == 0) {
      const double pace = random.uniform();
      way = anywhere(random, pace < 0.3 ? 0.0 : pace < 0.9 ? 0.3 : 3.0);
      const double met = random.uniform();
      touch = {};
      if (met > 0.2) touch.push = anywhere(random, met > 0.9 ? 20.0 : 1.0);
      if (met > 0.1) touch.grip = random.uniform(0.0, 0.5);
      touch.stiffness = random.uniform() < 0.1 ? 0.0 : random.uniform(1.0, 2000.0);
      touch.relaxation = random.uniform() < 0.3 ? 0.0 : random.uniform(0.001, 0.1);
      touch.clay = anywhere(random, 1.0);
    }
    if (n % 400 == 399) {
      haptics.release();
      guard.release();
    }
    if (n == 700) touch.push.x = std::numeric_limits<double>::quiet_NaN();  // lets go
    const double dt = n % 3 == 0 ? 0.7 * seconds : seconds;
    hand += dt * way + anywhere(random, 3e-5);
    const Vec3 tool = haptics.tool(hand, dt, limits);
    const Vec3 force = haptics.feel(touch, n % 500 < 400 ? 1.0 : 0.5, limits);
    bool sound = true;
    add(hash, tool);
    add(hash, guard.step(n == 900 ? Vec3{1e200, 0.0, 0.0} : force, dt, last, sound));
    hash.add(haptics.passivity().energy());
    hash.add(haptics.passivity().damping());
    hash.add(std::uint64_t{sound} * 2 + std::uint64_t{overspeed.look(hand, dt)});
    touch.push = 0.98 * touch.push;
  }
  return hash.value();
}

}  // namespace

std::string hard_trace(Vectors kind) {
  std::ostringstream hashes;
  StateHash hash;
  for (std::uint64_t seed = 1; seed <= 32; ++seed) {
    lab::TrialPlan plan;
    plan.ticks = 1000;
    plan.strokes = 20;
    plan.nonsense = false;  // what is no number has no bits of its own
    const lab::Trial trial = lab::random_trial(seed, plan);
    auto scene = Scene::create(trial.def, kind);
    if (!scene) return "";
    trial.play([&](const TickRecord& record) {
      const Feedback felt = scene->step(record.hands, record.dt);
      for (const HandFeedback& hand : felt.hand) add(hash, hand);
      for (const double v :
           {felt.clay_angle, felt.wheel_speed, felt.cut_free, felt.wetness, felt.sinking})
        hash.add(v);
      hash.add(std::uint64_t{felt.faults} * 4 + std::uint64_t{felt.fallen} * 2 +
               std::uint64_t{felt.torn});
      return true;
    });
    hash.add(scene->state_hash());
    if (seed % 4 != 0) continue;
    hashes << std::hex << hash.value() << '\n';
    hash = {};
  }
  return hashes.str();
}

std::string handle_trace() {
  std::ostringstream hashes;
  std::uint64_t seed = 0;
  for (const double seconds : {0.001, 0.0001, 0.005, 0.0005, 0.002, 0.001, 0.00025, 0.003})
    hashes << std::hex << handle_hash(++seed, seconds) << '\n';
  return hashes.str();
}

}  // namespace onggi
