#include "kiosk/souvenir/postcard.h"

#include <algorithm>
#include <cmath>

#include "kiosk/view/palette.h"
#include "kiosk/view/square_code.h"

namespace onggi::souvenir {

using view::Align;
using view::Box;
using view::Color;
using view::Face;
using view::Line;
using view::Rect;
using view::Text;

namespace {

// One grid for the whole card, in pixels of 1500 x 2100.
constexpr float kMargin = 120;
constexpr Rect kPot{220, 250, 1060, 1090};  ///< The pot stands in it, air all round.
constexpr float kTitleTop = 1560, kHighestTitle = 1400;
constexpr float kCircle = 30, kStarsGap = 26;
constexpr float kSectionWidth = 250, kSectionHeight = 290;
constexpr float kFoot = kPostcardHeight - kMargin;
constexpr float kCode = 200;  ///< Square code and its quiet zone: 17 mm where the card is 127.

using Points = std::vector<std::pair<float, float>>;

view::TextStyle type(Face face, float px, const std::string& language) {
  view::TextStyle style;
  style.face = face;
  style.px = px;
  style.line_height = face == Face::serif ? 1.2f : 1.35f;
  style.language = language;
  return style;
}

/// Sets `words` at `top`, smaller where they would take more than `most` lines; gives the new top.
float set(view::Frame& card, const std::string& words, view::TextStyle style, Color color,
          float top, float width, int most, const view::TextMeasure& measure) {
  if (words.empty()) return top;
  auto size = measure.measure(words, style, width);
  for (int i = 0;
       i < 12 && (size.height > style.px * style.line_height * (static_cast<float>(most) + 0.5f) ||
                  size.width > width);
       ++i) {
    style.px *= 0.93f;
    size = measure.measure(words, style, width);
  }
  card.items.push_back(Text{{kMargin, top, width, size.height}, words, style, color});
  return top + size.height;
}

/// A vessel as it is drawn in the field: the wall in section on the left of its axis, the outside
/// on the right, foot and rim ruled across.
class SectionDrawing {
 public:
  SectionDrawing(view::Frame& card, const Profile& made, const Profile& target) : card_(card) {
    const double height = std::max(made.height(), target.height());
    const double radius = std::max(made.max_radius(), target.max_radius());
    scale_ = std::min(static_cast<double>(kSectionHeight) / height,
                      static_cast<double>(kSectionWidth) / (2 * radius));
    axis_ = kPostcardWidth - kMargin - static_cast<float>(radius * scale_);
    ground_ = kFoot - 6;
  }

  /// The outline of both sides, hairline.
  void outline(const Profile& p, Color color, float width) {
    for (const double side : {-1.0, 1.0}) {
      Points line;
      for (int i = 0; i <= kSteps; ++i) {
        const double h = p.height() * i / kSteps;
        line.push_back(at(side * p.outer_at(h), h));
      }
      card_.items.push_back(Line{line, {color}, width});
    }
  }

  /// Half section and half view.
  void drawing(const Profile& p, Color ink) {
    const double top = p.height(), floor = p.floor_height();
    fill_wall(p, ink);
    Points right, inner;
    for (int i = 0; i <= kSteps; ++i) {
      const double h = top * i / kSteps;
      right.push_back(at(p.outer_at(h), h));
      const double inside = floor + (top - floor) * i / kSteps;
      if (inside > floor) inner.push_back(at(-p.inner_at(inside), inside));
    }
    card_.items.push_back(Line{right, {ink}, 2});
    card_.items.push_back(Line{inner, {ink}, 2});
    // Rim and foot are ruled, the axis divides section and view.
    card_.items.push_back(Line{{at(-p.outer_at(top), top), at(p.outer_at(top), top)}, {ink}, 2});
    card_.items.push_back(Line{{at(-p.outer_at(0), 0), at(p.outer_at(0), 0)}, {ink}, 2});
    card_.items.push_back(Line{{at(0, 0), at(0, top)}, {ink}, 1.5f});
  }

 private:
  static constexpr int kSteps = 120;

  std::pair<float, float> at(double x, double h) const {
    return {axis_ + static_cast<float>(x * scale_), ground_ - static_cast<float>(h * scale_)};
  }

  /// Cut clay is black. Laid as strips of two pixels, each from the outside to the inside.
  void fill_wall(const Profile& p, Color ink) {
    const auto strips = static_cast<int>(std::ceil(p.height() * scale_ / 2));
    for (int i = 0; i < strips; ++i) {
      const double h = std::min(p.height(), (i + 0.5) * 2 / scale_);
      const double inner = h < p.floor_height() ? 0.0 : p.inner_at(h);
      const auto [x0, y] = at(-p.outer_at(h), h);
      const float x1 = at(-inner, h).first;
      card_.items.push_back(Box{{x0, y - 1.1f, x1 - x0, 2.2f}, 0, ink, 0, {}});
    }
  }

  view::Frame& card_;
  double scale_ = 1;
  float axis_ = 0, ground_ = 0;
};

}  // namespace

view::Frame compose_postcard(const PostcardWords& words, const Profile& made, const Profile& target,
                             const view::TextMeasure& measure,
                             const std::optional<view::Glazing>& glazing) {
  view::Frame card;
  card.width = kPostcardWidth;
  card.height = kPostcardHeight;

  view::PotView pot;
  pot.camera =
      view::frame_pot(kPostcardWidth, kPostcardHeight, kPot, made.height(), made.max_radius());
  if (glazing) {
    pot.finish = view::Finish::fired;
    pot.glazing = *glazing;
  }
  pot.wheel = false;
  card.pot = pot;

  // The museum's page, between the small print and the drawing: its ink ends on the same line.
  const float width = kPostcardWidth - 2 * kMargin;
  const view::SquareCode code(words.address);
  const float code_width = code.width(kCode), code_left = kMargin + width - kSectionWidth -
                                                          (code.empty() ? 60.0f : 30 + code_width);
  code.draw(card.items, code_left,
            kFoot - code_width + static_cast<float>(view::SquareCode::kQuiet * code.module(kCode)),
            kCode);

  // Small print at the foot, left of code and drawing.
  const float print_width = code_left - kMargin;
  const auto print = type(Face::sans, 28, words.language);
  std::string small;
  for (const std::string& line : {words.glaze, words.credit, words.date})
    if (!line.empty()) small += (small.empty() ? "" : "\n") + line;
  float print_top = kFoot;
  if (!small.empty()) {
    const auto size = measure.measure(small, print, print_width);
    print_top -= size.height;
    card.items.push_back(
        Text{{kMargin, print_top, print_width, size.height}, small, print, view::kFaintInk});
  }

  // Title and vessel under the pot, nearer to it where the print below needs the room.
  const auto told = [&](view::Frame& on, float top) {
    const float y = set(on, words.title, type(Face::serif, 78, words.language), view::kInk, top,
                        width, 2, measure);
    return set(on, words.vessel, type(Face::sans, 38, words.language), view::kFaintInk, y + 10,
               code.empty() ? width : print_width, 2, measure);
  };
  view::Frame aside;
  const float room = print_top - kStarsGap - kCircle - kStarsGap - told(aside, 0);
  const float y = told(card, std::clamp(room, kHighestTitle, kTitleTop));

  // Five circles, as many filled as there are stars.
  for (int i = 0; i < 5; ++i) {
    const Rect circle{kMargin + static_cast<float>(i) * kCircle * 1.6f, y + kStarsGap, kCircle,
                      kCircle};
    const Color fill = i < words.stars ? view::kIron : Color{0, 0, 0, 0};
    card.items.push_back(Box{circle, kCircle / 2, fill, 2.5f, view::kIron});
  }

  // The drawing in the corner: what was made, over the pale outline of what it answers.
  if (made.points.size() >= 2 && target.points.size() >= 2) {
    SectionDrawing drawing(card, made, target);
    drawing.outline(target, view::kDryClay, 2.5f);
    drawing.drawing(made, view::kInk);
  }
  return card;
}

}  // namespace onggi::souvenir
