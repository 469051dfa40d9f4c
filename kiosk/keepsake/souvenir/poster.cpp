#include "kiosk/keepsake/souvenir/poster.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/square_code.h"

namespace onggi::souvenir {

using view::Align;
using view::Face;
using view::Text;

namespace {

constexpr float kEdge = 200, kWords = kPosterWidth - 2 * kEdge;
constexpr float kHeadTop = 190, kTitle = 290, kLead = 92, kFine = 46;
constexpr float kPotTop = 720;  // two lines of title stand above it
constexpr float kFootLine = kPosterHeight - kEdge;
constexpr float kCodeWide = 520;  // 44 mm: read from a metre away
constexpr float kGap = 60;

view::TextStyle type(const PosterWords& words, Face face, float px) {
  view::TextStyle style;
  style.face = face;
  style.px = px;
  style.line_height = face == Face::serif ? 1.15f : 1.4f;
  style.language = words.language;
  style.right_to_left = words.right_to_left;
  return style;
}

/// A paragraph `width` wide, set smaller until it has at most `height`.
Text set(const std::string& words, view::TextStyle style, view::Color color, float width,
         float height, const view::TextMeasure& measure) {
  auto size = measure.measure(words, style, width);
  while (style.px > 24 && (size.height > height || size.width > width)) {
    style.px *= 0.95f;
    size = measure.measure(words, style, width);
  }
  return {{kEdge, 0, width, std::ceil(size.height)}, words, style, color};
}

}  // namespace

view::Frame compose_poster(const PosterWords& words, view::PictureId pot,
                           const view::TextMeasure& measure) {
  view::Frame poster;
  poster.width = kPosterWidth;
  poster.height = kPosterHeight;
  const auto put = [&poster](Text text, float left, float top) {
    text.box.x = left;
    text.box.y = top;
    poster.items.emplace_back(std::move(text));
  };
  poster.items.emplace_back(view::Picture{
      {0, kPotTop, static_cast<float>(kPosterPotWidth), static_cast<float>(kPosterPotHeight)},
      pot});
  put(set(words.title, type(words, Face::serif, kTitle), view::kInk, kWords, kPotTop - kHeadTop,
          measure),
      kEdge, kHeadTop);

  // The foot is built upwards: the code and its words, beside them the small print.
  const view::SquareCode code(words.address);
  float beside = 0;  // the width that the code takes from the small print
  if (!code.empty()) {
    const float width = code.width(kCodeWide);
    const float left = words.right_to_left ? kEdge : kPosterWidth - kEdge - width;
    Text below =
        set(words.address_words, type(words, Face::sans, kFine), view::kInk, width, 140, measure);
    below.style.align = Align::centre;
    const float foot = kFootLine - below.box.h;
    put(std::move(below), left, foot);
    code.draw(poster.items, left, foot - width, kCodeWide);
    beside = width + kGap;
  }
  const float width = kWords - beside;
  const float left = words.right_to_left ? kEdge + beside : kEdge;
  std::string small;
  for (const std::string& line : {words.museum, words.vessel, words.credit})
    if (!line.empty()) small += (small.empty() ? "" : "\n") + line;
  Text print = set(small, type(words, Face::sans, kFine), view::kFaintInk, width, 330, measure);
  const float print_top = kFootLine - print.box.h;
  put(std::move(print), left, print_top);
  Text lead = set(words.lead, type(words, Face::sans, kLead), view::kInk, width,
                  print_top - kGap - kPotTop - kPosterPotHeight, measure);
  put(std::move(lead), left, kPotTop + kPosterPotHeight);
  return poster;
}

}  // namespace onggi::souvenir
