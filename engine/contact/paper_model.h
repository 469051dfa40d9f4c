#pragma once

#include <array>
#include <vector>

#include "engine/contact/place.h"
#include "engine/contact/tool.h"
#include "engine/math/lowpass.h"

namespace onggi {

/// The paper's coefficients, per tick and per element, as printed.
struct PaperCoefficients {
  double c_eta = 10;  ///< Pseudo viscosity, ticks: a tick removes 1 / c_eta of the press.
  double c_v = 0;     ///< Resistance, N per metre of one element's press.
  double c_r = 0;     ///< Friction, N per metre of the deepest press.
};

/// The result of the printed equations for one tick.
struct PaperTouch {
  Vec3 force;                ///< Eq. 7 on the tool, unfiltered, studio frame, N.
  Vec3 resistance;           ///< Sum of eq. 9, without eq. 10, N.
  double depth = 0;          ///< Deepest p, m.
  double depth_sum = 0;      ///< Sum of p, m; divided by `touched` it is the paper's mean depth.
  std::int64_t visited = 0;  ///< Elements looked at: those in the window of eqs. 1 and 2.
  std::int64_t touched = 0;  ///< Elements with p > 0.
};

/// Equations 1 to 10 of Lee, Han & Choi 2008 as printed, errors included, for comparison with the
/// corrected model (engine/docs/paper.md). Scalar, double. The paper has one radius per element:
/// here it is the clay's outer radius, stored as a float. The inner radius yields only to keep the
/// clay's invariant.
class PaperModel {
 public:
  /// Allocates a table of 16 bytes a sector.
  explicit PaperModel(const Clay& clay);

  /// Contraction (`outside`) or expansion (`inside`). The paper does not say how to choose. Here,
  /// each tick, a tool nearer the axis than the surface in front of it is inside, unless `wish`
  /// says otherwise.
  static WallSide mode(const Clay& clay, Vec3 at, double wheel_angle, SideWish wish) noexcept;

  /// One tick of a sphere at `at` (studio frame, m) while the wheel is at `wheel_angle` (rad) and
  /// turns by `turn` (only its sign matters). Marks dirty rows. No allocation. If `at` is on the
  /// axis or not finite, the force is not finite, as in the printed equations.
  PaperTouch tick(Clay& clay, WallSide mode, Vec3 at, double radius, double wheel_angle,
                  double turn, const PaperCoefficients& c) const noexcept;

 private:
  std::vector<double> cos_, sin_;  // of each element's angle in the clay's frame
};

/// Section 5's filter: a second-order Butterworth low-pass on each component of the total force. A
/// force that is not finite stays in it until settle(). No allocation.
class PaperFilter {
 public:
  static constexpr double kCutoff = 10.0;  ///< Hz, as printed.
  /// Hz; the paper's rate, whatever the tick's length here.
  static constexpr double kRate = 1000.0;

  Vec3 filter(Vec3 force) noexcept;
  void settle() noexcept;  ///< Resets to the state after endless zero force.
  /// The whole state that filter() depends on.
  std::array<double, 12> memory() const noexcept;

 private:
  std::array<Lowpass, 3> axis_{Lowpass(kCutoff, kRate), Lowpass(kCutoff, kRate),
                               Lowpass(kCutoff, kRate)};
};

}  // namespace onggi
