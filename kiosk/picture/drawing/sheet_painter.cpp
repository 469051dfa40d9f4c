#include "kiosk/picture/drawing/sheet_painter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "kiosk/picture/drawing/engraving.h"
#include "kiosk/picture/drawing/pen.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::drawing {

namespace {

constexpr double kWidth = 2400, kMargin = 130;
/// A sheet is at most as tall as a page of its width: 1 to the square root of 2.
constexpr double kPage = 3394;
/// Below the foot's upper edge: the start of the notes, and the space reserved for the credit.
constexpr double kFootTop = 210, kFootEnd = 190;
/// The drawing, with space for diameters and the height.
constexpr double kMostWide = 1560, kMostHigh = 1700;
constexpr double kTitle = 68, kText = 33, kSmall = 29;

constexpr view::Color kSeenWall = view::rgb(0x2B2622);
constexpr view::Color kSlice = view::rgb(0xD9482B);

class Sheet : private Pen {
 public:
  explicit Sheet(const VesselSheet& sheet) : s_(sheet) { measure(); }

  view::Image draw();

 private:
  void measure();
  double x(double metres) const { return axis_ + metres * scale_; }
  double y(double metres) const { return base_ - metres * scale_; }
  void path(const std::vector<Vec2>& points, double side, bool closed);

  void draw_head();
  void draw_view();
  void draw_section();
  void draw_axis();
  void draw_sizes();
  void draw_diameter(double height, double diameter, double place, const char* name, bool above);
  double draw_scale_bar(double top);
  double draw_key(double left, double top);
  void draw_foot();

  const VesselSheet& s_;
  double scale_ = 1.0, axis_ = 0, base_ = 0, height_ = 0;
  double low_ = 0, high_ = 0, left_ = 0, right_ = 0;  // of the whole drawing, metres

  /// Facts and notes of the foot, each with its height; those that do not fit are counted.
  struct Said {
    std::string words;
    Lettering how;
    double height = 0, gap = 0;
  };
  std::vector<Said> said_;
  double gather_said(double room);
};

constexpr double kSaidLeft = kMargin + 1270;

/// Fills said_ with what fits `room` pixels; returns its height.
double Sheet::gather_said(double room) {
  Pen scratch;
  scratch.begin(1, 1);
  Lettering how{
      .px = kSmall, .color = view::kInk, .width = kWidth - kMargin - kSaidLeft, .lines = 4};
  double used = 0;
  const auto take = [&](const std::string& words, double gap, double keep) {
    const double height = scratch.height_of(words, how);
    if (used + height + gap + keep > room) return false;
    said_.push_back({words, how, height, gap});
    used += height + gap;
    return true;
  };
  for (const std::string& fact : s_.facts) take(fact, &fact == &s_.facts.back() ? 15 : 7, 0);
  how.color = view::kFaintInk;
  const double last_line = scratch.height_of("0", how) + 7;
  for (std::size_t i = 0; i < s_.notes.size(); ++i) {
    const std::size_t after = s_.notes.size() - i - 1;
    if (take(s_.notes[i], 7, after > 0 ? last_line : 0)) continue;
    take(std::to_string(after + 1) + " more notes: onggi vessel inspect lists them.", 7, 0);
    break;
  }
  return used;
}

/// Whole numbers above 10, one decimal below.
std::string millimetres(double metres) {
  char out[32];
  const double mm = 1000.0 * metres;
  std::snprintf(out, sizeof out, mm < 9.95 ? "%.1f" : "%.0f", mm);
  return out;
}

void Sheet::measure() {
  low_ = 0.0;
  high_ = s_.height;
  left_ = right_ = 0.5 * s_.belly;
  for (const auto& t : s_.mesh.triangles)
    for (const std::uint32_t i : t) {
      const auto& p = s_.mesh.positions[i];
      low_ = std::min<double>(low_, p[1]);
      high_ = std::max<double>(high_, p[1]);
      right_ = std::max<double>(right_, p[0]);
    }
  for (const auto& piece : s_.slice) left_ = std::max(left_, -std::min(piece[0].x, piece[1].x));
  // Distant splinters must not make the vessel small.
  const double most = 3.0 * std::max(s_.belly, s_.height);
  left_ = std::min(left_, most);
  right_ = std::min(right_, most);
  high_ = std::min(high_, s_.height + most);
  low_ = std::max(low_, -most);
  scale_ = std::min(kMostWide / (left_ + right_), kMostHigh / (high_ - low_));
  axis_ = 0.5 * (kWidth + (left_ - right_) * scale_);
  base_ = 450 + high_ * scale_;
  const double foot = y(low_) + kFootTop - 12;
  const double said = gather_said(kPage - kFootEnd - foot);
  height_ = std::ceil(foot + std::max(222.0, said) + kFootEnd);
  begin(static_cast<int>(kWidth), static_cast<int>(height_));
}

void Sheet::path(const std::vector<Vec2>& points, double side, bool closed) {
  for (std::size_t i = 0; i < points.size(); ++i)
    i == 0 ? cairo_move_to(c_, x(side * points[i].x), y(points[i].y))
           : cairo_line_to(c_, x(side * points[i].x), y(points[i].y));
  if (closed) cairo_close_path(c_);
}

void Sheet::draw_head() {
  const double inside = kWidth - 2 * kMargin;
  const double used =
      words(s_.title, kMargin, 96,
            {.px = kTitle, .color = view::kInk, .width = inside, .lines = 2, .serif = true});
  words(s_.subtitle, kMargin, 104 + used,
        {.px = kText, .color = view::kFaintInk, .width = inside, .lines = 2});
}

/// The right half as seen, and everything that was left out to the right of it.
void Sheet::draw_view() {
  EngravingWindow window;
  window.left = 0.0;
  window.right = right_ + 4 / scale_;
  window.bottom = low_ - 4 / scale_;
  window.top = high_ + 4 / scale_;
  window.pixels_per_metre = scale_;
  picture(engrave(s_.mesh, s_.limit, window), axis_, y(window.top));

  // The extracted profile, over the view.
  ink(view::kCobalt);
  cairo_set_line_width(c_, 4);
  path(s_.outer, 1.0, false);
  cairo_stroke(c_);
}

void Sheet::draw_section() {
  // The visible inside beyond the cut: an edge for each sharp turn, and for the floor.
  ink(view::kFaintInk);
  const auto radius = [](const std::vector<Vec2>& outline, double h) {
    double r = 0.0, nearest = 1e300;
    for (const Vec2& p : outline)
      if (std::abs(p.y - h) < nearest) nearest = std::abs(p.y - h), r = p.x;
    return r;
  };
  std::vector<Vec2> inner;
  for (const auto* runs : {&s_.inner_seen, &s_.inner_inferred})
    for (const auto& run : *runs) inner.insert(inner.end(), run.begin(), run.end());
  for (const double h : s_.inner_edges)
    if (!inner.empty()) line(axis_, y(h), x(-radius(inner, h)), y(h), 2.5);
  line(axis_, y(s_.height), x(-radius(s_.outer, s_.height)), y(s_.height), 3.5);

  // The wall: black if both sides were seen, hatched if the inside is inferred.
  const bool inferred = !s_.inner_inferred.empty();
  cairo_save(c_);
  path(s_.wall, -1.0, true);
  if (!inferred) {
    ink(kSeenWall);
    cairo_fill(c_);
  } else {
    cairo_clip(c_);
    ink(kSeenWall);
    for (double d = -height_; d < kWidth + height_; d += 14) line(d, 0, d - height_, height_, 3);
  }
  cairo_restore(c_);
  if (inferred) {
    // Parts that were seen are black all the same.
    cairo_save(c_);
    path(s_.wall, -1.0, true);
    cairo_clip(c_);
    ink(kSeenWall);
    for (const auto& run : s_.inner_seen) {
      if (run.size() < 2) continue;
      cairo_rectangle(c_, x(-left_) - 10, y(run.back().y), left_ * scale_ + 10,
                      y(run.front().y) - y(run.back().y));
      cairo_fill(c_);
    }
    cairo_restore(c_);
  }
  ink(kSeenWall);
  cairo_set_line_width(c_, 4);
  path(s_.outer, -1.0, false);
  cairo_stroke(c_);
  for (const auto& run : s_.inner_seen) {
    path(run, -1.0, false);
    cairo_stroke(c_);
  }
  const double dashes[] = {16, 12};
  cairo_set_dash(c_, dashes, 2, 0);
  for (const auto& run : s_.inner_inferred) {
    path(run, -1.0, false);
    cairo_stroke(c_);
  }
  cairo_set_dash(c_, nullptr, 0, 0);

  // The mesh cut by the drawing's plane: where it leaves the wall, the profile is wrong.
  ink(kSlice);
  cairo_set_line_width(c_, 2.5);
  cairo_save(c_);
  cairo_rectangle(c_, 0, 0, axis_, height_);
  cairo_clip(c_);
  for (const auto& piece : s_.slice) {
    cairo_move_to(c_, x(piece[0].x), y(piece[0].y));
    cairo_line_to(c_, x(piece[1].x), y(piece[1].y));
  }
  cairo_stroke(c_);
  cairo_restore(c_);
}

void Sheet::draw_axis() {
  ink(view::kInk);
  const double dash[] = {34, 10, 6, 10};
  cairo_set_dash(c_, dash, 4, 0);
  line(axis_, y(high_) - 64, axis_, y(low_) + 64, 2.5);
  cairo_set_dash(c_, nullptr, 0, 0);
  if (!s_.up_doubted) return;
  // It may be upside down: the arrow shows the chosen direction.
  const double tip = y(high_) - 152, foot = y(high_) - 104;
  ink(view::kIron);
  line(axis_, foot, axis_, tip, 4);
  line(axis_ - 13, tip + 18, axis_, tip, 4);
  line(axis_ + 13, tip + 18, axis_, tip, 4);
  char text[48];
  std::snprintf(text, sizeof text, "up? %.0f %% sure", 100.0 * s_.up_sure);
  words(text, axis_ - 26, tip - 4, {.px = kSmall, .side = -1, .color = view::kIron});
}

/// A diameter above or below the vessel's end at `height`: a thin line with a tick at each end and
/// its figure. Dots lead to the places of the wall, at `place`, where it was measured.
void Sheet::draw_diameter(double height, double diameter, double place, const char* name,
                          bool above) {
  const double at = y(height) + (above ? -96 : 78);
  const double x0 = x(-0.5 * diameter), x1 = x(0.5 * diameter);
  ink(view::kFaintInk);
  line(x0, at, x1, at, 2);
  const double dots[] = {2, 7};
  for (const double end : {x0, x1}) {
    line(end, at - 11, end, at + 11, 2);
    cairo_set_dash(c_, dots, 2, 0);
    line(end, at + (above ? 18 : -18), end, y(place), 2);
    cairo_set_dash(c_, nullptr, 0, 0);
  }
  const std::string figure = std::string(name) + " ⌀ " + millimetres(diameter) + " mm";
  // Beside the axis, on a paper background, so that lines do not cross it.
  words(figure, std::max(x1, axis_) + 24, at - 23, {.px = kSmall, .color = view::kInk});
}

void Sheet::draw_sizes() {
  draw_diameter(std::max(s_.height, high_), s_.mouth, s_.mouth_height, "mouth", true);
  draw_diameter(low_, s_.foot, s_.foot_height, "foot", false);

  // Height at the far left, the widest place at the far right.
  const double hx = x(-left_) - 96;
  ink(view::kFaintInk);
  line(hx, y(0), hx, y(s_.height), 2);
  for (const double h : {0.0, s_.height}) {
    line(hx - 11, y(h), hx + 11, y(h), 2);
    const double dots[] = {2, 9};
    cairo_set_dash(c_, dots, 2, 0);
    line(hx + 20, y(h), x(-(h == 0.0 ? 0.5 * s_.foot : 0.5 * s_.mouth)) - 12, y(h), 2);
    cairo_set_dash(c_, nullptr, 0, 0);
  }
  words(millimetres(s_.height) + " mm", hx - 24, y(0.5 * s_.height) - 22,
        {.px = kSmall, .side = -1, .color = view::kInk});

  if (s_.belly_height < 0.06 * s_.height || s_.belly_height > 0.94 * s_.height) return;
  const double bx = x(right_) + 40;
  ink(view::kFaintInk);
  const double dots[] = {2, 9};
  cairo_set_dash(c_, dots, 2, 0);
  line(x(0.5 * s_.belly) + 10, y(s_.belly_height), bx, y(s_.belly_height), 2);
  cairo_set_dash(c_, nullptr, 0, 0);
  words("⌀ " + millimetres(s_.belly) + " mm", bx + 14, y(s_.belly_height) - 22,
        {.px = kSmall, .color = view::kInk});
}

double Sheet::draw_scale_bar(double top) {
  // The longest round length up to a third of the sheet, in five parts.
  double length = 1e-3;
  for (double decade = 1e-3; decade < 1e4; decade *= 10.0)
    for (const double step : {1.0, 2.0, 5.0})
      if (decade * step * scale_ <= 620.0) length = decade * step;
  const double wide = length * scale_, part = wide / 5.0;
  ink(view::kInk);
  for (int i = 0; i < 5; ++i) {
    cairo_rectangle(c_, kMargin + i * part, top, part, 20);
    i % 2 == 0 ? cairo_fill(c_) : cairo_new_path(c_);
  }
  cairo_set_line_width(c_, 2.5);
  cairo_rectangle(c_, kMargin, top, wide, 20);
  cairo_stroke(c_);
  char text[48];
  if (length >= 0.01)
    std::snprintf(text, sizeof text, "%g cm", 100.0 * length);
  else
    std::snprintf(text, sizeof text, "%g mm", 1000.0 * length);
  words("0", kMargin, top + 28, {.px = kSmall, .side = 0, .color = view::kInk});
  words(text, kMargin + wide, top + 28, {.px = kSmall, .side = 0, .color = view::kInk});
  if (!s_.true_size)
    return 120 + words("The vessel's true size is not known.", kMargin, top + 76,
                       {.px = kSmall, .color = view::kIron});
  return 76;
}

double Sheet::draw_key(double left, double top) {
  const double swatch = 62, row = 50;
  double at = top - 12;
  const auto entry = [&](const std::string& text) {
    words(text, left + swatch + 24, at, {.px = kSmall, .color = view::kInk});
    at += row;
  };
  const auto box = [&](auto&& fill) {
    cairo_save(c_);
    cairo_rectangle(c_, left, at + 8, swatch, 26);
    fill();
    cairo_restore(c_);
  };
  if (s_.inner_inferred.empty() || !s_.inner_seen.empty()) {
    box([&] {
      ink(kSeenWall);
      cairo_fill(c_);
    });
    entry("wall, both sides seen");
  }
  if (!s_.inner_inferred.empty()) {
    box([&] {
      cairo_clip(c_);
      ink(kSeenWall);
      for (double d = left - 60; d < left + 2 * swatch; d += 14) line(d + 40, at, d, at + 40, 3);
    });
    entry("wall, inside inferred");
  }
  ink(kSlice);
  line(left, at + 21, left + swatch, at + 21, 3);
  entry("the mesh, cut");
  ink(view::kCobalt);
  line(left, at + 21, left + swatch, at + 21, 4);
  entry("the profile that was read");
  if (s_.masked_fraction > 0.002) {
    box([&] {
      ink(view::rgb(0xD98F6C));
      cairo_fill(c_);
    });
    entry("left out of the profile");
  }
  return at - top;
}

void Sheet::draw_foot() {
  const double top = y(low_) + kFootTop;
  ink(view::kFaintInk, 0.5);
  line(kMargin, top - 48, kWidth - kMargin, top - 48, 1.5);
  draw_scale_bar(top);
  draw_key(kMargin + 760, top);
  double at = top - 12;
  for (const Said& said : said_) at += words(said.words, kSaidLeft, at, said.how) + said.gap;
  if (!s_.credit.empty())
    words(s_.credit, kMargin, height_ - 104,
          {.px = kSmall, .color = view::kFaintInk, .width = kWidth - 2 * kMargin, .lines = 2});
}

view::Image Sheet::draw() {
  draw_head();
  draw_view();
  draw_section();
  draw_axis();
  draw_sizes();
  draw_foot();
  return image();
}

}  // namespace

view::Image draw_sheet(const VesselSheet& sheet) { return Sheet(sheet).draw(); }

}  // namespace onggi::drawing
