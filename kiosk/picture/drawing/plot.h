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
  bool log = false;             ///< By decades: only what is above zero is drawn.
  std::optional<double> low{};  ///< Instead of the data's; taken as they are.
  std::optional<double> high{};
  std::vector<std::string> names{};  ///< Of the places 0, 1, 2... in place of figures.
};

/// What belongs together: one colour and one entry of the legend.
struct PlotSeries {
  enum class Kind { line, points, line_and_points, bars };
  std::string name{};  ///< Empty: not in the legend.
  Kind kind = Kind::line;
  std::vector<double> x{};  ///< Empty: 0, 1, 2... A gap where x or y is not finite.
  std::vector<double> y{};
  std::vector<double> error{};  ///< y - error to y + error, a bar with caps; empty: none.
  bool dashed = false;
  std::optional<view::Color> color{};  ///< Else the next of seven that the colour-blind tell apart.
};

/// Words at a place of the plot, with a dot where they point to.
struct PlotNote {
  double x = 0, y = 0;
  std::string text{};
};

/// A picture of figures, as plain values. Bars of several series stand side by side, from zero, or
/// from the axis' lower end where that is above zero.
struct Plot {
  std::string title{};
  std::string subtitle{};  ///< What was measured, where and how: a line or two.
  PlotAxis x{}, y{};
  std::vector<PlotSeries> series{};
  std::vector<PlotNote> notes{};
  int width = 1600, height = 960;  ///< Pixels.
};

/// The picture's bytes: an SVG where the name of `file` ends in ".svg", else a PNG. Writes nothing.
/// Every series has as many x (and errors) as y, or none. Allocates; any thread.
std::vector<std::byte> draw_plot(const Plot& plot, const std::string& file);

}  // namespace onggi::drawing
