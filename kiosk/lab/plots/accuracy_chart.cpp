#include "kiosk/lab/plots/accuracy_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kiosk/ground/files/output_kind.h"
#include "kiosk/lab/plots/chart_pen.h"
#include "kiosk/lab/plots/error_pot.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::plots {
namespace {

constexpr int kWide = 2000, kHigh = 1710;
constexpr double kEdgeOfPaper = 70, kLetter = 24, kSmallLetter = 20;
constexpr view::Color kWarning = view::rgb(0xB3261E);
constexpr view::Color kNoTime = view::rgb(0x8A3B22);

class AccuracySheet : private ChartPen {
 public:
  AccuracySheet(const AccuracyChart& chart, bool vector) : chart_(chart) {
    begin(kWide, kHigh, vector);
  }
  std::vector<std::byte> draw();

 private:
  void head();
  ChartPanel main_panel() const;
  ChartPanel force_panel(const ChartPanel& main) const;
  void no_time(const ChartPanel& p);
  void unsure(const ChartPanel& p);
  void thresholds(const ChartPanel& p);
  void cloud(const ChartPanel& p);
  void edge(const ChartPanel& p);
  void line_of(const ChartPanel& p, const AccuracyChart::Line& of);
  void name_mark(const ChartPanel& p, const AccuracyChart::Mark& mark, view::Color color,
                 bool above);
  bool free(const std::array<double, 4>& box) const;
  void keep_free(double x, double y, double right, double down);
  void pots_beside_marks(const ChartPanel& p);
  void legend();
  void star(double x, double y, double size);
  void forces(const ChartPanel& p);
  void pots(double top);
  void tone_scale(double x, double y, double width);

  const AccuracyChart& chart_;
  std::vector<std::array<double, 4>> taken_;  // areas of placed words: left, top, right, bottom
};

void AccuracySheet::head() {
  double at = 46;
  at += words(chart_.title, kEdgeOfPaper, at, {.px = 46, .color = view::kInk, .serif = true}) + 4;
  words(chart_.subtitle, kEdgeOfPaper, at,
        {.px = kLetter, .color = view::kFaintInk, .width = kWide - 2 * kEdgeOfPaper});
}

ChartPanel AccuracySheet::main_panel() const {
  double least_us = 1e300, most_us = chart_.limit, least = 1e300, most = 0.0;
  const auto see = [&](const AccuracyChart::Mark& m) {
    least_us = std::min(least_us, m.us);
    most_us = std::max(most_us, m.us);
    least = std::min(least, m.mm);
    most = std::max(most, m.mm);
  };
  for (const auto& line : chart_.lines) std::ranges::for_each(line.marks, see);
  std::ranges::for_each(chart_.cloud, see);
  for (const auto& t : chart_.thresholds) most = std::max(most, t.mm);
  return {kEdgeOfPaper + 96,
          1290,
          250,
          1030,
          decades((chart_.pots.empty() ? 0.75 : 0.3) * least_us, 1.9 * most_us),
          decades(0.5 * least, 1.6 * most)};
}

ChartPanel AccuracySheet::force_panel(const ChartPanel& main) const {
  double few = 1e300, many = 0.0, least = 0.5, most = 2.0;
  for (const auto& force : chart_.forces)
    for (std::size_t n = 0; n < force.force.size(); ++n) {
      few = std::min(few, force.elements[n]);
      many = std::max(many, force.elements[n]);
      least = std::min(least, force.force[n]);
      most = std::max(most, force.force[n]);
    }
  return {main.right + 190, kWide - kEdgeOfPaper,           main.top + 56,
          main.bottom,      decades(0.6 * few, 1.7 * many), decades(0.6 * least, 1.8 * most)};
}

void AccuracySheet::no_time(const ChartPanel& p) {
  const double at = p.x(chart_.limit);
  ink(kNoTime, 0.10);
  cairo_rectangle(c_, at, p.top, p.right - at, p.bottom - p.top);
  cairo_fill(c_);
  ink(kNoTime);
  line(at, p.top, at, p.bottom, 2.5);
  const Lettering how{.px = kSmallLetter, .side = 0, .color = kNoTime, .turn = -0.25 * kFullCircle};
  const std::string text = "no time left: a tick is 1 ms";
  const double middle = 0.5 * (p.top + p.bottom), half = 0.5 * width_of(text, how);
  words(text, at + 8, middle, how);
  taken_.push_back({at - 2, middle - half, at + 36, middle + half});
}

/// Figures below the accuracy of the reference mean nothing.
void AccuracySheet::unsure(const ChartPanel& p) {
  const double at = std::clamp(p.y(chart_.unsure), p.top, p.bottom);
  if (!(chart_.unsure > 0.0) || p.bottom - at < 4) return;
  ink(view::kFaintInk, 0.10);
  cairo_rectangle(c_, p.left, at, p.right - p.left, p.bottom - at);
  cairo_fill(c_);
  if (p.bottom - at < 32) return;
  words("less than the reference is sure of", p.x(chart_.limit) - 14, p.bottom - 32,
        {.px = kSmallLetter, .side = -1, .color = view::kFaintInk});
}

/// Each name is under its line, at the right.
void AccuracySheet::thresholds(const ChartPanel& p) {
  for (const auto& t : chart_.thresholds) {
    const double at = p.y(t.mm);
    ink(view::kInk, 0.55);
    const double dash[] = {3, 8};
    cairo_set_dash(c_, dash, 2, 0);
    line(p.left, at, p.x(chart_.limit), at, 2.5);
    cairo_set_dash(c_, nullptr, 0, 0);
    const Lettering how{.px = kSmallLetter, .side = -1, .color = view::kFaintInk, .halo = 4};
    const double end = p.x(chart_.limit) - 14;
    words(t.name, end, at + 3, how);
    taken_.push_back({end - width_of(t.name, how), at + 3, end, at + 30});
  }
}

void AccuracySheet::cloud(const ChartPanel& p) {
  for (const auto& mark : chart_.cloud) {
    ink(view::kFaintInk, 0.28);
    cairo_new_path(c_);
    cairo_arc(c_, p.x(mark.us), p.y(mark.mm), 4, 0, kFullCircle);
    cairo_fill(c_);
  }
}

/// No mark is to the left of it and below: a step line, because nothing is between two settings.
void AccuracySheet::edge(const ChartPanel& p) {
  if (chart_.edge.empty()) return;
  cairo_move_to(c_, p.x(chart_.edge.front().us), p.top);
  for (std::size_t n = 0; n < chart_.edge.size(); ++n) {
    cairo_line_to(c_, p.x(chart_.edge[n].us), p.y(chart_.edge[n].mm));
    const double next = n + 1 < chart_.edge.size() ? p.x(chart_.edge[n + 1].us) : p.right;
    cairo_line_to(c_, next, p.y(chart_.edge[n].mm));
  }
  ink(view::kDryClay, 0.75);
  cairo_set_line_width(c_, 9);
  cairo_stroke(c_);
}

void AccuracySheet::line_of(const ChartPanel& p, const AccuracyChart::Line& of) {
  const double dash[] = {12, 10};
  bool begun = false;
  for (const auto& mark : of.marks) {
    begun ? cairo_line_to(c_, p.x(mark.us), p.y(mark.mm))
          : cairo_move_to(c_, p.x(mark.us), p.y(mark.mm));
    begun = true;
  }
  ink(of.color);
  cairo_set_line_width(c_, of.dashed ? 2.5 : 3.5);
  if (of.dashed) cairo_set_dash(c_, dash, 2, 0);
  cairo_stroke(c_);
  cairo_set_dash(c_, nullptr, 0, 0);
  for (std::size_t n = 1; n < of.marks.size(); ++n) {
    const double x = p.x(of.marks[n - 1].us), y = p.y(of.marks[n - 1].mm);
    keep_free(x, y, p.x(of.marks[n].us) - x, p.y(of.marks[n].mm) - y);
  }
  for (const auto& mark : of.marks) {
    const double x = p.x(mark.us), y = p.y(mark.mm);
    disc(x, y, of.dashed ? 6 : 9, of.color, of.hollow);
    taken_.push_back({x - 12, y - 12, x + 12, y + 12});
    if (!mark.broke) continue;
    cairo_new_path(c_);
    cairo_arc(c_, x, y, 17, 0, kFullCircle);
    ink(kWarning);
    cairo_set_line_width(c_, 3);
    cairo_stroke(c_);
  }
}

/// Words and pots stay off the line from (x, y) that goes by (right, down).
void AccuracySheet::keep_free(double x, double y, double right, double down) {
  constexpr double kStep = 10, kHalf = 5;
  const double steps = std::ceil(std::hypot(right, down) / kStep);
  for (double n = 1; n < steps; ++n) {
    const double at_x = x + right * n / steps, at_y = y + down * n / steps;
    taken_.push_back({at_x - kHalf, at_y - kHalf, at_x + kHalf, at_y + kHalf});
  }
}

bool AccuracySheet::free(const std::array<double, 4>& box) const {
  return std::ranges::none_of(taken_, [&](const auto& other) {
    return box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3];
  });
}

/// Small, each tied to its mark, on the side without a line.
void AccuracySheet::pots_beside_marks(const ChartPanel& p) {
  constexpr int kPotSide = 82;
  for (const AccuracyChart::Pot& pot : chart_.pots) {
    if (!pot.at) continue;
    const view::Image image =
        paint_pot({pot.columns, pot.rows, pot.height, pot.radius, pot.off}, kPotSide);
    const double x = p.x(pot.at->us), y = p.y(pot.at->mm), w = image.width, h = image.height;
    const double beside = x - 42 - w, under = x - 0.5 * w;
    const std::array<std::array<double, 2>, 6> places{{{beside, y - 0.5 * h},
                                                       {beside, y + 8},
                                                       {under, y + 30},
                                                       {under, y + 64},
                                                       {under, y - 26 - h},
                                                       {beside, y - 8 - h}}};
    for (const auto& [left, top] : places) {
      const std::array<double, 4> box{left - 3, top - 3, left + w + 3, top + h + 3};
      if (box[0] < p.left || box[2] > p.right || box[1] < p.top || box[3] > p.bottom || !free(box))
        continue;
      ink(view::kFaintInk, 0.6);
      line(std::clamp(x, left, left + w), std::clamp(y, top, top + h), x, y, 1.5);
      picture(image, std::round(left), std::round(top));
      taken_.push_back(box);
      break;
    }
  }
}

/// Beside its mark, at the first free place.
void AccuracySheet::name_mark(const ChartPanel& p, const AccuracyChart::Mark& mark,
                              view::Color color, bool above) {
  if (mark.name.empty()) return;
  Lettering how{.px = kSmallLetter, .color = color, .halo = 4};
  const double wide = width_of(mark.name, how), high = 27;
  const double x = p.x(mark.us), y = p.y(mark.mm);
  using Ways = std::array<std::pair<int, int>, 7>;
  constexpr Ways kAbove{{{0, -1}, {1, -1}, {-1, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, 1}}};
  constexpr Ways kBelow{{{1, -1}, {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {1, 1}, {0, -1}}};
  for (const auto& [across, down] : above ? kAbove : kBelow) {
    const double left = across > 0 ? x + 18 : across < 0 ? x - 14 - wide : x - 0.5 * wide;
    const double top = down == 0 ? y - 0.5 * high : down < 0 ? y - 22 - high : y + 12;
    const std::array<double, 4> box{left, top, left + wide, top + high};
    const bool inside = box[0] > p.left && box[2] < p.right && box[1] > p.top && box[3] < p.bottom;
    if (!inside || !free(box)) continue;
    words(mark.name, left, top, how);
    taken_.push_back(box);
    return;
  }
}

void AccuracySheet::legend() {
  double x = kEdgeOfPaper, y = 176;
  const auto entry = [&](const std::string& name, auto&& sign) {
    const double wide = 62 + width_of(name, {.px = kSmallLetter});
    if (x + wide > kWide - kEdgeOfPaper) {
      x = kEdgeOfPaper;
      y += 34;
    }
    sign(x, y + 14);
    words(name, x + 54, y, {.px = kSmallLetter, .color = view::kInk});
    x += wide + 30;
  };
  for (const auto& of : chart_.lines)
    entry(of.name, [&](double at, double middle) {
      const double dash[] = {9, 7};
      ink(of.color);
      if (of.dashed) cairo_set_dash(c_, dash, 2, 0);
      line(at, middle, at + 44, middle, of.dashed ? 2.5 : 3.5);
      cairo_set_dash(c_, nullptr, 0, 0);
      disc(at + 22, middle, of.dashed ? 6 : 9, of.color, of.hollow);
    });
  if (chart_.chosen)
    entry("recommended", [&](double at, double middle) { star(at + 22, middle, 17); });
  entry("nothing beats these", [&](double at, double middle) {
    ink(view::kDryClay, 0.75);
    line(at, middle, at + 44, middle, 9);
  });
  entry("broken by random hands", [&](double at, double middle) {
    cairo_new_path(c_);
    cairo_arc(c_, at + 22, middle, 15, 0, kFullCircle);
    ink(kWarning);
    cairo_set_line_width(c_, 3);
    cairo_stroke(c_);
  });
  entry("other settings", [&](double at, double middle) {
    cairo_new_path(c_);
    cairo_arc(c_, at + 22, middle, 4, 0, kFullCircle);
    ink(view::kFaintInk, 0.5);
    cairo_fill(c_);
  });
}

void AccuracySheet::star(double x, double y, double size) {
  ink(view::kCobalt);
  cairo_new_path(c_);
  for (int k = 0; k < 10; ++k) {
    const double r = k % 2 == 0 ? size : 0.44 * size, a = kFullCircle * (k / 10.0 - 0.25);
    cairo_line_to(c_, x + r * std::cos(a), y + r * std::sin(a));
  }
  cairo_close_path(c_);
  cairo_fill_preserve(c_);
  ink(drawing::kPaper);
  cairo_set_line_width(c_, 2);
  cairo_stroke(c_);
}

/// The felt force as a multiple of the true one: 1 on every grid if it converges.
void AccuracySheet::forces(const ChartPanel& p) {
  if (chart_.forces.empty()) return;
  words("The force that is felt, as a multiple of the true one", p.left - 110, p.top - 46,
        {.px = kLetter, .color = view::kInk, .width = p.right - p.left + 110});
  const double low = p.y(1.0 - chart_.force_told), high = p.y(1.0 + chart_.force_told);
  ink(view::kDeepCeladon, 0.25);
  cairo_rectangle(c_, p.left, high, p.right - p.left, low - high);
  cairo_fill(c_);
  for (const auto& force : chart_.forces) {
    for (std::size_t n = 0; n < force.force.size(); ++n) {
      const double x = p.x(force.elements[n]), y = p.y(force.force[n]);
      n == 0 ? cairo_move_to(c_, x, y) : cairo_line_to(c_, x, y);
    }
    ink(force.color);
    cairo_set_line_width(c_, 3.5);
    cairo_stroke(c_);
    for (std::size_t n = 0; n < force.force.size(); ++n)
      disc(p.x(force.elements[n]), p.y(force.force[n]), 8, force.color, force.hollow);
  }
  const std::string told =
      "within " + std::to_string(std::lround(100.0 * chart_.force_told)) + " %";
  for (const auto& [row, text] :
       {std::pair{0, told}, std::pair{1, std::string("no hand can tell")}})
    words(text, p.right - 4, low + 4 + 26 * row,
          {.px = kSmallLetter, .side = -1, .color = view::kDeepCeladon, .halo = 4});
}

void AccuracySheet::tone_scale(double x, double y, double width) {
  for (int k = 0; k < 120; ++k) {
    const double off = error_from_share(k / 119.0);
    ink(tone_of_error(off));
    cairo_rectangle(c_, x + width * k / 120.0, y, width / 120.0 + 1, 18);
    cairo_fill(c_);
  }
  for (const auto& [mm, name] : {std::pair{0.001, "0.001"}, std::pair{0.01, "0.01"},
                                 std::pair{0.1, "0.1"}, std::pair{1.0, "1 mm off"}}) {
    const double at = x + width * share_of_error(1e-3 * mm);
    ink(view::kInk);
    line(at, y + 18, at, y + 24, 1.5);
    words(name, at, y + 26, {.px = kSmallLetter, .side = 0, .color = view::kInk});
  }
}

/// A row of vases, coarse to fine, each coloured by its error.
void AccuracySheet::pots(double top) {
  if (chart_.pots.empty()) return;
  ink(view::kFaintInk, 0.35);
  line(kEdgeOfPaper, top, kWide - kEdgeOfPaper, top, 1.5);
  words("The same vase, thrown on each grid, coloured by how far each place is off the true one",
        kEdgeOfPaper, top + 14, {.px = kLetter, .color = view::kInk});
  tone_scale(kWide - kEdgeOfPaper - 470, top + 20, 400);
  const double place = (kWide - 2 * kEdgeOfPaper) / static_cast<double>(chart_.pots.size());
  const int high = 250;
  double x = kEdgeOfPaper;
  for (const AccuracyChart::Pot& pot : chart_.pots) {
    const view::Image image =
        paint_pot({pot.columns, pot.rows, pot.height, pot.radius, pot.off}, high);
    picture(image, std::round(x + 0.5 * (place - image.width)), std::round(top + 80));
    const double under = top + 80 + high + 8;
    words(pot.name, x + 0.5 * place, under,
          {.px = kSmallLetter, .side = 0, .color = pot.chosen ? view::kCobalt : view::kInk});
    words(pot.below, x + 0.5 * place, under + 27,
          {.px = kSmallLetter, .side = 0, .color = view::kFaintInk});
    if (pot.chosen) {
      ink(view::kCobalt);
      line(x + 0.5 * place - 60, under + 58, x + 0.5 * place + 60, under + 58, 4);
    }
    x += place;
  }
}

std::vector<std::byte> AccuracySheet::draw() {
  head();
  const ChartPanel p = main_panel();
  axes(p, "time of a tick, µs: 999 of 1000 take no longer", "shape off the true one, mm (rms)");
  unsure(p);
  no_time(p);
  thresholds(p);
  edge(p);
  cloud(p);
  for (auto of = chart_.lines.rbegin(); of != chart_.lines.rend(); ++of) line_of(p, *of);
  if (chart_.chosen) star(p.x(chart_.chosen->us), p.y(chart_.chosen->mm), 25);
  for (const auto& of : chart_.lines)
    for (const auto& mark : of.marks) name_mark(p, mark, of.color, of.above);
  pots_beside_marks(p);
  legend();
  const ChartPanel force = force_panel(p);
  axes(force, "millions of elements", "");
  forces(force);
  pots(1128);
  words(chart_.says, kEdgeOfPaper, 1554,
        {.px = kLetter, .color = view::kCobalt, .width = kWide - 2 * kEdgeOfPaper});
  return bytes();
}

}  // namespace

std::vector<std::byte> draw_accuracy(const AccuracyChart& chart, const std::string& file) {
  return AccuracySheet(chart, files::is_svg(file)).draw();
}

}  // namespace onggi::plots
