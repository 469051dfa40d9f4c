#pragma once

#include <array>

#include "engine/force/tool_touch.h"

namespace onggi::force {

/// Limits of a coupling.
struct CouplingLimits {
  double stiffness = 0;  ///< N/m, > 0: of the spring between hand and tool.
  double max_force = 0;  ///< N, >= 0: the tool is never farther from the hand than this stretches.
};

/// A virtual coupling: a spring between a hand and the tool in the clay (Colgate, Stanley & Brown,
/// Issues in the Haptic Display of Tool Use, 1995). The hand feels that spring and nothing else, so
/// no clay, floor or wheel head is stiffer to it than its device bears; and as a spring in series
/// leaves a dashpot as it is, clay that gives way is as heavy as it was.
///
/// The tool has no mass: each tick it goes to where spring and clay balance. Along the push that is
/// one Newton step with the clay's stiffness (at the most, so that it comes from one side); across
/// it clay carries it along until the spring pulls harder than `grip` (return mapping: Simo &
/// Hughes, Computational Inelasticity, 1998), so that no velocity is asked for and nothing turns
/// round at rest. Clear of the clay hand and tool are one.
///
/// The hand feels the spring to where the tool was in the mean of kMean: elements come under a tool
/// whole, and shake it each time. The hand's own end of the spring is felt at once: F = K (1 - M) x
/// of a tool that follows, M the mean, and since |M| <= 1 that is a spring and a damper, of at most
/// K kMean / 3. No allocation; the same bits everywhere; one thread.
class Coupling {
 public:
  /// A tool that nothing holds any more comes back to its hand in that time, s, and no faster than
  /// that, m/s.
  static constexpr double kReturnTime = 0.005, kReturn = 1.0;
  /// s in which it learns which share of a push fades while nothing moves: a touch reports how clay
  /// gives way, but a turning wheel brings fresh clay. Without it the force is 5 to 10 % below the
  /// balance, which is 4 to 30 ms late while it rises.
  static constexpr double kLearns = 0.01;
  /// s over which the tool's place is felt in the mean: three ticks of 1 ms, so 1 ms late. Of ticks
  /// shorter than kMean / kMost, as many.
  static constexpr double kMean = 0.003;
  static constexpr int kMost = 64;
  /// s behind the tool at which a slow mean of its places goes: what that tells of its speed leads
  /// the mean of kMean, which is late.
  static constexpr double kSlow = 0.01;

  /// Before the tick: the hand went to `hand` (m) in `seconds` (> 0). Where the tool is to be.
  Vec3 tool(Vec3 hand, double seconds, const CouplingLimits& limits) noexcept;
  /// After the tick: what the tool touched there. Returns the force on the hand, N. A touch that is
  /// not a number releases the tool.
  Vec3 feel(const Touch& touch, const CouplingLimits& limits) noexcept;
  /// The hand was lifted: hand and tool are one again.
  void release() noexcept { *this = Coupling(); }
  /// From the hand to the tool, m.
  Vec3 stretch() const { return stretch_; }

 private:
  void balance(const CouplingLimits& limits) noexcept;
  Vec3 felt_stretch(const CouplingLimits& limits) noexcept;

  Vec3 hand_, stretch_;  ///< Where a hand came from is asked only once something holds its tool.
  Touch touch_;
  struct Past {
    Vec3 hand, stretch;
  };
  std::array<Past, kMost> past_;  ///< Of the last ticks of this touch, a ring.
  Vec3 mean_, ahead_;             ///< The tool's mean place, and how far before its slow mean.
  int next_ = 0, held_ = 0;
  double seconds_ = 0.0;
  double gives_ = 1.0;  ///< Of the push that a touch says fades, the share that does.
  double push_ = 0.0;   ///< |touch_.push|, as it is guessed to be now.
};

}  // namespace onggi::force
