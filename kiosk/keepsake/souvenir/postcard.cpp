#include "kiosk/keepsake/souvenir/postcard.h"

#include <algorithm>
#include <cmath>

#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/square_code.h"

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
constexpr Rect kPot{220, 250, 1060, 1090};  ///< Area of the pot, with space all round.
constexpr float kTitleTop = 1560, kHighestTitle = 1400, kTitleGap = 10;
constexpr float kPrintGap = 40;
constexpr float kSectionWidth = 250, kSectionHeight = 290;
constexpr float kFoot = kPostcardHeight - kMargin;
// QR codes with their quiet zones: 17 mm, and 25 mm for the visitor's own code, which is scanned
// with a phone in the other hand, or off another screen, where the card is 127 mm wide.
constexpr float kCode = 200, kOwnCode = 290;
constexpr float kCaption = 22, kCaptionAir = 12;

using Points = std::vector<std::pair<float, float>>;

view::TextStyle type(Face face, float px, const std::string& language) {
  view::TextStyle style;
  style.face = face;
  style.px = px;
  style.line_height = face == Face::serif ? 1.2f : 1.35f;
  style.language = language;
  return style;
}

/// The reading side of a card. The layout is mirrored for right-to-left; a code or a drawing is
/// moved and not mirrored.
class Side {
 public:
  explicit Side(bool right_to_left) : from_right_(right_to_left) {}
  float x(float left, float width) const {
    return from_right_ ? kPostcardWidth - left - width : left;
  }
  /// A line aligned to the reading side in every script, also a Latin credit under Arabic words.
  std::string line(const std::string& words) const {
    // Right-to-left mark, and the words isolated in their own direction (Unicode UAX 9).
    return from_right_ ? "\u200f\u2068" + words + "\u2069" : words;
  }

 private:
  bool from_right_;
};

struct Setting {
  float height = 0;
  std::optional<Text> text;  ///< Its place on the card; nothing if there are no words.
};

/// Sets `words` `width` wide from the margin, smaller if they would take more than `most` lines.
Setting set(const std::string& words, view::TextStyle style, Color color, float width, int most,
            const Side& side, const view::TextMeasure& measure) {
  if (words.empty()) return {};
  const std::string line = side.line(words);
  auto size = measure.measure(line, style, width);
  for (int i = 0;
       i < 12 && (size.height > style.px * style.line_height * (static_cast<float>(most) + 0.5f) ||
                  size.width > width);
       ++i) {
    style.px *= 0.93f;
    size = measure.measure(line, style, width);
  }
  return {size.height, Text{{side.x(kMargin, width), 0, width, size.height}, line, style, color}};
}

/// Places the text at `top` and returns the top of what comes below.
float put(view::Frame& card, Setting setting, float top) {
  if (setting.text) {
    setting.text->box.y = top;
    card.items.push_back(std::move(*setting.text));
  }
  return top + setting.height;
}

/// A QR code with its words below, centred.
struct CodeBlock {
  CodeBlock(const std::string& address, float wanted_px, const std::string& words,
            const std::string& language, const view::TextMeasure& measure)
      : code(address), wanted(wanted_px), width(code.width(wanted)) {
    if (code.empty() || words.empty()) return;
    caption = Text{{0, 0, width - 2 * kCaptionAir, 0},
                   words,
                   type(Face::sans, kCaption, language),
                   view::kFaintInk};
    caption->style.align = Align::centre;
    caption->box.h = std::ceil(measure.measure(words, caption->style, caption->box.w).height);
  }
  /// Top of code, quiet zone and words. Without words the code's ink ends on the foot's line.
  float top() const {
    const auto quiet = static_cast<float>(view::SquareCode::kQuiet * code.module(wanted));
    return kFoot - width + (caption ? -caption->box.h : quiet);
  }
  void put_at(view::Frame& card, float x) {
    if (code.empty()) return;
    code.draw(card.items, x, top(), wanted);
    if (!caption) return;
    caption->box.x = x + kCaptionAir;
    caption->box.y = kFoot - caption->box.h;
    card.items.push_back(*caption);
  }
  view::SquareCode code;
  float wanted, width;
  std::optional<Text> caption{};
};

/// Draws a vessel like an archaeologist: the wall in section on the left of its axis, the outside
/// on the right, foot and rim as straight lines.
class SectionDrawing {
 public:
  SectionDrawing(view::Frame& card, const Profile& made, const Profile& target, const Side& side)
      : card_(card) {
    const double height = std::max(made.height(), target.height());
    const double radius = std::max(made.max_radius(), target.max_radius());
    scale_ = std::min(static_cast<double>(kSectionHeight) / height,
                      static_cast<double>(kSectionWidth) / (2 * radius));
    const auto reach = static_cast<float>(radius * scale_);
    axis_ = side.x(kPostcardWidth - kMargin - 2 * reach, 2 * reach) + reach;
    ground_ = kFoot - 6;
    top_ = ground_ - static_cast<float>(height * scale_);
  }
  float top() const { return top_; }

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
    // Rule rim and foot; the axis separates section and view.
    card_.items.push_back(Line{{at(-p.outer_at(top), top), at(p.outer_at(top), top)}, {ink}, 2});
    card_.items.push_back(Line{{at(-p.outer_at(0), 0), at(p.outer_at(0), 0)}, {ink}, 2});
    card_.items.push_back(Line{{at(0, 0), at(0, top)}, {ink}, 1.5f});
  }

 private:
  static constexpr int kSteps = 120;

  std::pair<float, float> at(double x, double h) const {
    return {axis_ + static_cast<float>(x * scale_), ground_ - static_cast<float>(h * scale_)};
  }

  /// Cut clay is black: strips of two pixels, each from the outside to the inside.
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
  float axis_ = 0, ground_ = 0, top_ = 0;
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

  // Beside the small print at the foot: the codes, and in the corner the drawing of the pot over
  // the pale outline of its vessel.
  const Side side(words.right_to_left);
  const float width = kPostcardWidth - 2 * kMargin;
  const bool both = !words.address.empty() && !words.phone.empty();
  CodeBlock own(words.phone, kOwnCode, words.phone_words, words.language, measure);
  CodeBlock museum(words.address, kCode, both ? words.address_words : "", words.language, measure);
  const bool codes = !own.code.empty() || !museum.code.empty();
  const float own_left = kMargin + width - kSectionWidth - (codes ? 30.0f : 60.0f) - own.width;
  const float code_left = own_left - museum.width;
  own.put_at(card, side.x(own_left, own.width));
  museum.put_at(card, side.x(code_left, museum.width));
  float beside_top = kFoot;  // top of what is beside the words
  for (const CodeBlock* block : {&own, &museum})
    if (!block->code.empty()) beside_top = std::min(beside_top, block->top());
  if (made.points.size() >= 2 && target.points.size() >= 2) {
    SectionDrawing drawing(card, made, target, side);
    drawing.outline(target, view::kDryClay, 2.5f);
    drawing.drawing(made, view::kInk);
    beside_top = std::min(beside_top, drawing.top());
  }

  // Small print at the foot.
  const float print_width = code_left - kMargin;
  const auto print = type(Face::sans, 28, words.language);
  std::string small;
  for (const std::string& line : {words.decorated, words.glaze, words.credit, words.date})
    if (!line.empty()) small += (small.empty() ? "" : "\n") + side.line(line);
  float print_top = kFoot;
  if (!small.empty()) {
    const auto size = measure.measure(small, print, print_width);
    print_top -= size.height;
    card.items.push_back(Text{{side.x(kMargin, print_width), print_top, print_width, size.height},
                              small,
                              print,
                              view::kFaintInk});
  }

  // Title and vessel are under the pot, nearer to it if the space below is needed. The title has
  // the card's width, and the vessel the space left by drawing and codes.
  Setting title =
      set(words.title, type(Face::serif, 78, words.language), view::kInk, width, 2, side, measure);
  Setting vessel = set(words.vessel, type(Face::sans, 38, words.language), view::kFaintInk,
                       print_width, 2, side, measure);
  const float told = title.height + 10 + vessel.height;
  const float room = std::min(print_top - kPrintGap - told, beside_top - kTitleGap - title.height);
  const float under = put(card, std::move(title), std::clamp(room, kHighestTitle, kTitleTop)) + 10;
  put(card, std::move(vessel), under);
  return card;
}

}  // namespace onggi::souvenir
