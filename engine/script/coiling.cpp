#include "engine/script/coiling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/clay/clay.h"
#include "engine/effects/building.h"
#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

constexpr int kRingsLaid = 5;
constexpr double kRimSpeed = 0.06;    // m/s at pace 1: a ring of a small jar takes five seconds
constexpr double kBuildSpeed = 0.15;  // m/s: a jar of 16 rings in a minute
constexpr double kMostOfARing = 0.6;  // coils: where less is missing, no ring is laid
constexpr double kOnTop = 0.0005;     // m inside the wall's edge
constexpr double kTurns = 1.1;        // over a ring: the wheel has a little to spare
constexpr double kSpinUp = 1.0;       // s
constexpr double kBetween = 0.8;      // s at pace 1, from one ring to the next
constexpr double kAbove = 0.04;       // m: where the hand waits
constexpr double kPressed = 0.0005;   // m: how deep the coil rests on the rim

class Coiling final : public Script {
 public:
  /// `target`: the vessel whose line the rings follow; null: five rings, one on the other.
  Coiling(const ScriptContext& context, const Profile* target)
      : coil_((context.scene.building ? *context.scene.building : BuildingDef{}).coil),
        between_(kBetween / context.pace) {
    const BuildingDef law = context.scene.building ? *context.scene.building : BuildingDef{};
    const ClayDef& lump = context.scene.clay;
    double rim = std::max(lump.outer_radius, coil_);
    double speed = kRimSpeed;
    if (target != nullptr) {
      target_ = *target;
      rim = std::max(rim, target->max_radius());
      speed = kBuildSpeed;
      const double ring = effects::Building::ring_height(law, lump);
      rings_ = static_cast<int>(std::ceil(std::max(target->height() - lump.height, 0.0) / ring));
    }
    speed = std::min(speed * context.pace, 0.8 * law.pace);
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
    const bool closed = clay.rim_height() > rim_ + 0.5 * coil_ || high_enough(clay);
    const double out = place(clay);
    const double down = closed ? 0.0 : std::min(1.0, within / between_);
    const double up = kAbove * (1.0 - down);
    const double height = clay.rim_height() + 0.5 * coil_ - kPressed + up;
    hands.hand[0].position = {out * portable::cos(kHandAngle), height,
                              out * portable::sin(kHandAngle)};
    hands.hand[0].active = true;
    hands.hand[0].coil = true;
    return hands;
  }

  double duration() const override { return kSpinUp + rings_ * ring_; }

  std::string_view phase(double t) const override {
    if (t < kSpinUp) return "wheel";
    return std::fmod(t - kSpinUp, ring_) < between_ ? "next" : "lay";
  }

 private:
  bool high_enough(const Clay& clay) const {
    return target_ && clay.rim_height() + kMostOfARing * coil_ >= target_->height();
  }
  // Above the middle of the rim, or at the edge of a lump that is solid to the top; or where the
  // next ring's outer face is on the vessel's line, as far as it can rest on the wall.
  double place(const Clay& clay) const {
    const int top = clay.rows() - 1;
    const double outer = double{clay.outer(top)[0]}, inner = double{clay.inner(top)[0]};
    const double middle = inner > 0.0 ? 0.5 * (outer + inner) : outer - 0.5 * coil_;
    if (!target_) return middle;
    const double least = inner > 0.0 ? inner + kOnTop : outer - coil_, most = outer - kOnTop;
    const double wanted =
        target_->outer_at(std::min(clay.rim_height() + coil_, target_->height())) - 0.5 * coil_;
    return least < most ? std::clamp(wanted, least, most) : middle;
  }

  double coil_, between_;
  std::optional<Profile> target_;
  int rings_ = kRingsLaid;
  double wheel_ = 0.0;
  double ring_ = 0.0;  // s
  double rim_ = 0.0;   // m, before this ring
};

}  // namespace

std::unique_ptr<Script> lay_rings(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<Coiling>(context, nullptr);
}

std::unique_ptr<Script> build_up(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<Coiling>(context, context.target);
}

bool coils_come_near(const Profile& target, double coil) {
  constexpr double kMostLean = 0.45, kRing = 0.89;  // coils
  constexpr double kNear = 0.018;                   // of the height
  double outer = target.outer_at(0.0), squares = 0.0;
  int rings = 0;
  for (double h = kRing * coil; h < target.height(); h += kRing * coil, ++rings) {
    const double wanted = target.outer_at(h);
    outer = std::clamp(wanted, outer - kMostLean * coil, outer + kMostLean * coil);
    squares += (outer - wanted) * (outer - wanted);
  }
  return rings > 0 && std::sqrt(squares / rings) < kNear * target.height();
}

}  // namespace onggi::script
