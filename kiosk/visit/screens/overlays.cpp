#include "kiosk/visit/screens/overlays.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace onggi::screens {

using view::Face;

namespace {
constexpr float kHelpLine = 0.52f * 55,
                kHelpKeys = 12;  // em: width of a line, and least width beside it
constexpr std::string_view kGlobe =
    "arc 12,12 9,9 0 360; arc 12,12 4.2,9 0 360; 12,3 12,21; 3,12 21,12; 4.2,7.5 19.8,7.5; "
    "4.2,16.5 19.8,16.5";

// Who held a finger still by chance now hears a voice: its way out is marked.
Button comfort(const Desk& desk) {
  Button way{"comfort", desk.say("all.comfort"), Look::quiet};
  if (desk.screen().spoken || desk.screen().one_switch) way.on = true;
  return way;
}
}  // namespace

std::vector<Button> globe(const Desk& desk) {
  if (desk.world.languages->size() < 2) return {};
  Button button{"language", desk.say("all.language"), Look::quiet};
  button.drawing = kGlobe;
  return {std::move(button)};
}

std::vector<Button> standing_buttons(const Desk& desk, bool with_back) {
  std::vector<Button> row = globe(desk);
  if (with_back) row.push_back({"back", desk.say("all.back"), Look::quiet});
  row.push_back({"help", desk.say("all.help"), Look::quiet});
  row.push_back(comfort(desk));
  return row;
}

std::vector<Button> reading_buttons(const Desk& desk) {
  std::vector<Button> row = globe(desk);
  row.push_back(comfort(desk));
  return row;
}

void lay_out_help(Page& page, const Desk& desk, const std::vector<std::string>& paragraphs,
                  const std::string& keys) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  column.foot_buttons(reading_buttons(desk));
  column.foot_space(t.gap);
  column.foot_buttons({{"help.close", desk.say("help.close"), Look::solid}});
  column.foot_space(t.gap);
  column.text(desk.say("all.help"), t.title, Face::serif);
  column.space(t.gap);
  // Keys stand beside the other text if both do not fit one below the other.
  const view::Rect room = column.rest();
  const float width = std::min(room.w, kHelpLine * t.body), aside = 2 * t.body;
  const auto height = [&](const std::string& words) {
    return page.size(words, page.style(Face::sans, t.body), width).height + t.gap;
  };
  float all = height(keys) - t.gap;
  for (const std::string& words : paragraphs) all += height(words);
  const float beside = room.w - width - aside;
  const bool two = all > room.h && beside >= kHelpKeys * t.body;
  const bool from_right = page.right_to_left();
  Column first(page, {from_right ? room.x + room.w - width : room.x, room.y, width, room.h});
  for (const std::string& words : paragraphs) {
    first.text(words, t.body);
    first.space(t.gap);
  }
  if (!two) return first.text(keys, t.body, Face::sans, view::kFaintInk);
  Column second(page, {from_right ? room.x : room.x + room.w - beside, room.y, beside, room.h});
  second.text(keys, t.body, Face::sans, view::kFaintInk);
}

void lay_out_leaving(Page& page, const Desk& desk) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  column.foot_buttons(reading_buttons(desk));
  column.foot_space(t.gap);
  column.space(page.where().page.h * 0.12f);
  column.text(desk.say("leaving.title"), t.display, Face::serif);
  column.space(t.gap);
  column.text(desk.say("leaving.text"), t.lead);
  column.space(t.gap * 2);
  column.buttons({{"leaving.close", desk.say("leaving.close"), Look::solid},
                  {"leaving.go", desk.say("leaving.go"), Look::outline}});
}

void lay_out_idle(Page& page, const Desk& desk, double seconds_left, double countdown) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  column.foot_buttons(reading_buttons(desk));
  column.foot_space(t.gap);
  const int seconds = static_cast<int>(std::ceil(seconds_left));
  column.space(page.where().page.h * 0.12f);
  column.text(desk.say("idle.title"), t.display, Face::serif);
  column.space(t.gap);
  column.text(desk.say("idle.countdown", {{"seconds", std::to_string(seconds)}}), t.lead);
  column.space(t.gap);
  // The same as a line that gets shorter.
  const view::Rect rest = column.rest();
  const auto share = static_cast<float>(std::clamp(seconds_left / countdown, 0.0, 1.0));
  const float thick = std::max(2.0f, t.body * 0.12f);
  page.draw(view::Box{{rest.x, rest.y, rest.w * share, thick}, thick / 2, view::kInk, 0, {}});
  column.space(thick + t.gap * 2);
  column.buttons({{"idle.stay", desk.say("idle.stay"), Look::solid}});
}

}  // namespace onggi::screens
