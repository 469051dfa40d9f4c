#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kiosk/picture/drawing/plot.h"

namespace onggi::drawing {

/// A tick of an axis; without a label it is a minor one.
struct PlotTick {
  double at = 0;
  std::string label{};
};

/// Converts an axis' values to shares of its length, and places its ticks.
class PlotScale {
 public:
  /// `low` and `high` of the data; 0 to 1 if nothing is finite. `marks`: the most ticks that fit.
  PlotScale(const PlotAxis& axis, double low, double high, int marks);

  /// 0 at the lower end, 1 at the upper one; not finite if the logarithm has no value.
  double share(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  /// Rising; labels at 1, 2 or 5 times a power of ten, at decades, or at the axis' names.
  const std::vector<PlotTick>& ticks() const { return ticks_; }

 private:
  void mark_evenly(const PlotAxis& axis, int marks);
  void mark_decades(const PlotAxis& axis, int marks);

  bool log_ = false;
  double low_ = 0, high_ = 1;
  std::vector<PlotTick> ticks_;
};

}  // namespace onggi::drawing
