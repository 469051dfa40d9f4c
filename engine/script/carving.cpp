#include "engine/script/carving.h"

#include <algorithm>
#include <vector>

#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

using namespace carving;

constexpr double kClear = 0.012;    // m: how far from the clay a hand is lifted
constexpr double kApproach = 0.05;  // m/s
constexpr double kQuarterTurn = 0.5 * portable::kPi;

}  // namespace

// A key of one hand with one tool, in cylinder coordinates; linear between two keys.
struct CarvingKey {
  double time = 0.0;
  double out = 0.0, angle = 0.0, height = 0.0;
  double wheel_speed = 0.0;
  double roll = 0.0;
  bool active = false;
  std::string_view phase = "carry";
};

namespace {

class CarvingScript final : public Script {
 public:
  CarvingScript(std::vector<CarvingKey> keys, std::uint8_t tool)
      : keys_(std::move(keys)), tool_(tool) {}

  Hands at(double t, const Clay&) noexcept override {
    const auto between = keys_.at(t);
    const CarvingKey& a = between.from;
    const CarvingKey& b = between.to;
    const double out = between(a.out, b.out);
    const double angle = between(a.angle, b.angle);
    Hands hands;
    hands.hand[0].position = {out * portable::cos(angle), between(a.height, b.height),
                              out * portable::sin(angle)};
    hands.hand[0].active = a.active && t < duration();
    hands.hand[0].side = SideWish::outside;
    hands.hand[0].tool = tool_;
    hands.hand[0].roll = a.roll;
    hands.wheel_speed = t < duration() ? a.wheel_speed : b.wheel_speed;
    return hands;
  }
  double duration() const override { return keys_.duration(); }
  std::string_view phase(double t) const override { return keys_.phase(t); }

 private:
  Keyed<CarvingKey> keys_;
  std::uint8_t tool_;
};

}  // namespace

// Writes the keys down.
class Carver {
 public:
  explicit Carver(const ScriptContext& context) : clay(context.scene.clay), pace_(context.pace) {
    now_.angle = kHandAngle;
    now_.out = clay.outer_radius + 5.0 * kClear;
  }

  void phase(std::string_view name) { now_.phase = name; }
  void wheel(double speed) { now_.wheel_speed = speed * std::min(pace_, 1.5); }
  void roll(double angle) { now_.roll = angle; }
  void put(bool active) {
    now_.active = active;
    keys_.push_back(now_);
  }
  // A lifted hand arrives at once; its way is not drawn.
  void set_down(double out, double angle, double height) {
    put(false);
    now_.time += 0.3 / pace_;
    now_.out = out;
    now_.angle = angle;
    now_.height = height;
    put(true);
  }
  void move(double out, double angle, double height, double speed) {
    const double round = (angle - now_.angle) * out;
    const double way = length(Vec3{out - now_.out, height - now_.height, round});
    now_.time += way / (speed * pace_);
    now_.out = out;
    now_.angle = angle;
    now_.height = height;
    put(true);
  }
  void wait(double seconds) {
    put(now_.active);
    now_.time += seconds;
    put(now_.active);
  }
  std::vector<CarvingKey> finish() {
    put(false);
    now_.time += 0.2;
    put(false);
    return std::move(keys_);
  }

  const ClayDef& clay;

 private:
  double pace_;
  CarvingKey now_;
  std::vector<CarvingKey> keys_;
};

// Flats all round the belly, one after another, the wheel still.
void press_flats(Carver& hand, const ToolSize& rib) {
  hand.phase("facet");
  const double touch = hand.clay.outer_radius + 0.5 * rib.thickness;
  for (int n = 0; n < kFacets; ++n) {
    const double angle = kHandAngle + 2.0 * portable::kPi * n / kFacets;
    hand.set_down(touch + kClear, angle, 0.55 * hand.clay.height);
    hand.move(touch, angle, 0.55 * hand.clay.height, kApproach);
    hand.move(touch - kFacetDeep, angle, 0.55 * hand.clay.height, 0.4 * kApproach);
    hand.wait(0.15);
    hand.move(touch + kClear, angle, 0.55 * hand.clay.height, kApproach);
  }
}

// Grooves drawn upwards at even angles, the loop held level.
void draw_grooves(Carver& hand, const ToolSize& loop) {
  hand.phase("flute");
  const double touch = hand.clay.outer_radius + loop.radius;
  const double low = 0.15 * hand.clay.height;
  const double high = 0.85 * hand.clay.height;
  hand.roll(kQuarterTurn);
  for (int n = 0; n < kFlutes; ++n) {
    const double angle = kHandAngle + 2.0 * portable::kPi * n / kFlutes;
    hand.set_down(touch + kClear, angle, low);
    hand.move(touch - kFluteDeep, angle, low, kApproach);
    hand.move(touch - kFluteDeep, angle, high, 0.06);
    hand.move(touch + kClear, angle, high, kApproach);
  }
}

// A line up the wall, the wheel slow.
void wind_line(Carver& hand, const ToolSize& needle) {
  hand.phase("incise");
  constexpr double kWheel = 1.5;  // rad/s
  const double touch = hand.clay.outer_radius + needle.radius;
  const double low = 0.3 * hand.clay.height;
  const double turns = 3.0;
  hand.wheel(kWheel);
  hand.wait(0.5);
  hand.set_down(touch + kClear, kHandAngle, low);
  hand.move(touch - kLineDeep, kHandAngle, low, kApproach);
  hand.wait(2.0 * portable::kPi / kWheel);
  hand.move(touch - kLineDeep, kHandAngle, low + turns * kLineRise,
            kLineRise * kWheel / (2.0 * portable::kPi));
  hand.move(touch + kClear, kHandAngle, low + turns * kLineRise, kApproach);
  hand.wheel(0.0);
}

// Clay turned off the foot.
void turn_off_foot(Carver& hand, const ToolSize& loop) {
  hand.phase("trim_foot");
  constexpr double kWheel = 12.0;  // rad/s
  const double touch = hand.clay.outer_radius + loop.radius;
  hand.wheel(kWheel);
  hand.wait(1.0);
  hand.set_down(touch + kClear, kHandAngle, 2.5 * loop.radius);
  hand.move(touch, kHandAngle, 2.5 * loop.radius, kApproach);
  hand.move(touch - kFootDeep, kHandAngle, 1.5 * loop.radius, 0.01);
  hand.move(touch - kFootDeep, kHandAngle, loop.radius, 0.01);
  hand.wait(3.0 * 2.0 * portable::kPi / kWheel);
  hand.move(touch + kClear, kHandAngle, loop.radius, kApproach);
  hand.wheel(0.0);
}

// The wire, drawn under the pot from one side to the other.
void draw_wire(Carver& hand, const ToolSize&) {
  hand.phase("cut_off");
  const double beyond = hand.clay.outer_radius + 2.0 * kClear;
  hand.wait(0.5);
  hand.set_down(beyond, kHandAngle, kSlit);
  hand.wait(0.1);
  hand.move(-beyond, kHandAngle, kSlit, 0.08);
}

std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand& tool, Carving& moves) {
  Carver hand(context);
  moves(hand, tool.size);
  return std::make_unique<CarvingScript>(hand.finish(), tool.index);
}

}  // namespace onggi::script
