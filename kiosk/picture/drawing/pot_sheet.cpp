#include "kiosk/picture/drawing/pot_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/picture/drawing/pen.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::drawing {

namespace {

constexpr double kEdge = 90.0;        // of paper, all round
constexpr double kSideWidth = 620.0;  // of section and view
constexpr double kBetween = 90.0;     // them and the strip
constexpr double kUnderPicture = 14.0, kCaptionRoom = 96.0;
constexpr double kNameLine = 420.0, kNameHigh = 66.0;
constexpr int kSteps = 240;  // of the wall's outline

class PotPage : public Pen {
 public:
  explicit PotPage(const PotSheet& sheet) : sheet_(sheet) {}

  view::Image drawn() {
    begin(kSheetWidth, kSheetHeight);
    const double top = heading();
    const double foot = facts();
    const double wide = kSheetWidth - 2.0 * kEdge - kSideWidth - kBetween;
    const bool right = sheet_.right_to_left;
    side(right ? kSheetWidth - kEdge - kSideWidth : kEdge, top, foot - kCaptionRoom);
    unrolled(right ? kEdge : kEdge + kSideWidth + kBetween, wide, top, foot);
    return image();
  }

 private:
  struct Place {
    double left = 0.0, top = 0.0, wide = 0.0, high = 0.0;
  };

  double start() const { return sheet_.right_to_left ? kSheetWidth - kEdge : kEdge; }
  int toward() const { return sheet_.right_to_left ? -1 : 1; }
  Lettering letters(double px, bool faint) const {
    Lettering how;
    how.px = px, how.side = toward();
    how.color = faint ? view::kFaintInk : view::kInk;
    return how;
  }

  double heading() {
    Lettering how = letters(56, false);
    how.serif = true;
    const double room = kSheetWidth - 2.0 * kEdge;
    while (how.px > 30 && width_of(sheet_.title, how) > room) how.px -= 2;
    double y = kEdge - 24.0;
    y += words(sheet_.title, start(), y, how);
    if (!sheet_.subtitle.empty()) y += words(sheet_.subtitle, start(), y, letters(30, true));
    return y + 40.0;
  }

  /// The top of the lines at the foot.
  double facts() {
    const Lettering how = letters(26, true);
    double high = 0.0;
    for (const std::string& line : sheet_.facts) high += height_of(line, how) + 2.0;
    const double bottom = kSheetHeight - kEdge + 24.0;
    hands(bottom);
    double y = bottom - high;
    const double top = std::min(y, bottom - kNameHigh * static_cast<double>(sheet_.hands.size()));
    for (const std::string& line : sheet_.facts) y += words(line, start(), y, how) + 2.0;
    return top - 24.0;
  }

  /// Opposite the other lines: the names are written by those who made it.
  void hands(double bottom) {
    Lettering how = letters(26, false);
    how.side = -toward();
    const double end = sheet_.right_to_left ? kEdge : kSheetWidth - kEdge;
    const double back = -toward() * kNameLine;
    double y = bottom - kNameHigh * static_cast<double>(sheet_.hands.size());
    for (const std::string& hand : sheet_.hands) {
      y += kNameHigh;
      ink(view::kInk);
      line(end, y - 6.0, end + back, y - 6.0, 1.5);
      words(hand, end + back - toward() * 16.0, y - 6.0 - height_of(hand, how), how);
    }
  }

  void put(const ScaledPicture& picture, double left, double top, double pixels) {
    cairo_save(c_);
    cairo_translate(c_, left, top);
    const double scale = pixels / picture.pixels;
    cairo_scale(c_, scale, scale);
    Pen::picture(picture.image, 0.0, 0.0);
    cairo_restore(c_);
  }

  /// Words below a picture, and its bar.
  void caption(const std::string& what, double middle, double top, double wide, double pixels) {
    Lettering how = letters(26, false);
    how.side = 0;
    how.width = 0;
    while (how.px > 18 && width_of(what, how) > wide) how.px -= 1;
    const double y = top + kUnderPicture + words(what, middle, top + kUnderPicture, how) + 8.0;
    // The longest of these that takes a third of the width at the most.
    double bar = 0.01;
    for (const double metres : {0.02, 0.05, 0.1, 0.2})
      if (metres * pixels <= wide / 3.0) bar = metres;
    ink(view::kInk);
    const double half = 0.5 * bar * pixels;
    cairo_set_line_cap(c_, CAIRO_LINE_CAP_BUTT);
    line(middle - half, y + 8.0, middle + half, y + 8.0, 3.0);
    for (const double at : {-half, half}) line(middle + at, y, middle + at, y + 16.0, 3.0);
    cairo_set_line_cap(c_, CAIRO_LINE_CAP_ROUND);
    Lettering small = letters(22, false);
    small.side = 1;
    words(std::to_string(static_cast<int>(std::lround(100.0 * bar))) + " cm", middle + half + 14.0,
          y - 8.0, small);
  }

  void side(double left, double top, double foot) {
    const Profile& pot = sheet_.pot;
    const double tall = pot.height(), widest = pot.max_radius();
    const double pixels = std::min(kSideWidth / (2.0 * widest), (foot - top) / tall);
    const double axis = left + 0.5 * kSideWidth, ground = foot;
    // The view, of which the right half is seen.
    cairo_save(c_);
    cairo_rectangle(c_, axis, top - 40.0, kSideWidth, foot - top + 80.0);
    cairo_clip(c_);
    const double wide = sheet_.side.image.width / sheet_.side.pixels * pixels;
    const double high = sheet_.side.image.height / sheet_.side.pixels * pixels;
    put(sheet_.side, axis - 0.5 * wide, ground - high, pixels);
    cairo_restore(c_);
    const auto to = [&](double radius, double height, bool first = false) {
      const double x = axis + radius * pixels, y = ground - height * pixels;
      first ? cairo_move_to(c_, x, y) : cairo_line_to(c_, x, y);
    };
    // The wall, cut.
    const double floor = pot.floor_height();
    to(0.0, 0.0, true);
    for (int n = 0; n <= kSteps; ++n) to(-pot.outer_at(tall * n / kSteps), tall * n / kSteps);
    if (floor < tall)
      for (int n = kSteps; n >= 0; --n) {
        const double height = floor + (tall - floor) * n / kSteps;
        to(-pot.inner_at(height), height);
      }
    to(0.0, std::min(floor, tall));
    cairo_close_path(c_);
    ink(view::kInk);
    cairo_fill(c_);
    // The view's outline, the rim and the foot.
    to(pot.outer_at(0.0), 0.0, true);
    for (int n = 0; n <= kSteps; ++n) to(pot.outer_at(tall * n / kSteps), tall * n / kSteps);
    cairo_set_line_width(c_, 2.0);
    cairo_stroke(c_);
    for (const double height : {0.0, tall}) {
      const double r = pot.outer_at(height) * pixels, y = ground - height * pixels;
      line(axis - r, y, axis + r, y, 2.0);
    }
    line(axis, ground, axis, ground - tall * pixels, 1.5);
    caption(sheet_.side_words, axis, ground, kSideWidth, pixels);
  }

  void unrolled(double left, double wide, double top, double foot) {
    const auto metres = [](const ScaledPicture& picture) {
      return std::array{picture.image.width / picture.pixels,
                        picture.image.height / picture.pixels};
    };
    const auto strip = metres(sheet_.strip), zones = metres(sheet_.zones);
    // Below each other or beside each other, as they are larger.
    const double high = foot - top;
    const double stacked = std::min(wide / std::max(strip[0], zones[0]),
                                    (high - 2.0 * kCaptionRoom - 30.0) / (strip[1] + zones[1]));
    const double abreast = std::min((wide - 60.0) / (strip[0] + zones[0]),
                                    (high - kCaptionRoom) / std::max(strip[1], zones[1]));
    const double pixels = std::max(stacked, abreast);
    if (stacked >= abreast) {
      const double middle = left + 0.5 * wide;
      const double used = (strip[1] + zones[1]) * pixels + 2.0 * kCaptionRoom;
      const double gap = std::max(0.0, high - used);
      put(sheet_.strip, middle - 0.5 * strip[0] * pixels, top, pixels);
      caption(sheet_.strip_words, middle, top + strip[1] * pixels, wide, pixels);
      const double at = top + strip[1] * pixels + kCaptionRoom + gap;
      put(sheet_.zones, middle - 0.5 * zones[0] * pixels, at, pixels);
      caption(sheet_.zones_words, middle, at + zones[1] * pixels, wide, pixels);
      return;
    }
    const double a = strip[0] * pixels, b = zones[0] * pixels, gap = wide - a - b;
    const double ground = foot - kCaptionRoom;
    put(sheet_.strip, left, ground - strip[1] * pixels, pixels);
    caption(sheet_.strip_words, left + 0.5 * a, ground, a + 0.4 * gap, pixels);
    put(sheet_.zones, left + a + gap, ground - zones[1] * pixels, pixels);
    caption(sheet_.zones_words, left + a + gap + 0.5 * b, ground, b + 0.4 * gap, pixels);
  }

  const PotSheet& sheet_;
};

}  // namespace

view::Image draw_sheet(const PotSheet& sheet) { return PotPage(sheet).drawn(); }

}  // namespace onggi::drawing
