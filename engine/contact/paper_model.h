#pragma once

#include <array>
#include <vector>

#include "engine/contact/place.h"
#include "engine/contact/tool.h"
#include "engine/math/lowpass.h"

namespace onggi {

/// What the paper calls its coefficients. All are per tick and per element, as printed.
struct PaperCoefficients {
  double c_eta = 10;  ///< Pseudo viscosity: ticks; a tick takes 1 / c_eta of the press away.
  double c_v = 0;     ///< Resistance, N per metre of one element's press.
  double c_r = 0;     ///< Friction, N per metre of the deepest press.
};

/// What the printed equations make of one tick.
struct PaperTouch {
  Vec3 force;                ///< Eq. 7 on the tool, unfiltered, studio frame, N.
  Vec3 resistance;           ///< Sum of eq. 9, without eq. 10, N.
  double depth = 0;          ///< Deepest p, m.
  double depth_sum = 0;      ///< Sum of p, m; over `touched` it is the paper's mean depth.
  std::int64_t visited = 0;  ///< Elements looked at: those in the window of eqs. 1 and 2.
  std::int64_t touched = 0;  ///< Elements with p > 0.
};

/// Equations 1 to 10 of Lee, Han & Choi 2008 as printed, faults and all: the thing that the
/// corrected model is compared with (engine/docs/paper.md). Scalar, double. The paper's one radius
/// of an element is the clay's outer one, stored as a float; the inner one only yields so that the
/// clay's invariant holds.
class PaperModel {
 public:
  /// Allocates a table of 16 bytes a sector.
  explicit PaperModel(const Clay& clay);

  /// Contraction (`outside`) or expansion (`inside`): the paper does not say which. This takes a
  /// tool nearer the axis than the surface in front of it to be inside, anew each tick, unless
  /// `wish` says.
  static WallSide mode(const Clay& clay, Vec3 at, double wheel_angle, SideWish wish) noexcept;

  /// One tick of a sphere at `at` (studio frame, m) while the wheel stands at `wheel_angle` (rad)
  /// and turns by `turn` in the tick (only its sign matters). Marks dirty rows. No allocation. A
  /// position on the axis or not finite gives a force that is not finite, as printed.
  PaperTouch tick(Clay& clay, WallSide mode, Vec3 at, double radius, double wheel_angle,
                  double turn, const PaperCoefficients& c) const noexcept;

 private:
  std::vector<double> cos_, sin_;  // of each element's angle in the clay's frame
};

/// Section 5's filter: a Butterworth low-pass of second order on each part of the total force. A
/// force that is not finite stays in it until settle(). No allocation.
class PaperFilter {
 public:
  static constexpr double kCutoff = 10.0;  ///< Hz, as printed.
  static constexpr double kRate = 1000.0;  ///< Hz; the paper's rate, whatever the tick's length.

  Vec3 filter(Vec3 force) noexcept;
  void settle() noexcept;  ///< As if no force had come in for ever.
  /// All that the next filter() depends on.
  std::array<double, 12> memory() const noexcept;

 private:
  std::array<Lowpass, 3> axis_{Lowpass(kCutoff, kRate), Lowpass(kCutoff, kRate),
                               Lowpass(kCutoff, kRate)};
};

}  // namespace onggi
