#include "engine/script/coiling.h"

#include <algorithm>
#include <cmath>

#include "engine/clay/clay.h"
#include "engine/effects/building.h"
#include "engine/math/portable.h"
#include "engine/script/beating_up.h"
#include "engine/script/keyed.h"
#include "engine/script/ring_plan.h"

namespace onggi::script {
namespace {

constexpr int kRingsLaid = 5;
constexpr double kRimSpeed = 0.06;    // m/s at pace 1: a ring of a small jar takes five seconds
constexpr double kBuildSpeed = 0.25;  // m/s
constexpr double kOnTop = 0.0005;     // m inside the wall's edge
constexpr double kTurns = 1.1;        // over a ring: the wheel has a little to spare
constexpr double kSpinUp = 1.0;       // s
constexpr double kBetween = 0.8;      // s at pace 1, from one ring to the next
constexpr double kRisen = 0.3;        // of that: the ring below has become clay
constexpr double kAbove = 0.04;       // m: where the hand waits
constexpr double kPressed = 0.0005;   // m: how deep the coil rests on the rim
constexpr int kWays = 4;              // that the paddle goes up or down a vessel, at most
constexpr double kWay = 16.0;         // s at pace 1
constexpr double kDries = 10.0;       // s that charcoal hangs in the pot before the first blow

// A hand that lays ring on ring, and how long each takes.
class CoilUp {
 public:
  /// `radius` (m): of the widest ring. `speed`: of the rim under the hand, m/s at pace 1.
  CoilUp(const ScriptContext& context, double radius, double speed)
      : coil_(law_of(context.scene).coil), between_(kBetween / context.pace) {
    speed = std::min(speed * context.pace, 0.8 * law_of(context.scene).pace);
    wheel_ = std::min(speed / std::max(radius, coil_), context.scene.wheel.max_speed);
    ring_ = kTurns * (wheel_ > 0.0 ? 2.0 * portable::kPi / wheel_ : 1.0) + between_;
  }

  double wheel() const { return wheel_; }  ///< rad/s
  double ring() const { return ring_; }    ///< s

  /// `t` s after the first call. True as the first ring begins, and as the next one does after one
  /// has closed and risen.
  bool begins(double t, const Clay& clay) noexcept {
    const double rim = clay.rim_height();
    if (rim > rim_ + 0.5 * coil_) began_ = t, rises_ = true;
    // A ring rises for some ticks, and a wet wall sags.
    rim_ = rises_ ? rim : std::min(rim_, rim);
    if (!rises_ || t - began_ < kRisen * between_) return false;
    rises_ = false;
    return true;
  }
  /// `wanted`: where the coil's middle belongs, m from the axis. The hand waits above unless it
  /// `lays`.
  HandInput at(double t, bool lays, double wanted, const Clay& clay) const noexcept {
    const double down = lays ? std::min(1.0, (t - began_) / between_) : 0.0;
    const double out = on_rim(wanted, clay);
    HandInput hand;
    hand.position = {out * portable::cos(kHandAngle),
                     clay.rim_height() + 0.5 * coil_ - kPressed + kAbove * (1.0 - down),
                     out * portable::sin(kHandAngle)};
    hand.active = true;
    hand.coil = true;
    return hand;
  }
  /// The hand comes down for the next ring.
  bool comes_down(double t) const { return t - began_ < between_; }
  /// Above the middle of the rim, or at the edge of a lump that is solid to the top.
  double middle_of_rim(const Clay& clay) const {
    const int top = clay.rows() - 1;
    const double outer = double{clay.outer(top)[0]}, inner = double{clay.inner(top)[0]};
    return inner > 0.0 ? 0.5 * (outer + inner) : outer - 0.5 * coil_;
  }

  static const BuildingDef& law_of(const SceneDef& scene) {
    static const BuildingDef kUsual;
    return scene.building ? *scene.building : kUsual;
  }

 private:
  // As far as a coil can rest on the wall. A solid floor bears it everywhere.
  double on_rim(double wanted, const Clay& clay) const {
    const int top = clay.rows() - 1;
    const double outer = double{clay.outer(top)[0]}, inner = double{clay.inner(top)[0]};
    const double least = inner > 0.0 ? inner + kOnTop : 0.5 * coil_, most = outer - kOnTop;
    return least < most ? std::clamp(wanted, least, most) : middle_of_rim(clay);
  }

  double coil_, between_;
  double wheel_ = 0.0;
  double ring_ = 0.0;   // s
  double rim_ = -1.0;   // m, of this ring; none yet
  double began_ = 0.0;  // s
  bool rises_ = true;
};

// Five rings, one on the other.
class Coiling final : public Script {
 public:
  explicit Coiling(const ScriptContext& context)
      : coil_(context, context.scene.clay.outer_radius, kRimSpeed) {}

  Hands at(double t, const Clay& clay) noexcept override {
    Hands hands;
    hands.wheel_speed = coil_.wheel();
    const double since = t - kSpinUp;
    if (since < 0.0 || t >= duration()) return hands;
    if (coil_.begins(since, clay)) ++begun_;
    hands.hand[0] = coil_.at(since, begun_ <= kRingsLaid, coil_.middle_of_rim(clay), clay);
    return hands;
  }
  double duration() const override { return kSpinUp + kRingsLaid * coil_.ring(); }
  std::string_view phase(double t) const override {
    if (t < kSpinUp) return "wheel";
    return coil_.comes_down(t - kSpinUp) ? "next" : "lay";
  }

 private:
  CoilUp coil_;
  int begun_ = 0;
};

// A vessel: rings by its plan, and then blows.
class BuildingUp final : public Script {
 public:
  explicit BuildingUp(const ScriptContext& context)
      : plan_(*context.target, context.scene.clay.height, CoilUp::law_of(context.scene),
              context.scene.beating),
        coil_(context, std::max(context.scene.clay.outer_radius, context.target->max_radius()),
              kBuildSpeed),
        paddle_(context.scene, context.pace, &plan_),
        beating_wheel_(std::min(PaddleUp::kSpeed * context.pace, context.scene.wheel.max_speed)),
        way_(kWay / context.pace),
        pause_(context.scene.moisture && context.scene.beating ? kDries : kSpinUp),
        rings_(plan_.rings()) {}

  Hands at(double t, const Clay& clay) noexcept override {
    Hands hands;
    const double since = t - kSpinUp;
    if (since >= 0.0 && since >= laid_by() && beats_from_ < 0.0) beats_from_ = since + pause_;
    const double beats = beats_from_ < 0.0 ? -1.0 : since - beats_from_;
    hands.wheel_speed = beats_from_ < 0.0 ? coil_.wheel() : beating_wheel_;
    hands.fire = beats_from_ >= 0.0 && plan_.beats() && t < duration() && !done_;
    if (since < 0.0 || t >= duration() || done_) return hands;
    if (beats_from_ < 0.0) {
      if (coil_.begins(since, clay)) {
        begun_ = true;
        lacks_ = plan_.lacks_a_ring(clay);
        wanted_ = plan_.next_ring(clay);
      }
      hands.hand[0] = coil_.at(since, lacks_, wanted_, clay);
      if (begun_ && !lacks_) beats_from_ = since + pause_;
    } else if (beats >= 0.0 && plan_.beats()) {
      const auto way = static_cast<int>(beats / way_);
      const double share = beats / way_ - way;
      if (way != way_now_) {
        way_now_ = way;
        done_ = way >= kWays || !plan_.to_beat(clay);
      }
      hands.hand[0] = paddle_.at(beats, way % 2 == 0 ? share : 1.0 - share, clay);
    }
    return hands;
  }

  double duration() const override {
    return kSpinUp + laid_by() + (plan_.beats() ? pause_ + kWays * way_ : 0.0);
  }
  std::string_view phase(double t) const override {
    const double since = t - kSpinUp;
    if (since < 0.0) return "wheel";
    if (beats_from_ >= 0.0 && since >= beats_from_) return "beat";
    if (beats_from_ >= 0.0 && plan_.beats()) return "dry";
    return coil_.comes_down(since) ? "next" : "lay";
  }

 private:
  // s from the first ring on
  double laid_by() const { return rings_ * coil_.ring(); }

  RingPlan plan_;
  CoilUp coil_;
  PaddleUp paddle_;
  double beating_wheel_, way_, pause_;  // rad/s, s, s
  int rings_;
  bool begun_ = false, lacks_ = false, done_ = false;
  double wanted_ = 0.0;       // m from the axis
  double beats_from_ = -1.0;  // s; less than 0: rings are laid
  int way_now_ = 0;
};

}  // namespace

std::unique_ptr<Script> lay_rings(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<Coiling>(context);
}

std::unique_ptr<Script> build_up(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<BuildingUp>(context);
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
