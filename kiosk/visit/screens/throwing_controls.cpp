#include "kiosk/visit/screens/throwing_controls.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kiosk/visit/screens/hint.h"
#include "kiosk/visit/screens/measured_pot.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/telling.h"
#include "kiosk/visit/screens/tool_tray.h"

namespace onggi::screens {

using device::Grip;
using view::Face;

namespace {

constexpr float kPotAbove = 0.4f;         // of the shorter side of the reach
constexpr float kMostUsed = 4.0f / 3.0f;  // of the least touch target: 20 mm
constexpr double kBlink = 1.2;            // s, of a button that calls
constexpr float kColumn = 0.3f, kLargerColumn = 0.42f, kWidestColumn = 0.5f;  // of the width

constexpr const char *kToolsWay = "throw.tools", *kWheelWay = "throw.wheel",
                     *kCloseWay = "throw.less";

Button tools_button(const Desk& desk, const ThrowingControls& now) {
  std::string longest = desk.say(ToolTray::way_in(desk, 0));
  for (std::size_t n = 1; n <= desk.wheel().tools.size(); ++n)
    if (const std::string name = ToolTray::name_of(desk, n); name.size() > longest.size())
      longest = name;
  return {kToolsWay, desk.say(ToolTray::way_in(desk, now.held)),
          now.held > 0 ? Look::chosen : Look::outline, longest};
}

/// The buttons to the drawers, or back.
std::vector<Button> ways(const Desk& desk, const ThrowingControls& now) {
  if (now.drawer != Drawer::closed) return {{kCloseWay, desk.say(kCloseWay), Look::solid}};
  std::vector<Button> both{{kWheelWay, desk.say(kWheelWay), Look::outline}};
  // Two visitors with bare hands have nothing to choose.
  if (!desk.wheel().tools.empty() || !desk.two_hands())
    both.insert(both.begin(), tools_button(desk, now));
  for (Button& way : both) way.tight = true;
  return both;
}

void most_used(Column& column, const Desk& desk, const ThrowingControls& now) {
  Page& page = column.page();
  const bool happened = now.mishap != Mishap::none;
  std::vector<Button> cells;
  const auto add = [&](const char* id, const char* words, Look look, bool there,
                       std::optional<bool> on = std::nullopt) {
    cells.push_back({there ? id : "", desk.say(words), look});
    cells.back().tight = true;
    cells.back().on = on;
  };
  if (happened) {
    const bool fell = now.mishap == Mishap::fell;
    add("throw.restore", fell ? "throw.before_fall" : "throw.before_tear",
        now.drawer == Drawer::closed ? Look::solid : Look::outline, desk.status.can_restore);
  } else {
    const bool blinks = now.calls && std::fmod(desk.now, kBlink) < kBlink / 2;
    const bool on = now.fire.value_or(now.water);
    const char* const which = now.fire ? "throw.fire" : "throw.water";
    add(which, which, on ? Look::chosen : blinks ? Look::called : Look::outline, true, on);
    // Reserve its place, unless the exhibit never shows it.
    if (!desk.eyes_closed() && (now.board || !desk.two_hands()))
      add("throw.show",
          now.coil     ? "throw.lay"
          : now.paddle ? "throw.beat"
                       : "throw.show",
          now.show.look, !now.show.id.empty());
  }
  add("throw.done", "throw.done", now.onward ? Look::solid : Look::outline, true);
  if (!happened)
    add("throw.restore", "throw.restore", now.restore ? Look::outline : Look::resting, now.restore);
  column.foot_grid(cells, page.type().target * kMostUsed, page.where().mirrored);
  column.foot_space(page.type().gap);
}

std::vector<Button> in_a_row(std::vector<Button> first, const std::vector<Button>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// True if `row` needs a single line at the foot of `column`.
bool one_row(const Column& column, const std::vector<Button>& row) {
  Page unseen = column.page();
  Column trial(unseen, column.rest());
  trial.foot_buttons(row);
  return column.rest().h - trial.rest().h < 2 * unseen.type().target;
}

/// The drawers' buttons, or back, and the buttons of every screen. `together`: in one row.
void standing_with(Column& column, const Desk& desk, const std::vector<Button>& on, bool together) {
  const std::vector<Button> links = standing_buttons(desk, true);
  column.foot_buttons(together ? in_a_row(on, links) : links);
  column.foot_space(column.page().type().gap);
  if (together || on.empty()) return;
  if (column.page().where().portrait) {
    column.foot_buttons(on);
    return column.foot_space(column.page().type().gap);
  }
  // As wide as the buttons above, if both fit.
  if (column.abreast(on) == 2)
    column.foot_grid(on, column.page().type().target, column.page().where().mirrored);
  else
    column.foot_buttons(on);
  column.foot_space(column.page().type().gap);
}

/// The foot of the page, as high with a drawer open as with both closed, so that what is used most
/// stays at its place.
void standing(Column& column, const Desk& desk, const ThrowingControls& now) {
  // The board shows the drawers' buttons among the strokes, and a drawer shows back.
  if (now.board) return standing_with(column, desk, {}, false);
  Page unseen = column.page();
  Column other(unseen, column.rest());
  ThrowingControls then = now;
  then.drawer = now.drawer == Drawer::closed ? Drawer::tools : Drawer::closed;
  // In portrait one row holds everything, if it can with the drawers closed and open: links that
  // went to and fro between two rows would be hard to find.
  const std::vector<Button> links = standing_buttons(desk, true);
  const bool together = column.page().where().portrait &&
                        one_row(column, in_a_row(ways(desk, now), links)) &&
                        one_row(column, in_a_row(ways(desk, then), links));
  standing_with(other, desk, ways(desk, then), together);
  standing_with(column, desk, ways(desk, now), together);
  column.foot_space(std::max(0.0f, column.rest().h - other.rest().h));
}

/// The vessel's name, and at the far end the skip of the lesson; and the device in use.
void heading(Column& column, const Desk& desk, const ThrowingControls& now) {
  Page& page = column.page();
  const TypeScale& t = page.type();
  const view::Rect at = column.rest();
  const Button skip{"throw.skip", desk.say("throw.skip"), Look::quiet};
  const bool skip_below = at.y < page.where().reach;
  auto skip_size = page.size(skip, at.w);
  if (skip_below) {
    if (now.skip)
      column.foot_buttons({skip});
    else
      column.foot_space(skip_size.height);
    column.foot_space(t.gap);
    skip_size = {};
  }
  const auto style = page.style(Face::serif, t.body);
  const float width = at.w - skip_size.width - t.gap;
  const std::string title = desk.heading();
  const auto size = page.size(title, style, width);
  if (size.width > width + 2) page.overflowed();
  const float height = std::max(skip_size.height, size.height);
  const bool from_right = desk.words().right_to_left();
  page.words({from_right ? at.x + at.w - width : at.x, at.y + (height - size.height) / 2, width,
              size.height},
             title, style, view::kFaintInk);
  page.tell(at.y, title);
  if (now.skip && !skip_below)
    page.button(skip,
                {from_right ? at.x : at.x + at.w - skip_size.width, at.y, skip_size.width, height});
  column.space(height);
  // The hint gives the other wanted figures if they are off.
  if (const auto figures = MeasuredPot::sentences(desk); !figures.empty())
    column.text(figures.front(), t.body);
  if (desk.two_hands()) column.text(desk.say(desk.halves()), t.body);
  if (desk.eyes_closed()) column.text(desk.say("mission.unseen"), t.body);
  if (desk.world.devices != nullptr && !desk.world.devices->in_use().empty())
    column.text(desk.say(desk.world.devices->in_use()), t.body, Face::sans, view::kFaintInk);
  column.space(t.gap * 0.5f);
}

void tell_mishap(Column& column, const Desk& desk, Mishap what) {
  const TypeScale& t = column.page().type();
  const bool fell = what == Mishap::fell;
  column.text(desk.say(fell ? "throw.fallen" : "throw.torn"), t.lead);
  if (fell) return;
  column.space(t.gap * 0.5f);
  column.text(desk.say(what == Mishap::tore_thin ? "throw.torn_thin" : "throw.torn_wide"), t.body);
}

/// A row of a drawer, with its caption before it or, in a narrow column, above it.
void drawer_row(Column& column, const std::string& caption, const std::vector<Button>& row,
                float captions) {
  const TypeScale& t = column.page().type();
  if (column.page().where().portrait) {
    column.buttons(row, caption, captions);
  } else {
    column.text(caption, t.body, Face::sans, view::kFaintInk);
    column.buttons(row);
  }
  column.space(t.gap * 0.7f);
}

struct DrawerRow {
  std::string caption;
  std::vector<Button> buttons;
};

DrawerRow hand_row(const Desk& desk, const ThrowingControls& now) {
  DrawerRow row{desk.say("throw.hand"), {}};
  for (const auto& [id, which] : {std::pair("throw.both", Grip::both),
                                  {"throw.outside", Grip::outside},
                                  {"throw.inside", Grip::inside}}) {
    row.buttons.push_back({id, desk.say(id), now.grip == which ? Look::chosen : Look::outline});
    row.buttons.back().on = now.grip == which;
  }
  return row;
}

std::vector<DrawerRow> wheel_rows(const Desk& desk, const ThrowingControls& now) {
  const auto rpm = [&](double speed) {
    const auto turns = static_cast<int>(std::lround(speed * 60.0 / (2 * 3.14159265358979)));
    return desk.say("throw.rpm", {{"rpm", std::to_string(turns)}});
  };
  Button cut{"throw.cut", desk.say("throw.cut"), now.cut ? Look::chosen : Look::outline};
  cut.on = now.cut;
  std::vector<DrawerRow> rows{
      {desk.say(kWheelWay),
       {{"throw.slower", desk.say("throw.slower"), Look::outline},
        {"", rpm(now.speed), Look::plain, rpm(desk.wheel().max_speed)},
        {"throw.faster", desk.say("throw.faster"), Look::outline}}},
      {desk.say("throw.clay"), {cut, {"throw.renew", desk.say("throw.renew"), Look::outline}}}};
  if (std::vector<Button> feels = desk.force.buttons(desk); !feels.empty())
    rows.push_back({desk.say("throw.force"), std::move(feels)});
  return rows;
}

/// Strokes by buttons need no touch on the pot, so the pot goes above the reach if there is space.
bool pot_above(const Page& page, const Desk& desk) {
  const Regions& r = page.where();
  return r.reach > 0 && StrokeBoard::wanted(desk) &&
         r.all.y - page.type().margin > kPotAbove * std::min(r.all.w, r.all.h);
}

void drawer(Column& column, const Desk& desk, const ThrowingControls& now) {
  Page& page = column.page();
  const TypeScale& t = page.type();
  if (now.board) {
    column.foot_buttons(ways(desk, now));
    column.foot_space(t.gap);
  }
  column.into_reach();
  std::vector<DrawerRow> rows;
  if (now.drawer == Drawer::wheel) {
    rows = wheel_rows(desk, now);
  } else if (!desk.two_hands()) {
    rows.push_back(hand_row(desk, now));
  }
  float captions = 0;
  for (const DrawerRow& row : rows)
    captions =
        std::max(captions, page.size(row.caption, page.style(Face::sans, t.body), -1).width + 4);
  for (const DrawerRow& row : rows) drawer_row(column, row.caption, row.buttons, captions);
  if (now.drawer == Drawer::tools && pot_above(page, desk)) {
    const view::Rect room = column.rest();
    ToolTray::lay_out(page, room, desk, now.held);
    column.space(ToolTray::least_height(page, desk, room.w));
  }
  column.check();
}

/// The sentence above the strokes by buttons. News comes before the hint. The lesson and the press
/// hints are for hands that draw; here the sentence names the most different part, or gives the
/// advice.
std::string sentence_of(const Desk& desk, const ThrowingControls& now, const Hint& hint) {
  if (!now.news.empty()) return desk.say(now.news);
  if (now.coil && now.working) return desk.say("stroke.lays");
  if (now.paddle && now.working) return desk.say("stroke.beats");
  if (hint.key == "hint.beat" || hint.key == "hint.beat_freely") return desk.say("hint.beat_all");
  for (const char* as_said :
       {"hint.take_paddle", "hint.beaten", "hint.wet", "hint.wheel_still", "hint.dry"})
    if (hint.key == as_said) return words_of(hint, desk);
  // A button lays the coil.
  if (hint.key == "hint.lay_coil" || hint.key == "hint.take_coil") return desk.say("hint.lay_ring");
  if (desk.described() != nullptr) return StrokeBoard::advice(desk);
  if (desk.two_hands() && !now.board->begun()) return desk.say("mission.by_buttons");
  return desk.pot_ready() ? StrokeBoard::told(desk, now.parts, 1).front() : std::string();
}

/// Least free height between head and foot of `box`, whatever is shown; negative: the page is too
/// low. Nothing if something is out of reach or too wide.
std::optional<float> left_in(const view::Rect& box, const Page& page, const Desk& desk,
                             const ThrowingControls& now) {
  bool fits = true;
  const auto left_of = [&](Drawer open, Mishap mishap, const auto& lay_out) {
    ThrowingControls then = now;
    then.drawer = open;
    then.mishap = mishap;
    Page trial = page;
    Column column(trial, box);
    standing(column, desk, then);
    lay_out(column, then);
    fits = fits && trial.in_reach() && !trial.overflow();
    return column.rest().h;
  };
  const auto closed = [&](Mishap mishap) {
    return left_of(Drawer::closed, mishap, [&](Column& column, const ThrowingControls& then) {
      most_used(column, desk, then);
      heading(column, desk, then);
      if (mishap != Mishap::none)
        tell_mishap(column, desk, mishap);
      else
        column.space(longest_telling(page, desk, box.w - telling_drawing(page)) +
                     telling_below(page));
    });
  };
  const auto by_strokes = [&](Column& column, const ThrowingControls& then) {
    most_used(column, desk, then);
    std::string longest = desk.two_hands() ? desk.say("mission.by_buttons") : "";
    for (std::string& hint : all_hints(desk))
      if (hint.size() > longest.size()) longest = std::move(hint);
    then.board->lay_out(column, desk, ways(desk, then), then.parts, false, longest);
  };
  float least = box.h;
  for (const Drawer open : {Drawer::tools, Drawer::wheel})
    least = std::min(least,
                     left_of(open, Mishap::none, [&](Column& column, const ThrowingControls& then) {
                       most_used(column, desk, then);
                       drawer(column, desk, then);
                     }));
  if (now.board) {
    least = std::min(least, left_of(Drawer::closed, Mishap::none, by_strokes));
  } else {
    for (const Mishap what : {Mishap::none, Mishap::fell, Mishap::tore_thin, Mishap::tore_wide})
      least = std::min(least, closed(what));
  }
  return fits ? std::optional(least) : std::nullopt;
}

/// The tray lies over the pot, as far as that is in reach.
view::Rect tray_room(const Page& page) {
  const Regions& r = page.where();
  view::Rect room = r.pot;
  const float margin = page.type().margin;
  if (r.portrait) {
    room.x = r.page.x, room.w = r.page.w;
  } else {
    room.x = r.mirrored ? r.all.x + margin : r.words.x + r.words.w + margin;
    room.w = r.all.w - r.words.w - 3 * margin;
  }
  room.h += std::min(0.0f, room.y - r.reach);
  room.y = std::max(room.y, r.reach);
  return room;
}

/// The text's size must not change with the tray, because the pot's place would.
void check_tray(Page& page, const Desk& desk, const ThrowingControls& now) {
  Page unseen = page;
  ToolTray::lay_out(unseen, tray_room(page), desk, now.held);
  if (unseen.overflow()) page.overflowed();
}

}  // namespace

std::string way_into_drawer(const std::string& control) {
  constexpr const char *kOfTools[] = {"throw.both", "throw.outside", "throw.inside"},
                       *kOfWheel[] = {"throw.slower", "throw.faster", "throw.cut",
                                      "throw.renew",  "throw.softer", "throw.stronger"};
  const auto in = [&](const auto& all) {
    return std::find(std::begin(all), std::end(all), control) != std::end(all);
  };
  if (in(kOfTools) || ToolTray::of_control(control)) return kToolsWay;
  return in(kOfWheel) ? kWheelWay : "";
}

KeyedControl control_of(view::Key key) {
  using view::Key;
  switch (key) {
    case Key::water:
      return {"throw.water"};
    case Key::cut:
      return {"throw.cut"};
    case Key::renew:
      return {"throw.renew"};
    case Key::restore:
      return {"throw.restore", true};
    case Key::faster:
      return {"throw.faster", true};
    case Key::slower:
      return {"throw.slower", true};
    case Key::tell:
      return {"throw.tell"};
    default:
      return {};
  }
}

void give_the_pot_its_room(Page& page, const Desk& desk, const ThrowingControls& now) {
  Regions r = page.where();
  const view::Rect& all = r.all;
  const float margin = page.type().margin;
  const bool above = pot_above(page, desk);
  if (above) {
    r.portrait = true;
    page.divide(r);
  }
  if (r.portrait) {
    constexpr float kEndless = 1e5f;
    const view::Rect endless{0, page.where().reach, r.page.w, kEndless};
    const float high = kEndless - left_in(endless, page, desk, now).value_or(0);
    r.words = {r.page.x, r.page.y + r.page.h - high, r.page.w, high};
    // A smaller pot could not be worked on, so shrink the words instead.
    if (!above && r.words.y < all.y + 0.45f * all.h) page.overflowed();
    if (above && r.words.y < r.reach) page.overflowed();
    const float top = above ? std::max(margin, r.words.y - r.page.w) : all.y + margin;
    r.pot = {r.page.x, top, r.page.w, std::max(r.words.y - margin * 1.5f - top, margin)};
    page.divide(r);
    if (!above) check_tray(page, desk, now);
    return;
  }
  const bool wide = r.roomy || StrokeBoard::wanted(desk);
  const bool wider = r.roomy && (StrokeBoard::wanted(desk) || r.reach > 0);
  r.words.w = std::round(all.w * (wider ? kWidestColumn : wide ? kLargerColumn : kColumn));
  r.words.x = all.x + margin;
  const float left = r.words.x + r.words.w + margin;
  // The axis is on the vertical third, or in the middle of the free space if that is farther out.
  const float axis = std::max(all.x + all.w * 2 / 3, (left + all.x + all.w) / 2);
  const float half = std::min(axis - left, all.x + all.w - axis);
  r.pot = {axis - half, all.y + margin, 2 * half, all.h - margin * 3.0f};
  if (r.mirrored) {
    r.words.x = 2 * all.x + all.w - r.words.x - r.words.w;
    r.pot.x = 2 * all.x + all.w - r.pot.x - r.pot.w;
  }
  page.divide(r);
  // The pot must keep its place, whatever the sentence and whichever drawer is open.
  if (left_in(r.words, page, desk, now).value_or(-2) < -1) page.overflowed();
  check_tray(page, desk, now);
}

void lay_out_throwing(Page& page, const Desk& desk, const ThrowingControls& now, const ShowMe& show,
                      const Hint& hint) {
  Column column(page, page.where().words);
  standing(column, desk, now);
  most_used(column, desk, now);
  if (now.drawer == Drawer::tools && !pot_above(page, desk))
    ToolTray::lay_out(page, tray_room(page), desk, now.held);
  if (now.drawer != Drawer::closed) return drawer(column, desk, now);
  if (now.board)
    return now.board->lay_out(column, desk, ways(desk, now), now.parts,
                              now.working && !now.coil && !now.paddle,
                              sentence_of(desk, now, hint));
  heading(column, desk, now);
  if (now.mishap != Mishap::none) return tell_mishap(column, desk, now.mishap);
  lay_out_telling(column, desk, show, hint, now.by_keys, now.news);
}

}  // namespace onggi::screens
