#include "engine/lab/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/lab/scene_fields.h"
#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

bool chance(Random& random, double share) { return random.uniform() < share; }
int below(Random& random, int end) {
  return static_cast<int>(random.bits() % static_cast<std::uint64_t>(end));
}

// Anywhere in the range; logarithmically if it spans more than a hundred times.
double within(Random& random, double least, double most) {
  if (least > 0.0 && most > 100.0 * least)
    return std::clamp(least * portable::exp(random.uniform() * portable::log(most / least)), least,
                      most);
  return random.uniform(least, most);
}

int grid(Random& random, int least, int usual, int most) {
  const double u = random.uniform();
  if (u < 0.15) return least + below(random, 12);
  return u < 0.9 ? least + below(random, usual - least) : usual + below(random, most - usual);
}

SceneDef random_scene(Random& random, const TrialPlan& plan) {
  SceneDef def = bare({});
  def.clay.rows = grid(random, 8, 80, 240);
  def.clay.sectors = std::max(plan.least_sectors, grid(random, 16, 72, 400));
  def.clay.inner_radius = random.uniform(0.01, 0.05);
  def.clay.keep_undo = chance(random, 0.5);
  def.guard.engage_time = 0.05;
  const int effects = static_cast<int>(effect_names().size());
  const double share = chance(random, 0.2) ? 1.0 : random.uniform(0.0, 0.8);
  for (int n = 0; n < effects; ++n)
    if (chance(random, share)) add_effect(def, static_cast<std::size_t>(n));
  if (!plan.ends) return def;
  const double odd = chance(random, 0.3) ? 0.0 : random.uniform(0.0, 0.3);
  for (const SceneField& field : scene_fields()) {
    if (field.name == "clay.rows" || field.name == "clay.sectors" || !field.there(def)) continue;
    if (!chance(random, odd)) continue;
    SceneDef tried = def;
    const double u = random.uniform();
    field.set(tried, u < 0.35  ? field.least
                     : u < 0.7 ? field.most
                               : within(random, field.least, field.most));
    if (validate(tried)) def = std::move(tried);
  }
  return def;
}

// A place that may matter: the axis, inside, in the wall, beside it, over the rim, far away.
Vec3 place(Random& random, const ClayDef& clay) {
  const double angle = random.uniform(0.0, 2.0 * portable::kPi);
  const double u = random.uniform();
  double out = random.uniform(0.0, 1.3 * clay.outer_radius);
  if (u < 0.1) out = 0.0;
  if (u > 0.7) out = random.uniform(clay.inner_radius, clay.outer_radius);
  if (u > 0.9) out = random.uniform(0.0, 0.002);
  if (u > 0.97) out = random.uniform(0.0, 1.2 * clay.radius_max);
  const double v = random.uniform();
  double up = random.uniform(-0.1, 1.2) * clay.height;
  if (v < 0.2) up = clay.height + random.uniform(-0.03, 0.03);
  if (v > 0.85) up = clay.floor_thickness + random.uniform(-0.02, 0.02);
  if (v > 0.97) up = random.uniform(0.0, 4.0) * clay.height;
  return {out * portable::cos(angle), up, out * portable::sin(angle)};
}

Vec3 direction(Random& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

void make_nonsense(Random& random, Stroke& stroke, std::size_t tools) {
  HandInput& hand = stroke.hand[random.bits() % kMaxHands].begins;
  hand.active = true;
  static constexpr double kOdd[] = {kNan, 1e300, -11.0, std::numeric_limits<double>::infinity()};
  static constexpr double kTrialTimes[] = {0.0,   -1.0,   kNan,  kDenormal,
                                           1e-12, 3600.0, 0.005, 1e-300};
  switch (below(random, 7)) {
    case 0:
      hand.position.y = kOdd[random.bits() % 4];
      break;
    case 1:
      hand.handle.x = kOdd[random.bits() % 4];
      break;
    case 2:
      hand.roll = kOdd[random.bits() % 4];
      break;
    case 3:
      hand.tool = static_cast<std::uint8_t>(tools + 1 + random.bits() % 100);
      break;
    case 4:
      stroke.wheel_speed = kOdd[random.bits() % 4];
      break;
    case 5:
      hand.position = {kDenormal, hand.position.y, -kDenormal};
      break;
    default:
      stroke.dt = kTrialTimes[random.bits() % 8];
      break;
  }
}

// A coil comes down by twice its diameter to where the rim may be, if some rings were laid, while
// the wheel turns some times: slowly enough, but not always.
void lay_coil(Random& random, const SceneDef& def, Stroke& stroke, Stroke::Part& part) {
  constexpr int kMostTicks = 1200;
  const double coil = def.building->coil;
  const double angle = random.uniform(0.0, 2.0 * portable::kPi);
  const double out = random.uniform(std::max(def.clay.inner_radius, 0.005), def.clay.outer_radius);
  const double top = def.clay.height + (0.9 * below(random, 4) + 1.5) * coil;
  part.begins.position = {out * portable::cos(angle), top, out * portable::sin(angle)};
  part.ends = part.begins.position;
  part.ends.y = top - 2.0 * coil;
  part.begins.active = true;
  stroke.wheel_speed = random.uniform(0.3, 1.1) * def.building->pace / out;
  const double seconds = 4.0 * 2.0 * portable::kPi / stroke.wheel_speed;
  stroke.ticks =
      static_cast<int>(std::clamp(seconds / std::max(stroke.dt, 1e-4), 1.0, 1.0 * kMostTicks));
}

Stroke random_stroke(Random& random, const SceneDef& def, const TrialPlan& plan,
                     const Stroke& last) {
  Stroke stroke = last;
  stroke.renew = stroke.restore = false;
  const int usual = std::max(1, plan.ticks / std::max(1, plan.strokes));
  stroke.ticks = 1 + below(random, 2 * usual);
  const double t = random.uniform();
  stroke.dt = t < 0.6 ? 0.001 : t < 0.8 ? 0.005 : within(random, 1e-9, 0.005);
  stroke.ragged = chance(random, 0.25);
  stroke.tremble = chance(random, 0.2) ? random.uniform(0.0, 0.002) : 0.0;
  for (Stroke::Part& part : stroke.hand) {
    HandInput& begins = part.begins;
    begins.position = part.ends;
    if (chance(random, 0.3)) begins.active = !begins.active;
    if (chance(random, 0.2)) begins.side = static_cast<SideWish>(random.bits() % 3);
    if (chance(random, 0.2))
      begins.tool = static_cast<std::uint8_t>(random.bits() % (def.tools.size() + 1));
    if (chance(random, 0.15)) begins.handle = chance(random, 0.5) ? Vec3{} : direction(random);
    if (chance(random, 0.1)) begins.roll = random.uniform(-7.0, 7.0);
    if (!is_finite(begins.position) || chance(random, 0.2))
      begins.position = place(random, def.clay);  // put down elsewhere
    if (!is_finite(begins.handle)) begins.handle = {};
    if (!std::isfinite(begins.roll)) begins.roll = 0.0;
    if (begins.tool > def.tools.size()) begins.tool = 0;
    part.ends = chance(random, 0.25) ? begins.position : place(random, def.clay);
    if (chance(random, 0.3)) part.ends.y = begins.position.y;
  }
  if (chance(random, 0.3)) {  // two hands with the wall between them
    const Vec3 middle = stroke.hand[0].begins.position;
    const double far = axis_distance(middle);
    const Vec3 out = far > 1e-6 ? (1.0 / far) * Vec3{middle.x, 0.0, middle.z} : Vec3{1, 0, 0};
    const double apart = random.uniform(0.0, 0.03) + def.tool.radius;
    stroke.hand[1] = stroke.hand[0];
    stroke.hand[1].begins.position = middle - apart * out;
    stroke.hand[1].ends = stroke.hand[0].ends - apart * out;
    stroke.hand[0].begins.active = stroke.hand[1].begins.active = true;
  }
  if (chance(random, 0.3) || !std::isfinite(stroke.wheel_speed)) {
    const double s = random.uniform();
    stroke.wheel_speed = s < 0.15  ? 62.9
                         : s < 0.3 ? -62.9
                         : s < 0.4 ? 0.0
                                   : random.uniform(-40.0, 40.0);
  }
  for (Stroke::Part& part : stroke.hand) {
    part.begins.coil = def.building && chance(random, 0.15);
    if (part.begins.coil) lay_coil(random, def, stroke, part);
    part.beats = def.beating && chance(random, 0.2);
    part.begins.paddle = part.beats;
    if (part.beats) {
      part.begins.anvil = chance(random, 0.4) ? 0.0 : random.uniform();
      part.begins.swing = chance(random, 0.5) ? 1.0 : random.uniform();
    }
  }
  if (chance(random, 0.1)) stroke.water = !stroke.water;
  if (def.building && chance(random, 0.1)) stroke.fire = !stroke.fire;
  stroke.renew = chance(random, 0.03);
  stroke.restore = chance(random, 0.06);
  if (plan.nonsense && chance(random, 0.06)) make_nonsense(random, stroke, def.tools.size());
  return stroke;
}

}  // namespace

std::uint64_t Trial::ticks() const {
  std::uint64_t sum = 0;
  for (const Stroke& stroke : strokes) sum += static_cast<std::uint64_t>(stroke.ticks);
  return sum;
}

TickRecord Trial::tick_of(const Stroke& stroke, int k, Random& random) {
  TickRecord record;
  const double gone = stroke.ticks > 1 ? static_cast<double>(k) / (stroke.ticks - 1) : 0.0;
  for (std::size_t n = 0; n < stroke.hand.size(); ++n) {
    const Stroke::Part& part = stroke.hand[n];
    HandInput& hand = record.hands.hand[n];
    hand = part.begins;
    hand.blow = part.beats && k % Stroke::kBeat < Stroke::kBeat / 2;
    if (gone > 0.0 && part.ends != part.begins.position)
      hand.position += gone * (part.ends - part.begins.position);
    if (stroke.tremble > 0.0) hand.position += stroke.tremble * direction(random);
  }
  record.hands.wheel_speed = stroke.wheel_speed;
  record.hands.water = stroke.water;
  record.hands.fire = stroke.fire;
  record.hands.renew = stroke.renew;
  record.hands.restore = stroke.restore;
  record.dt = stroke.ragged ? stroke.dt * (1.0 - random.uniform()) : stroke.dt;
  return record;
}

Trial random_hands(const SceneDef& def, std::uint64_t seed, const TrialPlan& plan) {
  Random random(seed);
  Trial trial{def, seed, {}};
  Stroke last;
  last.wheel_speed = random.uniform(-31.0, 31.0);
  for (Stroke::Part& part : last.hand) {
    part.ends = place(random, def.clay);
    part.begins.active = true;
  }
  for (int n = 0; n < plan.strokes; ++n) {
    trial.strokes.push_back(random_stroke(random, def, plan, last));
    last = trial.strokes.back();
  }
  return trial;
}

Trial random_trial(std::uint64_t seed, const TrialPlan& plan) {
  Random random(seed);
  const SceneDef def = random_scene(random, plan);
  return random_hands(def, random.bits(), plan);
}

Hands mirrored(Hands hands) {
  for (HandInput& hand : hands.hand) {
    hand.position.z = -hand.position.z;
    hand.handle.z = -hand.handle.z;
    hand.roll = -hand.roll;
  }
  hands.wheel_speed = -hands.wheel_speed;
  return hands;
}

std::string words_of(const Trial& trial) {
  const SceneDef& def = trial.def;
  std::string text =
      std::to_string(def.clay.rows) + " x " + std::to_string(def.clay.sectors) + " elements";
  const std::vector<std::string> names = effect_names();
  for (std::size_t n = 0; n < names.size(); ++n)
    if (has_effect(def, n)) text += ", " + names[n];
  SceneDef usual = bare({});
  for (std::size_t n = 0; n < names.size(); ++n) add_effect(usual, n);
  for (const SceneField& field : scene_fields()) {
    if (field.name == "clay.rows" || field.name == "clay.sectors" || !field.there(def)) continue;
    if (field.there(usual) && field.get(usual) != field.get(def))
      text += ", " + field.name + " " + number_text(field.get(def));
  }
  text += "; " + std::to_string(trial.strokes.size()) + " strokes, " +
          std::to_string(trial.ticks()) + " ticks";
  return text;
}

std::vector<std::byte> replay_of(const Trial& trial, std::uint64_t ticks) {
  Result<Scene> scene = Scene::create(trial.def);
  if (!scene) return {};
  ReplayWriter writer(trial.def, "trial", trial.seed);
  std::uint64_t done = 0;
  double next = 1.0;
  trial.play([&](const TickRecord& record) {
    writer.tick(record);
    scene->step(record.hands, record.dt);
    if (scene->time() >= next) {
      writer.note_hash(scene->state_hash());
      next += 1.0;
    }
    return ++done < ticks;
  });
  return writer.finish(scene->state_hash());
}

}  // namespace onggi::lab
