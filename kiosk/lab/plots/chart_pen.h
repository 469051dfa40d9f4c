#pragma once

#include <string>

#include "kiosk/picture/drawing/pen.h"
#include "kiosk/picture/drawing/plot_scale.h"

namespace onggi::plots {

using drawing::Lettering;

inline constexpr double kFullCircle = 6.283185307179586;  // rad

/// The place of a panel in a chart, pixels, and its scales.
struct ChartPanel {
  double left, right, top, bottom;
  drawing::PlotScale xs, ys;
  double x(double v) const { return left + xs.share(v) * (right - left); }
  double y(double v) const { return bottom - ys.share(v) * (bottom - top); }
  bool holds(double at_x, double at_y) const {
    return at_x >= left - 1 && at_x <= right + 1 && at_y >= top - 1 && at_y <= bottom + 1;
  }
};

/// From `low` to `high`, both above zero.
drawing::PlotScale decades(double low, double high);

/// Drawing tools for charts with several panels.
class ChartPen : protected drawing::Pen {
 protected:
  /// Grid, figures and names of both axes.
  void axes(const ChartPanel& panel, const std::string& across, const std::string& up);
  /// A mark with a rim of paper.
  void disc(double x, double y, double r, view::Color color, bool hollow);
};

}  // namespace onggi::plots
