#include "engine/script/demonstrations.h"

#include <algorithm>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

constexpr double kHandClear = 0.012;  // m: how far from the clay a hand is lifted
constexpr double kSlow = 10.0;        // rad/s: pulling; centring is twice as fast
constexpr double kFast = 25.0;

}  // namespace

// A key of both hands at one height; linear between two keys. `rising` is the part of the height
// that scales with the rim, so that hands follow a pot that grows.
struct PairKey {
  double time = 0.0;
  double outside = 0.0, inside = 0.0;  // distance from the axis, m; 0: that hand is away
  double height = 0.0, rising = 0.0;
  double wheel_speed = 0.0;
  bool water = false;
  std::uint8_t tool = 0;
  std::string_view phase;
};

namespace {

class PairScript final : public Script {
 public:
  explicit PairScript(std::vector<PairKey> keys) : keys_(std::move(keys)) {}

  Hands at(double t, const Clay& clay) noexcept override {
    const auto between = keys_.at(t);
    const PairKey& a = between.from;
    const PairKey& b = between.to;
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
  Keyed<PairKey> keys_;
};

}  // namespace

// Writes the keys down.
class Thrower {
 public:
  Thrower(const ScriptContext& context, const ToolInHand& tool)
      : clay(context.scene.clay),
        finger(context.scene.tool.radius),
        rib(tool),
        pace_(context.pace) {}

  PairKey now;
  void put() { keys_.push_back(now); }
  // Holds this for `seconds`, whatever the pace.
  void wait(double seconds) {
    put();
    now.time += seconds;
    put();
  }
  // Goes to `change` in `seconds` at pace 1.
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
  std::vector<PairKey> finish() {
    now.wheel_speed = 0.0;
    now.water = false;
    lift();
    return std::move(keys_);
  }

  const ClayDef& clay;
  const double finger;
  const ToolInHand& rib;
  double middle() const { return 0.5 * (clay.outer_radius + clay.inner_radius); }
  double wall() const { return clay.outer_radius - clay.inner_radius; }

 private:
  double pace_;
  std::vector<PairKey> keys_;
};

namespace {

// The sponge, held beside the wall halfway up.
void soak(Thrower& hand, double seconds) {
  hand.now.phase = "soak";
  hand.now.height = 0.0;
  hand.now.rising = 0.5;
  hand.now.outside = hand.clay.outer_radius + hand.finger + kHandClear;
  hand.now.water = true;
  hand.wait(seconds);
  hand.now.water = false;
  hand.lift();
}

// Up the wall between two fingers, `room` apart.
void pull(Thrower& hand, double room) {
  const double low = hand.clay.floor_thickness + 1.2 * hand.finger;
  const double off = 0.5 * room + hand.finger;
  const double open = 0.5 * hand.wall() + hand.finger + 0.004;
  const auto grip = [&](PairKey& key, double apart) {
    key.outside = hand.middle() + apart;
    key.inside = std::max(hand.middle() - apart, 0.001);
  };
  hand.now.phase = "pull";
  hand.now.height = low;
  hand.now.rising = 0.0;
  grip(hand.now, open);
  hand.move(0.8, [&](PairKey& key) { grip(key, off); });
  hand.wait(0.6);
  hand.move(5.0, [&](PairKey& key) {
    key.height = hand.finger;
    key.rising = 1.0;
  });
  hand.lift();
}

// A finger against the wall for three seconds, a millimetre deep at the end.
void lean(Thrower& hand, double rising, std::string_view phase) {
  hand.now.phase = phase;
  hand.now.height = 0.0;
  hand.now.rising = rising;
  hand.now.outside = hand.clay.outer_radius + hand.finger + 0.002;
  hand.move(1.0, [&](PairKey& key) { key.outside -= 0.003; });
  hand.wait(2.0);
  hand.lift();
}

}  // namespace

void pull_four_times(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  soak(hand, 0.1);  // damp: wet clay would not stand as tall
  for (const double share : {0.8, 0.66, 0.55, 0.46})
    pull(hand, std::max(share * hand.wall(), 1.3 * hand.clay.wall_min));
}

void pull_and_drown(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  for (const double share : {0.75, 0.55, 0.4}) {
    soak(hand, 2.0);
    pull(hand, std::max(share * hand.wall(), 1.2 * hand.clay.wall_min));
  }
  hand.now.phase = "drown";
  hand.now.wheel_speed = kFast;
  for (const double height : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    hand.now.outside = hand.clay.outer_radius + hand.finger + 2.0 * kHandClear;
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

void press_wet_and_drier(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  soak(hand, 3.0);
  lean(hand, 0.6, "wet");
  hand.now.phase = "dry";
  hand.wait(20.0);
  lean(hand, 0.4, "drier");
}

void press_and_wet_again(Thrower& hand) {
  press_wet_and_drier(hand);
  soak(hand, 3.0);
  lean(hand, 0.25, "wet again");
}

void press_steadily(Thrower& hand) {
  hand.now.wheel_speed = kFast;
  hand.wait(1.5);
  hand.now.phase = "centre";
  hand.now.rising = 0.5;
  hand.now.outside = hand.clay.outer_radius + hand.finger + 0.008;
  hand.move(8.0, [&](PairKey& key) { key.outside -= 0.009; });
  hand.wait(2.0);
  hand.lift();
}

void draw_and_even(Thrower& hand) {
  hand.now.wheel_speed = kSlow;
  hand.wait(1.0);
  // Rises by more than a finger's width in a turn: it leaves a line.
  hand.now.phase = "line";
  hand.now.rising = 0.35;
  hand.now.outside = hand.clay.outer_radius + hand.finger - 0.0006;
  hand.move(4.0, [&](PairKey& key) { key.rising = 0.65; });
  hand.lift();
  hand.now.phase = "rib";
  hand.now.tool = hand.rib.index;
  hand.now.rising = 0.5;
  hand.now.outside = hand.clay.outer_radius + 0.5 * hand.rib.size.thickness + 0.002;
  hand.move(1.0, [&](PairKey& key) { key.outside -= 0.0024; });
  hand.wait(3.0);
  hand.lift();
}

std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand& tool,
                             Throwing& moves) {
  Thrower hand(context, tool);
  moves(hand);
  return std::make_unique<PairScript>(hand.finish());
}

}  // namespace onggi::script
