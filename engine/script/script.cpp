#include "engine/script/script.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/script/carving.h"
#include "engine/script/choreography.h"
#include "engine/script/former.h"
#include "engine/script/keyed.h"
#include "engine/script/throwing.h"
#include "engine/script/upright.h"

namespace onggi {
namespace {

constexpr double kRough = 0.036;  // m/s along the wall
constexpr double kFine = 0.015;
// A sphere of 8 mm that rises 2 mm a turn leaves ridges of 2^2 / (8 * 8) = 0.06 mm: throwing lines
// that light finds and a finger does not.
constexpr double kFinish = 0.008;
constexpr double kWheelRough = 18.0;  // rad/s: 172 rpm
constexpr double kWheelFine = 22.0;   // 210 rpm

constexpr std::array<std::string_view, 21> kNames{
    "true",      "collar",    "belly",    "bowl",    "groove", "follow", "open",
    "press_rim", "flare_rim", "squeeze",  "facet",   "flute",  "incise", "trim_foot",
    "cut_off",   "pull_tall", "collapse", "dry_out", "re_wet", "centre", "rib_smooth"};

// Plays keys back.
class PlannedScript final : public Script {
 public:
  PlannedScript(std::vector<Key> keys, double tool_radius)
      : keys_(std::move(keys)), radius_(tool_radius) {}

  Hands at(double t, const Clay&) noexcept override {
    const auto between = keys_.at(t);
    const Key& a = between.from;
    const Key& b = between.to;
    const double share = between.share;
    const Vec2 place = a.place + share * (b.place - a.place);
    const bool over = t >= duration();
    Hands hands;
    hands.hand[0].position = {place.x * cos_, place.y, place.x * sin_};
    hands.hand[0].active = a.active && !over;
    hands.hand[0].side = a.side == WallSide::inside ? SideWish::inside : SideWish::outside;
    if (a.grip > 0.0) {
      const double room = a.grip + share * ((b.grip > 0.0 ? b.grip : a.grip) - a.grip);
      const double inner = place.x - 2.0 * radius_ - room;
      hands.hand[1] = {
          {inner * cos_, place.y, inner * sin_}, hands.hand[0].active, SideWish::inside};
    }
    hands.wheel_speed = (over ? b : a).wheel_speed;
    hands.water = a.water && !over;
    return hands;
  }

  double duration() const override { return keys_.duration(); }

  std::string_view phase(double t) const override { return keys_.phase(t); }

 private:
  Keyed<Key> keys_;
  double radius_;
  double cos_ = portable::cos(kHandAngle);
  double sin_ = portable::sin(kHandAngle);
};

// 0 below `low`, 1 above `high`, smooth between.
double rise(double h, double low, double high) {
  const double t = std::clamp((h - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

void begin(Choreography& hand) {
  hand.wheel(kWheelRough);
  hand.wait(1.0);
}

// A narrow neck over a straight body.
void collar(Former& former, const ClayDef& clay) {
  former.set_goal([&](double h) {
    const double t = h / clay.height;
    return clay.outer_radius * (0.97 - 0.45 * rise(t, 0.5, 0.78) + 0.08 * rise(t, 0.85, 1.0));
  });
  former.narrow("collar", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// A barrel, pushed out from inside; the solid foot stays.
void belly(Former& former, const ClayDef& clay) {
  former.set_goal([&](double h) {
    const double wide = portable::sin(portable::kPi * rise(h / clay.height, 0.02, 1.0));
    return std::min(clay.outer_radius * (0.95 + 0.55 * wide), 0.95 * clay.radius_max);
  });
  former.open("belly", kRough);
  former.narrow("shape", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// A foot, and a wall that flares to the rim.
void bowl(Former& former, const ClayDef& clay) {
  const double rim = std::min(2.0 * clay.outer_radius, 0.95 * clay.radius_max);
  former.set_goal([&](double h) {
    const double t = h / clay.height;
    return 0.85 * clay.outer_radius + (rim - 0.85 * clay.outer_radius) * std::sqrt(t) * t;
  });
  former.open("open", kRough);
  former.narrow("foot", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// One fingertip held to a straight wall.
void groove(Former& former, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double radius = scene.tool.radius;
  former.set_goal([&](double h) {
    const double dy = std::fabs(h - 0.6 * clay.height);
    const double cut = std::sqrt(std::max(0.0, radius * radius - dy * dy)) - 0.2 * radius;
    return clay.outer_radius - std::max(0.0, cut);
  });
  former.narrow("groove", 0.2 * kRough);
}

// A soft, wide pot spreads when it is spun fast. At this share of what holds it, half wet, there is
// room for its weight.
double steady_wheel(const SceneDef& scene, const Profile& target) {
  if (!scene.slump) return scene.wheel.max_speed;
  constexpr double kShare = 0.5;
  constexpr double kRoot3 = 1.7320508075688772;
  const double weak = scene.moisture ? strength(*scene.moisture, 0.5) : 1.0;
  const double hoop = kShare * kRoot3 * scene.slump->yield_stress * weak;
  const double speed = std::sqrt(hoop / scene.slump->density) / target.max_radius();
  return std::min(scene.wheel.max_speed, speed);
}

// The target's own outline: widen and narrow quickly, and after each go over it slowly.
// Gives the seconds that the slow passes take, which no haste shortens.
double follow(Former& former, Choreography& hand, const SceneDef& scene, const Profile& target) {
  // As many turns on the way up, however slowly the wheel has to turn.
  const double slower = std::min(1.0, steady_wheel(scene, target) / kWheelFine);
  double slow = 0.0;
  const auto finish = [&](WallSide side, std::string_view phase) {
    const double before = hand.time_on_clay();
    former.finish(side, phase, kFinish * slower);
    slow += hand.time_on_clay() - before;
  };
  former.set_goal([&](double h) { return target.outer_at(h); });
  former.open("open", kRough);
  hand.wheel(kWheelFine);
  // What stays too narrow here cannot be mended from outside.
  finish(WallSide::inside, "pull");
  former.narrow("shape", kRough);
  finish(WallSide::outside, "finish");
  return slow;
}

// A visitor watches for about this long. Small pots get slower passes, tall ones quicker.
std::vector<Key> follow_in_time(const ScriptContext& context) {
  constexpr double kWanted = 112.0;  // s at pace 1
  double haste = 1.0;
  for (int round = 0;; ++round) {
    Choreography hand(context.pace, steady_wheel(context.scene, *context.target), context.seed);
    Former former(context.scene, hand, haste);
    begin(hand);
    const double slow = follow(former, hand, context.scene, *context.target);
    former.rest();
    if (round == 1) return hand.finish();
    const double quick = hand.time_on_clay() - slow;
    const double left = std::max(kWanted / context.pace - (hand.time() - quick), 0.4 * quick);
    // Past 2.4 times the usual speed the clay no longer follows the finger.
    haste = std::clamp(quick / left, 0.5, std::max(0.5, 2.4 / context.pace));
  }
}

// Letters to change, add or drop to turn one word into the other.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, corner + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      corner = above;
    }
  }
  return row[b.size()];
}

Result<void> check(std::string_view name, const ScriptContext& context) {
  const std::string where = "script \"" + std::string(name) + "\"";
  if (std::ranges::find(kNames, name) == kNames.end()) {
    const std::string_view nearest =
        *std::ranges::min_element(kNames, {}, [&](std::string_view n) { return edits(name, n); });
    std::string all;
    for (std::string_view n : kNames) all += (all.empty() ? "" : ", ") + std::string(n);
    return problem(where, "There is no script of that name.",
                   "Did you mean \"" + std::string(nearest) + "\"? There are " + all + ".");
  }
  if (!(context.pace >= 0.25 && context.pace <= 4.0))
    return problem(where, "Its pace is outside 0.25 to 4.", "Write a pace from 0.25 to 4.");
  if (auto good = validate(context.scene); !good) return good;
  const ClayDef& clay = context.scene.clay;
  if ((name == "flare_rim" || name == "squeeze") && clay.floor_thickness > 0.5 * clay.height)
    return problem(where, "It works a wall, and this lump is solid for more than half its height.",
                   "Open it first: script \"open\".");
  std::string_view tool = carving_tool(name);
  if (tool.empty()) tool = throwing_tool(name);
  if (!tool.empty()) {
    const auto& tools = context.scene.tools;
    if (context.scene.paper || std::ranges::find(tools, tool, &ToolToHand::name) == tools.end())
      return problem(where, "It needs the " + std::string(tool) + ", which is not to hand here.",
                     "Choose a scene that has it among its tools.");
  }
  if (name != "follow") return {};
  if (context.target == nullptr)
    return problem(where, "It follows a vessel's outline, and none is given.",
                   "Choose a vessel, or a script that needs none: true, collar, belly, bowl, "
                   "groove, open, press_rim, flare_rim, squeeze, facet, flute, incise, trim_foot, "
                   "cut_off, pull_tall, collapse, dry_out, re_wet, centre, rib_smooth.");
  return validate(*context.target, where + ", target");
}

}  // namespace

std::span<const std::string_view> script_names() { return kNames; }

Result<std::unique_ptr<Script>> make_script(std::string_view name, const ScriptContext& context) {
  if (auto good = check(name, context); !good) return tl::unexpected<Problem>(good.error());
  if (name == "follow")
    return std::make_unique<PlannedScript>(follow_in_time(context), context.scene.tool.radius);
  if (!carving_tool(name).empty()) return make_carving(name, context);
  if (std::ranges::find(throwing_names(), name) != throwing_names().end())
    return make_throwing(name, context);
  const ClayDef& clay = context.scene.clay;
  Choreography hand(context.pace, context.scene.wheel.max_speed, context.seed);
  Former former(context.scene, hand);
  begin(hand);
  if (name == "true") {
    former.set_goal([&](double) { return 0.94 * clay.outer_radius; });
    former.narrow("centre", kRough);
    former.smooth(WallSide::outside, "smooth", kFine);
  } else if (name == "collar") {
    collar(former, clay);
  } else if (name == "belly") {
    belly(former, clay);
  } else if (name == "bowl") {
    bowl(former, clay);
  } else if (name == "groove") {
    groove(former, context.scene);
  } else {
    work_upright(name, hand, context.scene);
  }
  former.rest();
  return std::make_unique<PlannedScript>(hand.finish(), context.scene.tool.radius);
}

}  // namespace onggi
