#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::drawing {

/// One axis of a plot. It spans the data, rounded outwards to whole ticks.
struct PlotAxis {
  std::string label{};          ///< With its unit: "force, N".
  bool log = false;             ///< In decades: only values above zero are drawn.
  std::optional<double> low{};  ///< Instead of the data's range; used exactly.
  std::optional<double> high{};
  std::vector<std::string> names{};  ///< Names of the places 0, 1, 2... instead of figures.
};

/// A series: one colour and one entry of the legend.
struct PlotSeries {
  enum class Kind { line, points, line_and_points, bars };
  std::string name{};  ///< Empty: not in the legend.
  Kind kind = Kind::line;
  std::vector<double> x{};  ///< Empty: 0, 1, 2... A gap where x or y is not finite.
  std::vector<double> y{};
  std::vector<double> error{};  ///< y - error to y + error, a bar with caps; empty: none.
  bool dashed = false;
  /// Absent: the next of seven colours that colour-blind readers can distinguish.
  std::optional<view::Color> color{};
};

/// Words at a place of the plot, with a dot at that place.
struct PlotNote {
  double x = 0, y = 0;
  std::string text{};
};

/// A plot as plain values. Bars of several series are side by side, from zero, or from the axis'
/// lower end if that is above zero.
struct Plot {
  std::string title{};
  std::string subtitle{};  ///< What was measured, where and how: one or two lines.
  PlotAxis x{}, y{};
  std::vector<PlotSeries> series{};
  std::vector<PlotNote> notes{};
  int width = 1600, height = 960;  ///< Pixels.
};

/// The picture's bytes: an SVG if the name of `file` ends in ".svg", else a PNG. Writes no file.
/// Every series needs as many x (and errors) as y, or none. Allocates; any thread.
std::vector<std::byte> draw_plot(const Plot& plot, const std::string& file);

}  // namespace onggi::drawing
