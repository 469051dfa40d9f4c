#pragma once

#include <array>

namespace onggi {

/// Second-order Butterworth low-pass (bilinear transform, pre-warped), for one figure at a fixed
/// rate. Gain 1 at rest, 1/sqrt(2) at the cutoff. No allocation.
class Lowpass {
 public:
  /// `cutoff` and `rate` in Hz, 0 < cutoff < rate / 2.
  Lowpass(double cutoff, double rate);
  double filter(double in);
  /// Sets the state as if `value` had always been the input.
  void settle(double value) { x1_ = x2_ = y1_ = y2_ = value; }
  /// All state that the next filter() depends on, besides its input.
  std::array<double, 4> memory() const { return {x1_, x2_, y1_, y2_}; }

 private:
  double b0_, a1_, a2_;
  double x1_ = 0.0, x2_ = 0.0, y1_ = 0.0, y2_ = 0.0;
};

}  // namespace onggi
