#pragma once

#include <array>

#include "engine/force/tool_touch.h"

namespace onggi::force {

/// Limits of a coupling.
struct CouplingLimits {
  double stiffness = 0;  ///< N/m, > 0: of the spring between hand and tool.
  double max_force = 0;  ///< N, >= 0: the spring is never stretched farther than this force.
};

/// A virtual coupling: a spring between a hand and the tool in the clay (Colgate, Stanley & Brown,
/// Issues in the Haptic Display of Tool Use, 1995). The hand feels only that spring, so clay, floor
/// and wheel head are never stiffer than the device bears. A spring in series leaves a dashpot as
/// it is, so clay that gives way keeps its weight.
///
/// The tool has no mass: each tick it goes to where spring and clay balance. Along the push this is
/// one Newton step with the clay's stiffness (an upper bound, so that the tool comes from one
/// side). Across the push the clay carries the tool along until the spring pulls harder than `grip`
/// (return mapping: Simo & Hughes, Computational Inelasticity, 1998); this needs no velocity. Clear
/// of the clay hand and tool are one.
///
/// The hand feels the spring to the tool's mean place over kMean, because elements come under a
/// tool whole and shake it. The hand's own end of the spring is felt at once: F = K (1 - M) x of a
/// tool that follows, M the mean. Since |M| <= 1 that is a spring and a damper of at most K kMean /
/// 3. No allocation; the same bits everywhere; one thread.
class Coupling {
 public:
  /// A freed tool returns to its hand within this time, s, and no faster than this speed, m/s.
  static constexpr double kReturnTime = 0.005, kReturn = 1.0;
  /// s in which the coupling learns which share of a push fades while nothing moves: a touch says
  /// how clay gives way, but a turning wheel brings fresh clay. Without this the force is 5 to 10 %
  /// too low, which is 4 to 30 ms late while it rises.
  static constexpr double kLearns = 0.01;
  /// s of the mean of the tool's place: three ticks of 1 ms, so 1 ms late; at most kMost ticks.
  static constexpr double kMean = 0.003;
  static constexpr int kMost = 64;
  /// s by which a slow mean of the tool's places is late. Its difference gives the tool's speed,
  /// which leads the mean of kMean.
  static constexpr double kSlow = 0.01;

  /// Call before the tick: the hand went to `hand` (m) in `seconds` (> 0). Returns the tool's
  /// place.
  Vec3 tool(Vec3 hand, double seconds, const CouplingLimits& limits) noexcept;
  /// Call after the tick with what the tool touched. Returns the force on the hand, N. A touch that
  /// is not a number releases the tool.
  Vec3 feel(const Touch& touch, const CouplingLimits& limits) noexcept;
  /// The hand was lifted: hand and tool are one again.
  void release() noexcept { *this = Coupling(); }
  /// Vector from the hand to the tool, m.
  Vec3 stretch() const { return stretch_; }

 private:
  void balance(const CouplingLimits& limits) noexcept;
  Vec3 felt_stretch(const CouplingLimits& limits) noexcept;

  Vec3 hand_, stretch_;  ///< The hand's last place counts only while something holds its tool.
  Touch touch_;
  struct Past {
    Vec3 hand, stretch;
  };
  std::array<Past, kMost> past_;  ///< Last ticks of this touch, a ring.
  Vec3 mean_, ahead_;  ///< The tool's mean place, and its distance ahead of the slow mean.
  int next_ = 0, held_ = 0;
  double seconds_ = 0.0;
  double gives_ = 1.0;  ///< Share of the push that really fades, of what a touch reports.
  double push_ = 0.0;   ///< Estimate of |touch_.push| now.
};

}  // namespace onggi::force
