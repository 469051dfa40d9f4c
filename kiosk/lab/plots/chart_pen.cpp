#include "kiosk/lab/plots/chart_pen.h"

#include "kiosk/picture/view/palette.h"

namespace onggi::plots {
namespace {

constexpr double kAxisName = 24, kAxisFigure = 20;

}  // namespace

drawing::PlotScale decades(double low, double high) {
  drawing::PlotAxis axis;
  axis.log = true;
  axis.low = low;
  axis.high = high;
  return drawing::PlotScale(axis, low, high, 12);
}

void ChartPen::axes(const ChartPanel& p, const std::string& across, const std::string& up) {
  for (const drawing::PlotTick& tick : p.ys.ticks()) {
    const double at = p.y(tick.at);
    if (at < p.top - 1 || at > p.bottom + 1) continue;
    ink(view::kFaintInk, tick.label.empty() ? 0.07 : 0.2);
    line(p.left, at, p.right, at, 1.2);
    words(tick.label, p.left - 14, at - 0.68 * kAxisFigure,
          {.px = kAxisFigure, .side = -1, .color = view::kInk});
  }
  for (const drawing::PlotTick& tick : p.xs.ticks()) {
    const double at = p.x(tick.at);
    if (at < p.left - 1 || at > p.right + 1) continue;
    ink(view::kFaintInk, tick.label.empty() ? 0.07 : 0.2);
    line(at, p.top, at, p.bottom, 1.2);
    words(tick.label, at, p.bottom + 10, {.px = kAxisFigure, .side = 0, .color = view::kInk});
  }
  ink(view::kInk);
  line(p.left, p.bottom, p.right, p.bottom, 2);
  line(p.left, p.top, p.left, p.bottom, 2);
  words(across, 0.5 * (p.left + p.right), p.bottom + 44,
        {.px = kAxisName, .side = 0, .color = view::kInk});
  words(up, p.left - 102, 0.5 * (p.top + p.bottom),
        {.px = kAxisName, .side = 0, .color = view::kInk, .turn = -0.25 * kFullCircle});
}

void ChartPen::disc(double x, double y, double r, view::Color color, bool hollow) {
  cairo_new_path(c_);
  cairo_arc(c_, x, y, r + 2.5, 0, kFullCircle);
  ink(drawing::kPaper);
  cairo_fill(c_);
  cairo_arc(c_, x, y, hollow ? r - 1.5 : r, 0, kFullCircle);
  ink(color);
  cairo_set_line_width(c_, 3.5);
  hollow ? cairo_stroke(c_) : cairo_fill(c_);
}

}  // namespace onggi::plots
