#include "kiosk/visit/screens/decorate_controls.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "kiosk/collection/settings/text_in.h"
#include "kiosk/visit/screens/light_color.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/stroke_board.h"

namespace onggi::screens {

using decorating::DecoratedPot;
using decoration::WayTool;
using view::Face;

namespace {

constexpr const char* kMore = "decorate.more";
constexpr std::string_view kTool = "decorate.tool.", kColor = "decorate.color.",
                           kFigure = "decorate.figure.", kTimes = "decorate.times.";

/// The tick of a choice stands over its button by half its size: it must not hide a caption.
constexpr float kClearOfTick = 0.35f;

std::string numbered(std::string_view prefix, int n) {
  return std::string(prefix) + std::to_string(n);
}

std::optional<int> number_after(const std::string& control, std::string_view prefix) {
  if (!control.starts_with(prefix)) return std::nullopt;
  int n = 0;
  std::from_chars(control.data() + prefix.size(), control.data() + control.size(), n);
  return n;
}

std::string in_words(const Desk& desk, const decoration::Words& words) {
  return settings::text_in(words, desk.words().code());
}

Button choice(std::string id, std::string words, bool on) {
  Button button{std::move(id), std::move(words), on ? Look::chosen : Look::outline};
  button.on = on;
  button.tight = true;
  return button;
}

std::vector<Button> tool_buttons(const Desk& desk, const DecoratedPot& pot) {
  std::vector<Button> row;
  bool others = false;
  for (int n = 0; n < static_cast<int>(pot.way().tools.size()); ++n) {
    // Those behind *More*, or those before it.
    if (pot.way().tools[static_cast<std::size_t>(n)].more != pot.held().more) {
      others = true;
      continue;
    }
    row.push_back(choice(numbered(kTool, n),
                         in_words(desk, pot.way().tools[static_cast<std::size_t>(n)].name),
                         n == pot.tool()));
    // The one that must come before the held one.
    if (pot.waits(pot.tool()) && pot.held().needs == n) row.back().look = Look::called;
  }
  if (!others) return row;
  Button more{kMore, desk.say(pot.held().more ? "decorate.first" : "decorate.more"), Look::outline};
  more.tight = true;
  row.push_back(std::move(more));
  return row;
}

std::vector<Button> color_buttons(const Desk& desk, const DecoratedPot& pot, const WayTool& tool,
                                  int on) {
  std::vector<Button> row;
  for (int n = 0; n < static_cast<int>(tool.pigments.size()); ++n) {
    const auto pigment = static_cast<std::size_t>(tool.pigments[static_cast<std::size_t>(n)]);
    row.push_back(
        choice(numbered(kColor, n), in_words(desk, pot.way().pigments[pigment].name), n == on));
    row.back().swatch = display(pot.way().palette.pigments[pigment].fired);
  }
  return row;
}

/// A figure's lines and the outlines of its areas, as large as a square of 1 holds them.
std::vector<std::vector<std::pair<float, float>>> sketch_of(const decoration::Motif& motif) {
  constexpr std::size_t kEvery = 4;  // of the points: a button is small
  double most = 0.0;
  for (const auto* ways : {&motif.fills, &motif.lines})
    for (const auto& points : *ways)
      for (const Vec2& p : points) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  std::vector<std::vector<std::pair<float, float>>> sketch;
  for (const auto* ways : {&motif.fills, &motif.lines})
    for (const auto& points : *ways) {
      auto& line = sketch.emplace_back();
      const auto add = [&](const Vec2& p) {
        line.emplace_back(static_cast<float>(0.5 + 0.5 * p.x / most),
                          static_cast<float>(0.5 - 0.5 * p.y / most));
      };
      for (std::size_t n = 0; n < points.size(); n += kEvery) add(points[n]);
      add(ways == &motif.fills ? points.front() : points.back());
    }
  return sketch;
}

std::vector<Button> figure_buttons(const Desk& desk, const DecoratedPot& pot, const WayTool& tool,
                                   int on) {
  std::vector<Button> row;
  for (int n = 0; n < static_cast<int>(tool.motifs.size()); ++n) {
    const auto figure = static_cast<std::size_t>(tool.motifs[static_cast<std::size_t>(n)]);
    row.push_back(choice(numbered(kFigure, n), "", n == on));
    row.back().spoken = in_words(desk, pot.way().figures[figure].name);
    row.back().sketch = sketch_of(pot.way().figures[figure].motif);
  }
  return row;
}

std::vector<Button> times_buttons(const Desk& desk, int on) {
  std::vector<Button> row;
  for (const int n : decoration::kRepeats) {
    row.push_back(choice(numbered(kTimes, n), std::to_string(n), n == on));
    row.back().spoken = desk.say("decorate.times", {{"n", std::to_string(n)}});
  }
  return row;
}

/// Choices that the tool leaves open, each row under its caption.
void choices(Column& column, const Desk& desk, const DecoratedPot& pot, const WayTool& tool,
             const std::optional<int>& color, int figure, int repeats) {
  const TypeScale& t = column.page().type();
  const auto row = [&](const char* caption, const std::vector<Button>& buttons) {
    if (buttons.size() < 2) return;
    column.text(desk.say(caption), t.body, Face::sans, view::kFaintInk);
    // With buttons for everything there is no room to spare.
    const bool crowded = StrokeBoard::wanted(desk);
    if (!crowded) column.space(t.body * kClearOfTick);
    column.buttons(buttons);
    if (!crowded) column.space(t.gap * 0.25f);
  };
  row("decorate.color", color_buttons(desk, pot, tool, color.value_or(-1)));
  row("decorate.figure", figure_buttons(desk, pot, tool, figure));
  if (tool.hand == WayTool::line || tool.hand == WayTool::figure)
    row("decorate.repeats", times_buttons(desk, repeats));
}

std::string sentence(const Desk& desk, const DecoratedPot& pot, bool shows, bool soon) {
  if (shows) return desk.say("decorate.watch");
  if (pot.waits(pot.tool()))
    return desk.say(
        "decorate.needs",
        {{"tool",
          in_words(desk, pot.way().tools[static_cast<std::size_t>(pot.held().needs)].name)}});
  if (soon) return desk.say("decorate.soon");
  if (pot.bare() && pot.tool() == 0) return in_words(desk, pot.way().about);
  return in_words(desk, pot.held().how);
}

/// Height of the longest sentence, so that no button moves when it changes.
float longest(const Page& page, const Desk& desk, const DecoratedPot& pot, float width) {
  const TypeScale& t = page.type();
  float most = 0;
  const auto look = [&](const std::string& words) {
    most = std::max(most, page.size(words, page.style(Face::sans, t.body),
                                    std::min(width, t.body * 0.52f * 55.0f))
                              .height);
  };
  look(desk.say("decorate.soon"));
  look(desk.say("decorate.watch"));
  look(in_words(desk, pot.way().about));
  for (const WayTool& tool : pot.way().tools) look(in_words(desk, tool.how));
  return most;
}

Button show_button(const Desk& desk, const DecoratedPot& pot, bool shows) {
  const bool can_show = shows || !pot.waits(pot.tool());
  return {can_show ? "decorate.show" : "", desk.say("throw.show"),
          !can_show ? Look::resting
          : shows   ? Look::chosen
                    : Look::outline};
}

void foot(Column& column, const Desk& desk, const DecoratedPot& pot, bool shows) {
  const TypeScale& t = column.page().type();
  column.foot_buttons(standing_buttons(desk, true));
  column.foot_space(t.gap);
  const bool bare = pot.bare();
  const bool can_undo = pot.can_undo();
  std::vector<Button> on{{"decorate.on",
                          desk.say(bare                ? "decorate.skip"
                                   : desk.curated      ? "decorate.save"
                                   : desk.wheel().kiln ? "decorate.fire"
                                                       : "result.keep"),
                          bare ? Look::outline : Look::solid, desk.say("decorate.skip")}};
  on.push_back({can_undo ? "decorate.undo" : "", desk.say("decorate.undo"),
                can_undo ? Look::outline : Look::resting});
  // All in one flow: with buttons for everything there is no row to spare.
  if (StrokeBoard::wanted(desk))
    for (const char* id : {"decorate.higher", "decorate.lower", "decorate.turn_left",
                           "decorate.turn_right", "decorate.here"})
      on.push_back({id, desk.say(id), Look::outline});
  if (!StrokeBoard::wanted(desk)) on.push_back(show_button(desk, pot, shows));
  column.foot_buttons(on);
  column.foot_space(t.gap);
}

/// Takes the first of the tools on the other side of *More*.
void turn_over(DecoratedPot& pot) {
  const auto& tools = pot.way().tools;
  const auto other = std::ranges::find(tools, !pot.held().more, &WayTool::more);
  if (other != tools.end()) pot.choose_tool(static_cast<int>(other - tools.begin()));
}

}  // namespace

void lay_out_decorating(Page& page, const Desk& desk, const DecoratedPot& pot, bool shows,
                        bool soon) {
  const TypeScale& t = page.type();
  Column column(page, page.where().words);
  foot(column, desk, pot, shows);
  column.text(desk.say("decorate.title"), t.title, Face::serif);
  column.space(t.gap * 0.5f);
  const view::Rect room = column.rest();
  column.text(sentence(desk, pot, shows, soon), t.body);
  const float said = column.rest().y - room.y;
  column.space(std::max(0.0f, longest(page, desk, pot, room.w) - said) + t.gap);
  column.into_reach();
  std::vector<Button> tools = tool_buttons(desk, pot);
  if (StrokeBoard::wanted(desk)) tools.push_back(show_button(desk, pot, shows));
  column.buttons(tools);
  column.space(StrokeBoard::wanted(desk) ? 0.5f * t.gap : t.gap);
  // The page is as small as the tool with the most choices needs it, so that all have one size.
  float least = column.rest().h;
  for (const WayTool& tool : pot.way().tools) {
    Page trial = page;
    Column other(trial, column.rest());
    choices(other, desk, pot, tool, 0, 0, tool.repeats);
    least = std::min(least, other.rest().h);
  }
  if (least < 0) page.overflowed();
  choices(column, desk, pot, pot.held(), pot.pigment(), pot.figure(), pot.repeats());
  column.check();
}

bool press_decorating(const std::string& control, DecoratedPot& pot) {
  if (control == "decorate.undo")
    pot.undo();
  else if (control == kMore)
    turn_over(pot);
  else if (const auto tool = number_after(control, kTool))
    pot.choose_tool(*tool);
  else if (const auto color = number_after(control, kColor))
    pot.choose_pigment(*color);
  else if (const auto figure = number_after(control, kFigure))
    pot.choose_figure(*figure);
  else if (const auto times = number_after(control, kTimes))
    pot.choose_repeats(*times);
  else
    return false;
  return true;
}

std::string did_in_words(const Desk& desk, const DecoratedPot& pot) {
  std::string all;
  for (const DecoratedPot::Did& did : pot.did()) {
    const auto& tool = pot.way().tools[static_cast<std::size_t>(did.tool)];
    all += (all.empty() ? "" : desk.say("decorate.and")) + in_words(desk, tool.did);
  }
  return all;
}

}  // namespace onggi::screens
