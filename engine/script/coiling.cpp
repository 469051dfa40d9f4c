#include "engine/script/coiling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/clay/clay.h"
#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

constexpr int kRingsLaid = 5;
constexpr double kRimSpeed = 0.06;   // m/s at pace 1: a ring of a small jar takes five seconds
constexpr double kTurns = 1.1;       // over a ring: the wheel has a little to spare
constexpr double kSpinUp = 1.0;      // s
constexpr double kBetween = 0.8;     // s at pace 1, from one ring to the next
constexpr double kAbove = 0.04;      // m: where the hand waits
constexpr double kPressed = 0.0005;  // m: how deep the coil rests on the rim

class Coiling final : public Script {
 public:
  explicit Coiling(const ScriptContext& context)
      : coil_((context.scene.building ? *context.scene.building : BuildingDef{}).coil),
        between_(kBetween / context.pace) {
    const BuildingDef law = context.scene.building ? *context.scene.building : BuildingDef{};
    const double rim = std::max(context.scene.clay.outer_radius, coil_);
    const double speed = std::min(kRimSpeed * context.pace, 0.8 * law.pace);
    wheel_ = std::min(speed / rim, context.scene.wheel.max_speed);
    const double turn = wheel_ > 0.0 ? 2.0 * portable::kPi / wheel_ : 1.0;
    ring_ = kTurns * turn + between_;
  }

  Hands at(double t, const Clay& clay) noexcept override {
    Hands hands;
    hands.wheel_speed = wheel_;
    const double since = t - kSpinUp;
    if (since < 0.0 || t >= duration()) return hands;
    const double within = std::fmod(since, ring_);
    if (within < between_) rim_ = clay.rim_height();
    const bool closed = clay.rim_height() > rim_ + 0.5 * coil_;
    // Above the middle of the rim, or at the edge of a lump that is solid to the top.
    const int top = clay.rows() - 1;
    const double outer = double{clay.outer(top)[0]}, inner = double{clay.inner(top)[0]};
    const double out = inner > 0.0 ? 0.5 * (outer + inner) : outer - 0.5 * coil_;
    const double down = closed ? 0.0 : std::min(1.0, within / between_);
    const double up = kAbove * (1.0 - down);
    const double height = clay.rim_height() + 0.5 * coil_ - kPressed + up;
    hands.hand[0].position = {out * portable::cos(kHandAngle), height,
                              out * portable::sin(kHandAngle)};
    hands.hand[0].active = true;
    hands.hand[0].coil = true;
    return hands;
  }

  double duration() const override { return kSpinUp + kRingsLaid * ring_; }

  std::string_view phase(double t) const override {
    if (t < kSpinUp) return "wheel";
    return std::fmod(t - kSpinUp, ring_) < between_ ? "next" : "lay";
  }

 private:
  double coil_, between_;
  double wheel_ = 0.0;
  double ring_ = 0.0;  // s
  double rim_ = 0.0;   // m, before this ring
};

}  // namespace

std::unique_ptr<Script> lay_rings(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<Coiling>(context);
}

}  // namespace onggi::script
