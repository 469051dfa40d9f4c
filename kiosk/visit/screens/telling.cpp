#include "kiosk/visit/screens/telling.h"

#include <algorithm>
#include <string>
#include <vector>

#include "kiosk/visit/screens/hands_drawing.h"
#include "kiosk/visit/screens/hint.h"
#include "kiosk/visit/screens/lesson_line.h"

namespace onggi::screens {

using view::Face;

namespace {

constexpr float kDrawing = 0.2f;       // of the pot's space
constexpr float kDrawingLines = 3.6f;  // ems of the sentence, upright
constexpr float kSmallest = 0.6f;      // of that, if many languages take up the space

std::vector<std::string> all_that_may_be_told(const Desk& desk) {
  std::vector<std::string> all = all_hints(desk);
  for (const std::string& key : FaultNote::keys()) all.push_back(desk.say(key));
  for (const std::string& key : DeviceNews::keys()) all.push_back(desk.say(key));
  for (const char* key : ShowMe::kKeys) all.push_back(desk.say(key));
  all.push_back(desk.say(kClayFirst));
  if (desk.lesson() != nullptr)
    for (const content::LessonStep& step : *desk.lesson()) {
      all.push_back(step.words_in(desk.words().code()));
      all.push_back(LessonLine::by_keys(desk, step.until));
    }
  return all;
}

/// In portrait at the far end of the sentence. Else below it, smaller if there is less space,
/// because it would hide the pot.
view::Rect slip_for(Page& page, const view::Rect& room, float taken, bool right_to_left) {
  const view::Rect& pot = page.where().pot;
  if (page.where().portrait) {
    const float side = telling_drawing(page) - page.type().gap;
    return {right_to_left ? room.x : room.x + room.w - side, room.y, side, side};
  }
  const float wanted = kDrawing * std::min(pot.w, pot.h), left = room.h - taken;
  const float side = std::min(wanted, left);
  if (side < kSmallest * wanted) page.overflowed();
  return {room.x + (room.w - side) / 2, room.y + taken + (left - side) / 2, side, side};
}

}  // namespace

float telling_drawing(const Page& page) {
  return page.where().portrait ? kDrawingLines * page.type().lead + page.type().gap : 0.0f;
}

float telling_below(const Page& page) {
  const view::Rect& pot = page.where().pot;
  return page.where().portrait ? 0.0f
                               : kSmallest * kDrawing * std::min(pot.w, pot.h) + page.type().gap;
}

float longest_telling(const Page& page, const Desk& desk, float width) {
  const auto style = page.style(Face::sans, page.type().lead);
  float longest = 0;
  for (const std::string& words : all_that_may_be_told(desk))
    longest = std::max(longest, page.size(words, style, width).height);
  return longest;
}

void lay_out_telling(Column& column, const Desk& desk, const ShowMe& show, const Hint& hint,
                     bool by_keys, const std::string& news) {
  Page& page = column.page();
  const TypeScale& t = page.type();
  const view::Rect room = column.rest();
  const bool right_to_left = desk.words().right_to_left();
  const float aside = telling_drawing(page);
  const view::Rect words{right_to_left ? room.x + aside : room.x, room.y, room.w - aside, room.h};
  const float longest = longest_telling(page, desk, words.w);
  if (longest > room.h) page.overflowed();

  // On a wheel that stands, or without the coil or the paddle, no step can be done.
  const bool first = hint.key == "hint.take_coil" || hint.key == "hint.take_paddle" ||
                     hint.key == "hint.wheel_still";
  const content::LessonStep* step = first ? nullptr : LessonLine::shown(desk);
  const bool told = !news.empty();
  Column sentence(page, words);
  sentence.text(told              ? desk.say(news)
                : show.showing()  ? desk.say(show.key())
                : step == nullptr ? words_of(hint, desk)
                : by_keys         ? LessonLine::by_keys(desk, step->until)
                                  : step->words_in(desk.words().code()),
                t.lead);
  if (told) return;
  const view::Rect slip = slip_for(page, room, longest + t.gap, right_to_left);
  if (show.showing())
    draw_hands(page, slip, show.drawing());
  else if (step != nullptr)
    draw_hands(page, slip, step->hands);
  else if (hint.press && hint.key != "hint.beat")  // no hand presses
    draw_pressing_hand(page, slip, hint.press->inward);
}

}  // namespace onggi::screens
