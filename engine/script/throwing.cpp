#include "engine/script/throwing.h"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi {
namespace {

constexpr double kClear = 0.012;  // m: how far from the clay a hand is lifted
constexpr double kSlow = 10.0;    // rad/s: pulling; centring is twice as fast
constexpr double kFast = 25.0;

constexpr std::array<std::string_view, 6> kNames{"pull_tall", "collapse", "dry_out",
                                                 "re_wet",    "centre",   "rib_smooth"};

// Both hands at one height; straight between two keys. Of the height `rising` is the share of the
// rim's, so that hands follow a pot that grows.
struct ThrowingKey {
  double time = 0.0;
  double outside = 0.0, inside = 0.0;  // from the axis, m; 0: that hand is away
  double height = 0.0, rising = 0.0;
  double wheel_speed = 0.0;
  bool water = false;
  std::uint8_t tool = 0;
  std::string_view phase;
};

class ThrowingScript final : public Script {
 public:
  explicit ThrowingScript(std::vector<ThrowingKey> keys) : keys_(std::move(keys)) {}

  Hands at(double t, const Clay& clay) noexcept override {
    const auto between = keys_.at(t);
    const ThrowingKey& a = between.from;
    const ThrowingKey& b = between.to;
    const double height =
        between(a.height, b.height) + between(a.rising, b.rising) * clay.rim_height();
    const auto put = [&](HandInput& hand, double from, double to, SideWish side) {
      hand.active = from > 0.0 && to > 0.0 && t < duration();
      const double out = between(from, to);
      hand.position = {out * portable::cos(kHandAngle), height, out * portable::sin(kHandAngle)};
      hand.side = side;
    };
    Hands hands;
    put(hands.hand[0], a.outside, b.outside, SideWish::outside);
    put(hands.hand[1], a.inside, b.inside, SideWish::inside);
    hands.hand[0].tool = a.tool;
    hands.wheel_speed = t < duration() ? a.wheel_speed : 0.0;
    hands.water = a.water && t < duration();
    return hands;
  }
  double duration() const override { return keys_.duration(); }
  std::string_view phase(double t) const override { return keys_.phase(t); }

 private:
  Keyed<ThrowingKey> keys_;
};

// Writes the keys down.
class Thrower {
 public:
  explicit Thrower(const ScriptContext& context)
      : clay(context.scene.clay), finger(context.scene.tool.radius), pace_(context.pace) {}

  ThrowingKey now;
  void put() { keys_.push_back(now); }
  // As things are now, for `seconds` at any pace.
  void wait(double seconds) {
    put();
    now.time += seconds;
    put();
  }
  // To what `change` makes of it, in `seconds` at pace 1.
  template <class Change>
  void move(double seconds, const Change& change) {
    put();
    now.time += seconds / pace_;
    change(now);
    put();
  }
  void lift() {
    put();
    now.outside = now.inside = 0.0;
    wait(0.3);
  }
  std::vector<ThrowingKey> finish() {
    now.wheel_speed = 0.0;
    now.water = false;
    lift();
    return std::move(keys_);
  }

  const ClayDef& clay;
  const double finger;
  double middle() const { return 0.5 * (clay.outer_radius + clay.inner_radius); }
  double wall() const { return clay.outer_radius - clay.inner_radius; }

 private:
  double pace_;
  std::vector<ThrowingKey> keys_;
};

// The sponge, held beside the wall halfway up.
void soak(Thrower& hand, double seconds) {
  hand.now.phase = "soak";
  hand.now.height = 0.0;
  hand.now.rising = 0.5;
  hand.now.outside = hand.clay.outer_radius + hand.finger + kClear;
  hand.now.water = true;
  hand.wait(seconds);
  hand.now.water = false;
  hand.lift();
}

// Up the wall between two fingers, which leave `room` of it.
void pull(Thrower& hand, double room) {
  const double low = hand.clay.floor_thickness + 1.2 * hand.finger;
  const double off = 0.5 * room + hand.finger;
  const double open = 0.5 * hand.wall() + hand.finger + 0.004;
  const auto grip = [&](ThrowingKey& key, double apart) {
    key.outside = hand.middle() + apart;
    key.inside = std::max(hand.middle() - apart, 0.001);
  };
  hand.now.phase = "pull";
  hand.now.height = low;
  hand.now.rising = 0.0;
  grip(hand.now, open);
  hand.move(0.8, [&](ThrowingKey& key) { grip(key, off); });
  hand.wait(0.6);
  hand.move(5.0, [&](ThrowingKey& key) {
    key.height = hand.finger;
    key.rising = 1.0;
  });
  hand.lift();
}

void pull_tall(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  soak(hand, 0.1);  // damp: wet clay would not stand as tall
  for (const double share : {0.8, 0.66, 0.55, 0.46})
    pull(hand, std::max(share * hand.wall(), 1.3 * hand.clay.wall_min));
}

void collapse(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  for (const double share : {0.75, 0.55, 0.4}) {
    soak(hand, 2.0);
    pull(hand, std::max(share * hand.wall(), 1.2 * hand.clay.wall_min));
  }
  hand.now.phase = "drown";
  hand.now.wheel_speed = kFast;
  for (const double height : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    hand.now.outside = hand.clay.outer_radius + hand.finger + 2.0 * kClear;
    hand.now.height = 0.0;
    hand.now.rising = height;
    hand.now.water = true;
    hand.wait(3.0);
  }
  hand.now.water = false;
  hand.lift();
  hand.now.phase = "fall";
  hand.wait(6.0);
}

// A finger that lies against the wall for three seconds, a millimetre deep at the end.
void lean(Thrower& hand, double rising, std::string_view phase) {
  hand.now.phase = phase;
  hand.now.height = 0.0;
  hand.now.rising = rising;
  hand.now.outside = hand.clay.outer_radius + hand.finger + 0.002;
  hand.move(1.0, [&](ThrowingKey& key) { key.outside -= 0.003; });
  hand.wait(2.0);
  hand.lift();
}

void dry_out(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  soak(hand, 3.0);
  lean(hand, 0.6, "wet");
  hand.now.phase = "dry";
  hand.wait(20.0);
  lean(hand, 0.4, "drier");
}

void re_wet(Thrower& hand) {
  dry_out(hand);
  soak(hand, 3.0);
  lean(hand, 0.25, "wet again");
}

void centre(Thrower& hand) {
  hand.now.wheel_speed = kFast;
  hand.wait(1.5);
  hand.now.phase = "centre";
  hand.now.rising = 0.5;
  hand.now.outside = hand.clay.outer_radius + hand.finger + 0.008;
  hand.move(8.0, [&](ThrowingKey& key) { key.outside -= 0.009; });
  hand.wait(2.0);
  hand.lift();
}

void rib_smooth(Thrower& hand, std::uint8_t tool, const ToolSize& rib) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  // Faster than a finger is wide in a turn: it leaves a line.
  hand.now.phase = "line";
  hand.now.rising = 0.35;
  hand.now.outside = hand.clay.outer_radius + hand.finger - 0.0006;
  hand.move(4.0, [&](ThrowingKey& key) { key.rising = 0.65; });
  hand.lift();
  hand.now.phase = "rib";
  hand.now.tool = tool;
  hand.now.rising = 0.5;
  hand.now.outside = hand.clay.outer_radius + 0.5 * rib.thickness + 0.002;
  hand.move(1.0, [&](ThrowingKey& key) { key.outside -= 0.0024; });
  hand.wait(3.0);
  hand.lift();
}

}  // namespace

std::span<const std::string_view> throwing_names() { return kNames; }

bool throwing_shows(std::string_view name, const SceneDef& scene) {
  if (scene.paper) return false;
  if (name == "pull_tall") return scene.volume.has_value();
  if (name == "collapse") return scene.slump.has_value();
  if (name == "dry_out" || name == "re_wet") return scene.moisture.has_value();
  if (name == "centre") return scene.wobble.has_value();
  return name == "rib_smooth" && scene.smoothing &&
         std::ranges::find(scene.tools, throwing_tool(name), &ToolToHand::name) !=
             scene.tools.end();
}

std::string_view throwing_tool(std::string_view name) {
  return name == "rib_smooth" ? "flat_rib" : std::string_view();
}

std::unique_ptr<Script> make_throwing(std::string_view name, const ScriptContext& context) {
  if (std::ranges::find(kNames, name) == kNames.end()) return nullptr;
  const std::string_view wanted = throwing_tool(name);
  const auto& tools = context.scene.tools;
  const auto tool = std::ranges::find(tools, wanted, &ToolToHand::name);
  if (!wanted.empty() && tool == tools.end()) return nullptr;
  Thrower hand(context);
  if (name == "pull_tall") pull_tall(hand);
  if (name == "collapse") collapse(hand);
  if (name == "dry_out") dry_out(hand);
  if (name == "re_wet") re_wet(hand);
  if (name == "centre") centre(hand);
  if (name == "rib_smooth")
    rib_smooth(hand, static_cast<std::uint8_t>(tool - tools.begin() + 1),
               sized(*find_tool_shape(wanted), tool->size));
  return std::make_unique<ThrowingScript>(hand.finish());
}

}  // namespace onggi
