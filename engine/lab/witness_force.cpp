#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/lowpass.h"
#include "engine/math/portable.h"

// Written from engine/docs/force.md and contact.md. Where a law is that nothing steps, or that a
// closed path gives nothing, the clay is altered while the hand is on its way: it gets stiffer.
namespace onggi::lab {
namespace {

constexpr double kTipRadius = 0.008;
constexpr double kMicrometre = 1e-6;
constexpr double kRimHeight = 0.2;

// Two hands that press a wall at its thinnest from both sides.
double both_feel_the_same(double by) {
  SceneDef def = lone_wall(200, 720, 0.0478, 0.0523);
  const double gap = 1e-4, missing = def.clay.wall_min - gap;
  const double tau = def.contact.relaxation_time;
  def.clay.wall_min *= 1.0 + by;
  Scene scene = scene_of(def);
  const double middle = 0.05005;
  Hands hands = ball_at({middle + 0.5 * gap + kTipRadius, 0.1, 0}, SideWish::outside);
  hands.hand[1] = hands.hand[0];
  hands.hand[1].side = SideWish::inside;
  hands.hand[1].position.x = middle - 0.5 * gap - kTipRadius;
  Feedback felt;
  double out = 0.0, in = 0.0;
  for (int n = 0; n < 300; ++n) {
    felt = scene.step(hands, 0.001);
    if (n < 200) continue;
    out += felt.hand[0].touch.push.x;
    in -= felt.hand[1].touch.push.x;
  }
  const double should = missing / (1.0 + portable::exp(-0.001 / tau));
  return std::max({share_apart(out, in), share_apart(felt.hand[0].depth, should),
                   share_apart(felt.hand[1].depth, should)});
}

// Clay that keeps its shape as a scene: it gives way in a second, and a tick lasts a microsecond.
SceneDef still_clay(double thickness) {
  SceneDef def = lone_wall(200, 180, 0.055 - thickness, 0.055);
  def.clay.wall_min = 0.002;
  def.contact = {.relaxation_time = 1.0, .stiffness = 1e7};
  return def;
}

// How much harder a hand is pushed a micrometre deeper, as a share of what the touch said beyond 1.
double steeper_than_told(double by) {
  SceneDef def = still_clay(0.02);
  Scene told = scene_of(def);
  def.contact.stiffness *= 1.0 + by;
  Scene felt = scene_of(def);
  double most = 0.0, last = 0.0;
  for (int n = 0; n < 3000; ++n) {
    const Hands hands = ball_at({0.055 + kTipRadius - kMicrometre * n, 0.1, 0}, SideWish::outside);
    const double bound = told.step(hands, 1e-6).hand[0].touch.stiffness;
    const double push = length(felt.step(hands, 1e-6).hand[0].touch.push);
    if (n > 1000) most = std::max(most, (push - last) / kMicrometre / bound);
    last = push;
  }
  return std::max(most - 1.0, 0.0);
}

// The largest change of `push(place, share of the way)` from a micrometre to the next, N.
template <class Push>
double largest_step(Vec3 from, Vec3 to, Push&& push) {
  const int parts = static_cast<int>(length(to - from) / kMicrometre);
  double most = 0.0;
  Vec3 last;
  for (int n = 0; n <= parts; ++n) {
    const double share = 1.0 * n / parts;
    const Vec3 now = push(from + share * (to - from), share);
    if (n > 0) most = std::max(most, length(now - last));
    last = now;
  }
  return most;
}

double step_on_clay(const ClayDef& def, Vec3 from, Vec3 to, double by) {
  FrozenClay clay(def, kTipRadius, 5e6);
  bool stiff = false;
  return largest_step(from, to, [&](Vec3 at, double share) {
    if (share > 0.5 && !stiff) clay.stiffen(by), stiff = true;
    return clay.push(at);
  });
}

double over_the_rim(double by) {
  const double low = kRimHeight + kTipRadius - 0.004;
  return step_on_clay(lone_wall(200, 360, 0.035, 0.055).clay, {0.064, low, 0}, {0.049, low, 0}, by);
}

double along_the_wall(double by) {
  const double out = 0.055 + kTipRadius - 0.003;
  return step_on_clay(lone_lump(400, 360).clay, {out, 0.1, -0.004}, {out, 0.104, 0.004}, by);
}

double off_a_solid_lump(double by) {
  ClayDef def = lone_lump(200, 360).clay;
  def.height = def.floor_thickness = 0.1;
  const double low = 0.1 + kTipRadius - 0.004;
  return step_on_clay(def, {0.044, low, 0}, {0.062, low, 0}, by);
}

// The same where a wall has a bending strength: two scenes, of which the second is stiffer and is
// felt on the second half of the way.
class StillPair {
 public:
  StillPair(SceneDef def, double by) : first_(scene_of(def)), second_(stiffer(def, by)) {}
  Feedback step(const Hands& hands, double share) {
    const Feedback first = first_.step(hands, 1e-6), second = second_.step(hands, 1e-6);
    return share > 0.5 ? second : first;
  }

 private:
  static Scene stiffer(SceneDef def, double by) {
    def.contact.stiffness *= 1.0 + by;
    return scene_of(def);
  }
  Scene first_, second_;
};

SceneDef thin_wall() {
  SceneDef def = still_clay(0.004);
  def.walls.emplace().bending_strength = 14'700.0;
  return def;
}

double down_a_thin_wall(SideWish side, double out, double from, double to, double by) {
  StillPair pair(thin_wall(), by);
  return largest_step({out, from, 0}, {out, to, 0}, [&](Vec3 at, double share) {
    return pair.step(ball_at(at, side), share).hand[0].touch.push;
  });
}

double down_to_the_floor(double by) {
  return down_a_thin_wall(SideWish::inside, 0.051 - kTipRadius + 0.003, 0.0205, 0.0165, by);
}

double down_to_the_foot(double by) {
  return down_a_thin_wall(SideWish::outside, 0.055 + kTipRadius - 0.003, 0.020, 0.007, by);
}

// Hand 0 lies still, 3 mm deep in a thin wall; hand 1 comes to the other face and goes 1 mm in. By
// how much more than hand 1's own push the push on hand 0 changes, N.
double held_by_a_graze(double by) {
  StillPair pair(thin_wall(), by);
  Hands hands = ball_at({0.055 + kTipRadius - 0.003, 0.1, 0}, SideWish::outside);
  hands.hand[1] = hands.hand[0];
  hands.hand[1].side = SideWish::inside;
  double most = 0.0, before = 0.0, other_before = 0.0;
  constexpr int kWay = 1050;
  for (int n = 0; n < kWay; ++n) {
    hands.hand[1].position = {0.051 - kTipRadius - 5e-5 + kMicrometre * n, 0.1, 0};
    const Feedback felt = pair.step(hands, 1.0 * n / kWay);
    const double now = length(felt.hand[0].touch.push);
    const double other = length(felt.hand[1].touch.push);
    if (n > 0)
      most = std::max(most, std::fabs(now - before) - 1.1 * std::fabs(other - other_before));
    before = now;
    other_before = other;
  }
  return most;
}

// Work that clay gives on the closed way round `path`, as a share of the most that it held. Pushes
// are `push(place, number of the corner that the way comes from)`.
template <class Push>
double given_round(const std::vector<Vec3>& path, Push&& push) {
  double gained = 0.0, stored = 0.0;
  Vec3 last;
  for (std::size_t n = 0; n < path.size(); ++n) {
    const Vec3 way = path[(n + 1) % path.size()] - path[n];
    const int parts = static_cast<int>(std::ceil(length(way) / 2e-5));
    for (int k = 1; k <= parts; ++k) {
      const Vec3 force = push(path[n] + (1.0 * k / parts) * way, n);
      gained += dot(0.5 * (force + last), (1.0 / parts) * way);
      stored = std::max(stored, -gained);
      last = force;
    }
  }
  return std::fabs(gained) / stored;
}

// From corner `stiff` on the clay is stiffer.
double round_frozen(FrozenClay clay, const std::vector<Vec3>& path, std::size_t stiff, double by) {
  bool stiffened = false;
  return given_round(path, [&](Vec3 at, std::size_t corner) {
    if (corner >= stiff && !stiffened) clay.stiffen(by), stiffened = true;
    return clay.push(at);
  });
}

double round_still_clay(const std::vector<Vec3>& path, std::size_t stiff, double by) {
  const Clay wall = std::move(*Clay::create(lone_wall(400, 360, 0.035, 0.055).clay));
  return round_frozen({wall, kTipRadius, 5e6}, path, stiff, by);
}

double round_the_rim(double by) {
  const double low = kRimHeight + kTipRadius - 0.003, clear = kRimHeight + kTipRadius + 0.001;
  return round_still_clay({{0.066, clear, 0}, {0.066, low, 0}, {0.045, low, 0}, {0.045, clear, 0}},
                          2, by);
}

double round_below_the_rim(double by) {
  const double low = kRimHeight - 0.010, clear = kRimHeight + kTipRadius + 0.001;
  return round_still_clay({{0.064, low, 0}, {0.060, low, 0}, {0.060, clear, 0}, {0.064, clear, 0}},
                          1, by);
}

constexpr double kClearOut = 0.055 + kTipRadius + 0.002, kDeepIn = 0.055 + kTipRadius - 0.005;

double round_the_foot(double by) {
  return round_still_clay(
      {{kClearOut, 0.02, 0}, {kDeepIn, 0.02, 0}, {kDeepIn, 0.001, 0}, {kClearOut, 0.001, 0}}, 2,
      by);
}

// A cone whose radius grows by 0.3 of its height, 3 mm deep all the way.
double up_a_wall_that_leans(double by) {
  constexpr double kSlope = 0.3;
  Clay wall = std::move(*Clay::create(lone_wall(400, 360, 0.035, 0.055).clay));
  for (int j = 0; j < wall.rows(); ++j) {
    const auto out = static_cast<float>(0.08 + kSlope * (wall.row_height(j) - 0.1));
    std::ranges::fill(wall.outer_mut(j), out);
    std::ranges::fill(wall.inner_mut(j), out - 0.02f);
    wall.set_extent(j, out, out - 0.02f);
  }
  const double square = std::sqrt(1.0 + kSlope * kSlope);
  const auto beside = [&](double y, double clear) {
    return Vec3{0.08 + kSlope * (y - 0.1) + clear / square, y - kSlope * clear / square, 0.0};
  };
  const double clear = kTipRadius + 0.002, deep = kTipRadius - 0.003;
  return round_frozen(
      {wall, kTipRadius, 5e6},
      {beside(0.09, clear), beside(0.09, deep), beside(0.12, deep), beside(0.12, clear)}, 2, by);
}

// The same of hand 0 in a scene, from outside.
double round_a_scene(SceneDef def, const char* tool, const std::vector<Vec3>& path,
                     std::size_t stiff, double by) {
  def.clay.rows = 400;
  def.clay.sectors = 360;
  StillPair pair(def, by);
  Hands hands = ball_at(path[0], SideWish::outside);
  hands.hand[0].tool = tool_of(def, tool);
  pair.step(hands, 0.0);
  return given_round(path, [&](Vec3 at, std::size_t corner) {
    hands.hand[0].position = at;
    return pair.step(hands, corner >= stiff ? 1.0 : 0.0).hand[0].touch.push;
  });
}

double a_fingertip_along_the_wall(double by) {
  return round_a_scene(
      still_clay(0.02), "fingertip",
      {{kClearOut, 0.1, 0}, {kDeepIn, 0.1, 0}, {kDeepIn, 0.13, 0}, {kClearOut, 0.13, 0}}, 2, by);
}

double to_the_foot_of_a_thin_wall(double by) {
  return round_a_scene(
      thin_wall(), "sphere",
      {{kClearOut, 0.028, 0}, {kDeepIn, 0.028, 0}, {kDeepIn, 0.0085, 0}, {kClearOut, 0.0085, 0}}, 2,
      by);
}

// |H|^2 = 1 / (1 + (tan(pi f / rate) / tan(pi cutoff / rate))^4), of the answer to one pulse.
double a_butterworth(double by) {
  const auto tangent = [](double a) { return portable::sin(a) / portable::cos(a); };
  double most = 0.0;
  for (const double rate : {200.0, 1000.0, 4000.0}) {
    Lowpass filter((1.0 + by) * 10.0, rate);
    std::vector<double> answer;
    for (int n = 0; n < 2.0 * rate; ++n) answer.push_back(filter.filter(n == 0 ? 1.0 : 0.0));
    for (const double f : {2.0, 10.0, 40.0}) {
      double c = 0.0, s = 0.0;
      for (std::size_t n = 0; n < answer.size(); ++n) {
        const double angle = 2.0 * portable::kPi * f / rate * static_cast<double>(n);
        c += answer[n] * portable::cos(angle);
        s += answer[n] * portable::sin(angle);
      }
      const double over = tangent(portable::kPi * f / rate) / tangent(portable::kPi * 10.0 / rate);
      const double should = 1.0 / std::sqrt(1.0 + over * over * over * over);
      most = std::max(most, std::fabs(std::sqrt(c * c + s * s) - should));
    }
  }
  return most;
}

constexpr const char* kOnTheWay = "the clay's stiffness, on the way";

constexpr Witness kForce[] = {
    {"two hands through a wall", "equal and opposite, each w / (1 + e^(-dt/tau)) deep",
     "clay.wall_min", 0.02, "", both_feel_the_same},
    {"the stiffness that a touch tells", "at least the slope of the push over a micrometre",
     "contact.stiffness", 0.01, "", steeper_than_told},
    {"no step along the wall", "the push a micrometre further, 3 mm deep", kOnTheWay, 0.002, "N",
     along_the_wall},
    {"no step over the rim", "the push a micrometre further, 4 mm deep", kOnTheWay, 0.002, "N",
     over_the_rim},
    {"no step off a solid lump", "the push a micrometre further, 4 mm deep", kOnTheWay, 0.002, "N",
     off_a_solid_lump},
    {"no step where a thin wall meets the floor", "the push a micrometre further, 3 mm deep",
     kOnTheWay, 0.002, "N", down_to_the_floor},
    {"no step where a thin wall meets the foot", "the push a micrometre further, 3 mm deep",
     kOnTheWay, 0.002, "N", down_to_the_foot},
    {"a hand that grazes the other face", "adds no more than its own push, and a tenth", kOnTheWay,
     1e-5, "N", held_by_a_graze},
    {"round the rim", "a closed path gives no work, as a share of what the clay held", kOnTheWay,
     5e-3, "", round_the_rim},
    {"round the rim, from below it",
     "a closed path gives no work, as a share of what the clay held", kOnTheWay, 0.02, "",
     round_below_the_rim},
    {"round a path across the wall's foot",
     "a closed path gives no work, as a share of what the clay held", kOnTheWay, 0.02, "",
     round_the_foot},
    {"round a path up a wall that leans",
     "a closed path gives no work, as a share of what the clay held", kOnTheWay, 0.02, "",
     up_a_wall_that_leans},
    {"round a path along the wall, a fingertip",
     "a closed path gives no work, as a share of what the clay held", kOnTheWay, 0.02, "",
     a_fingertip_along_the_wall},
    {"round a path to the foot of a thin wall",
     "a closed path gives no work, as a share of what the clay held", kOnTheWay, 0.01, "",
     to_the_foot_of_a_thin_wall},
    {"Butterworth's filter", "1 / sqrt(1 + (tan f / tan cutoff)^4), from its answer to a pulse",
     "the cutoff", 1e-11, "", a_butterworth},
};

}  // namespace

std::span<const Witness> force_witnesses() { return kForce; }

}  // namespace onggi::lab
