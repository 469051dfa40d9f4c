#include "kiosk/picture/drawing/plot.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "kiosk/ground/files/output_kind.h"
#include "kiosk/picture/drawing/pen.h"
#include "kiosk/picture/drawing/plot_scale.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::drawing {
namespace {

constexpr double kPlotMargin = 56, kPlotTitle = 40, kPlotText = 24, kFigure = 22;
constexpr double kSwatch = 44, kTurn = 0.6;  // rad: angle of names that do not fit side by side

/// Okabe and Ito's colours, without the yellow, which is invisible on paper.
constexpr std::array<unsigned, 7> kColors{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                          0x56B4E9, 0xE69F00, 0x3F3A36};

using Kind = PlotSeries::Kind;

bool has_line(Kind kind) { return kind == Kind::line || kind == Kind::line_and_points; }
bool has_points(Kind kind) { return kind == Kind::points || kind == Kind::line_and_points; }

double x_of(const PlotSeries& series, std::size_t i) {
  return series.x.empty() ? static_cast<double>(i) : series.x[i];
}

class PlotSheet : private Pen {
 public:
  PlotSheet(const Plot& plot, bool vector) : p_(plot) { begin(plot.width, plot.height, vector); }
  std::vector<std::byte> draw();

 private:
  PlotScale scale_of(const PlotAxis& axis, bool upright, double pixels) const;
  void place();
  double draw_head();
  double draw_legend(double top);
  void draw_mark(std::size_t index, double x, double y, double radius);
  void draw_sign(std::size_t index, double x, double y);
  void draw_grid();
  void draw_bars();
  void draw_series(std::size_t index);
  void draw_errors(const PlotSeries& series, double aside);
  void draw_notes();
  double x(double value) const { return left_ + xs_->share(value) * (right_ - left_); }
  double y(double value) const { return bottom_ - ys_->share(value) * (bottom_ - top_); }
  view::Color color_of(std::size_t index) const {
    return p_.series[index].color.value_or(view::rgb(kColors[index % kColors.size()]));
  }
  /// Position of bar series `index` within its place, and its width: shares of the place.
  std::pair<double, double> bar_of(std::size_t index) const;
  void stroke(std::size_t index, double width);

  const Plot& p_;
  std::optional<PlotScale> xs_, ys_;
  double left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
  bool turned_ = false;  // the names below
};

PlotScale PlotSheet::scale_of(const PlotAxis& axis, bool upright, double pixels) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PlotSeries& s : p_.series) {
    assert((s.x.empty() || s.x.size() == s.y.size()) &&
           (s.error.empty() || s.error.size() == s.y.size()));
    for (std::size_t i = 0; i < s.y.size(); ++i) {
      const double error = upright && !s.error.empty() ? s.error[i] : 0.0;
      const double middle = upright ? s.y[i] : x_of(s, i);
      for (const double v : {middle - error, middle + error}) {
        if (!std::isfinite(v) || (axis.log && v <= 0.0)) continue;
        low = std::min(low, v);
        high = std::max(high, v);
      }
    }
    if (upright && s.kind == Kind::bars && !axis.log) {
      low = std::min(low, 0.0);
      high = std::max(high, 0.0);
    }
  }
  return PlotScale(axis, low, high, static_cast<int>(pixels / (upright ? 72 : 130)));
}

/// Left and bottom margins fit the longest figures and names.
void PlotSheet::place() {
  const auto widest = [this](const PlotScale& scale) {
    double most = 0;
    for (const PlotTick& tick : scale.ticks())
      most = std::max(most, width_of(tick.label, {.px = kFigure}));
    return most;
  };
  const double wide = p_.width - 3 * kPlotMargin;
  xs_ = scale_of(p_.x, false, wide);
  ys_ = scale_of(p_.y, true, bottom_ - top_);
  left_ = kPlotMargin + (p_.y.label.empty() ? 0 : 46) + widest(*ys_) + 18;
  right_ = p_.width - kPlotMargin;
  const double name = widest(*xs_);
  const double room =
      (right_ - left_) / std::max<double>(1.0, static_cast<double>(p_.x.names.size()));
  turned_ = !p_.x.names.empty() && name + 14 > room;
  bottom_ = p_.height - kPlotMargin - (p_.x.label.empty() ? 0 : 44) -
            (turned_ ? name * std::sin(kTurn) + 34 : 38);
  // The last turned name extends to the right of its place.
  if (turned_)
    right_ = std::min(
        right_, p_.width - 0.5 * kPlotMargin -
                    (width_of(p_.x.names.back(), {.px = kFigure}) * std::cos(kTurn) - 0.5 * room));
  ys_ = scale_of(p_.y, true, bottom_ - top_);
}

double PlotSheet::draw_head() {
  double at = 0.7 * kPlotMargin;
  const double inside = p_.width - 2 * kPlotMargin;
  if (!p_.title.empty())
    at += 4 + words(p_.title, kPlotMargin, at,
                    {.px = kPlotTitle, .color = view::kInk, .width = inside, .serif = true});
  if (!p_.subtitle.empty())
    at += words(p_.subtitle, kPlotMargin, at,
                {.px = kPlotText, .color = view::kFaintInk, .width = inside});
  return at;
}

/// The legend above the plot, where it hides nothing.
double PlotSheet::draw_legend(double top) {
  double at = kPlotMargin, row = top + 18;
  bool any = false;
  for (std::size_t i = 0; i < p_.series.size(); ++i) {
    const std::string& name = p_.series[i].name;
    if (name.empty()) continue;
    const double wide = kSwatch + 14 + width_of(name, {.px = kPlotText});
    if (any && at + wide > p_.width - kPlotMargin) {
      at = kPlotMargin;
      row += 40;
    }
    any = true;
    draw_sign(i, at, row + 17);
    words(name, at + kSwatch + 14, row, {.px = kPlotText, .color = view::kInk});
    at += wide + 48;
  }
  return any ? row + 40 : top;
}

void PlotSheet::stroke(std::size_t index, double width) {
  const double dash[] = {4 * width, 3 * width};
  ink(color_of(index));
  cairo_set_line_width(c_, width);
  if (p_.series[index].dashed) cairo_set_dash(c_, dash, 2, 0);
  cairo_stroke(c_);
  cairo_set_dash(c_, nullptr, 0, 0);
}

/// A shape as well as a colour for each series, with a rim of paper.
void PlotSheet::draw_mark(std::size_t index, double x, double y, double radius) {
  for (const bool rim : {true, false}) {
    const double r = radius + (rim ? 2.5 : 0.0);
    cairo_new_path(c_);
    switch (index % 4) {
      case 0:
        cairo_arc(c_, x, y, r, 0, 6.2831853);
        break;
      case 1:
        cairo_rectangle(c_, x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
        break;
      default:
        for (const auto& [across, down] :
             index % 4 == 2
                 ? std::vector<std::pair<double, double>>{{0, -1.2}, {1.1, 0.8}, {-1.1, 0.8}}
                 : std::vector<std::pair<double, double>>{{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}})
          cairo_line_to(c_, x + across * r, y + down * r);
    }
    rim ? ink(kPaper) : ink(color_of(index));
    cairo_fill(c_);
  }
}

void PlotSheet::draw_sign(std::size_t index, double x, double y) {
  const Kind kind = p_.series[index].kind;
  if (kind == Kind::bars) {
    ink(color_of(index));
    cairo_rectangle(c_, x, y - 11, kSwatch, 22);
    cairo_fill(c_);
  }
  if (has_line(kind)) {
    cairo_move_to(c_, x, y);
    cairo_line_to(c_, x + kSwatch, y);
    stroke(index, 4);
  }
  if (has_points(kind)) draw_mark(index, x + 0.5 * kSwatch, y, 8);
}

void PlotSheet::draw_grid() {
  for (const PlotTick& tick : ys_->ticks()) {
    const double at = y(tick.at);
    ink(view::kFaintInk, tick.label.empty() ? 0.10 : 0.25);
    line(left_, at, right_, at, 1.5);
    words(tick.label, left_ - 16, at - 0.68 * kFigure,
          {.px = kFigure, .side = -1, .color = view::kInk});
  }
  for (const PlotTick& tick : xs_->ticks()) {
    const double at = x(tick.at);
    if (p_.x.names.empty()) {
      ink(view::kFaintInk, tick.label.empty() ? 0.10 : 0.25);
      line(at, top_, at, bottom_, 1.5);
    }
    if (turned_)
      words(tick.label, at - 4, bottom_ + 12, {.px = kFigure, .color = view::kInk, .turn = kTurn});
    else
      words(tick.label, at, bottom_ + 10, {.px = kFigure, .side = 0, .color = view::kInk});
  }
  words(p_.x.label, 0.5 * (left_ + right_), p_.height - kPlotMargin - 22,
        {.px = kPlotText, .side = 0, .color = view::kInk});
  words(p_.y.label, 0.6 * kPlotMargin, 0.5 * (top_ + bottom_),
        {.px = kPlotText, .side = 0, .color = view::kInk, .turn = -1.5707963});
}

std::pair<double, double> PlotSheet::bar_of(std::size_t index) const {
  double count = 0, before = 0;
  for (std::size_t i = 0; i < p_.series.size(); ++i) {
    if (p_.series[i].kind != Kind::bars) continue;
    if (i < index) ++before;
    ++count;
  }
  const double width = 0.78 / count;
  return {width * (before - 0.5 * (count - 1)), width};
}

void PlotSheet::draw_bars() {
  const double place = x(1) - x(0);
  for (std::size_t i = 0; i < p_.series.size(); ++i) {
    const PlotSeries& s = p_.series[i];
    if (s.kind != Kind::bars) continue;
    const auto [aside, width] = bar_of(i);
    const double foot = p_.y.log || ys_->low() > 0.0 ? bottom_ : y(std::min(0.0, ys_->high()));
    ink(color_of(i));
    for (std::size_t n = 0; n < s.y.size(); ++n) {
      const double middle = x(x_of(s, n)) + aside * place, head = y(s.y[n]);
      if (!std::isfinite(middle) || !std::isfinite(head)) continue;
      cairo_rectangle(c_, middle - 0.5 * width * place + 1, std::min(head, foot), width * place - 2,
                      std::abs(head - foot));
    }
    cairo_fill(c_);
    draw_errors(s, aside * place);
  }
}

void PlotSheet::draw_errors(const PlotSeries& series, double aside) {
  ink(view::kInk);
  for (std::size_t n = 0; n < series.error.size(); ++n) {
    const double at = x(x_of(series, n)) + aside;
    const double high = y(series.y[n] + series.error[n]);
    double low = y(series.y[n] - series.error[n]);
    if (!std::isfinite(low)) low = bottom_;  // below the range of a logarithm
    if (!std::isfinite(at) || !std::isfinite(high) || series.error[n] <= 0.0) continue;
    line(at, low, at, high, 2);
    for (const double end : {low, high}) line(at - 7, end, at + 7, end, 2);
  }
}

void PlotSheet::draw_series(std::size_t index) {
  const PlotSeries& s = p_.series[index];
  if (has_line(s.kind)) {
    bool pen_down = false;
    for (std::size_t n = 0; n < s.y.size(); ++n) {
      const double to_x = x(x_of(s, n)), to_y = y(s.y[n]);
      const bool there = std::isfinite(to_x) && std::isfinite(to_y);
      if (there) pen_down ? cairo_line_to(c_, to_x, to_y) : cairo_move_to(c_, to_x, to_y);
      pen_down = there;
    }
    stroke(index, 4);
  }
  draw_errors(s, 0);
  for (std::size_t n = 0; has_points(s.kind) && n < s.y.size(); ++n) {
    const double at_x = x(x_of(s, n)), at_y = y(s.y[n]);
    if (std::isfinite(at_x) && std::isfinite(at_y)) draw_mark(index, at_x, at_y, 7);
  }
}

void PlotSheet::draw_notes() {
  for (const PlotNote& note : p_.notes) {
    const double at_x = x(note.x), at_y = y(note.y);
    if (!std::isfinite(at_x) || !std::isfinite(at_y)) continue;
    ink(view::kInk);
    cairo_arc(c_, at_x, at_y, 5, 0, 6.2831853);
    cairo_fill(c_);
    Lettering how{.px = kFigure, .color = view::kInk, .halo = 4};
    const double wide = width_of(note.text, how);
    // To the left if there is no space on the right, and below at the upper edge.
    how.side = at_x + 14 + wide > right_ ? -1 : 1;
    const double down = at_y - 40 < top_ ? at_y + 8 : at_y - 38;
    words(note.text, at_x + how.side * 10, down, how);
  }
}

std::vector<std::byte> PlotSheet::draw() {
  top_ = draw_legend(draw_head()) + 22;
  bottom_ = p_.height - 3 * kPlotMargin;
  place();
  draw_grid();
  cairo_save(c_);
  cairo_rectangle(c_, left_ - 9, top_ - 9, right_ - left_ + 18, bottom_ - top_ + 9);
  cairo_clip(c_);
  draw_bars();
  for (std::size_t i = 0; i < p_.series.size(); ++i)
    if (p_.series[i].kind != Kind::bars) draw_series(i);
  cairo_restore(c_);
  ink(view::kInk);
  const bool through_zero = !p_.y.log && ys_->low() < 0.0 && ys_->high() > 0.0;
  line(left_, through_zero ? y(0) : bottom_, right_, through_zero ? y(0) : bottom_, 2.5);
  draw_notes();
  return bytes();
}

}  // namespace

std::vector<std::byte> draw_plot(const Plot& plot, const std::string& file) {
  return PlotSheet(plot, files::is_svg(file)).draw();
}

}  // namespace onggi::drawing
