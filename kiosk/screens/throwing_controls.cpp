#include "kiosk/screens/throwing_controls.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kiosk/screens/hint.h"
#include "kiosk/screens/measured_pot.h"
#include "kiosk/screens/overlays.h"
#include "kiosk/screens/telling.h"
#include "kiosk/screens/tool_tray.h"

namespace onggi::screens {

using device::Grip;
using view::Face;

namespace {

constexpr float kMostUsed = 4.0f / 3.0f;                // of the least touch target: 20 mm
constexpr float kColumn = 0.3f, kLargerColumn = 0.42f;  // of the width

Button drawer_button(const Desk& desk, const ThrowingControls& now) {
  const std::string closed = desk.say("throw.more");
  std::string longest = closed;
  for (std::size_t n = 1; n <= desk.wheel().tools.size(); ++n)
    if (const std::string name = ToolTray::name_of(desk, n); name.size() > longest.size())
      longest = name;
  // What is in the hand is seen where another is taken up.
  const bool tool = now.held > 0;
  return {"throw.more", tool ? ToolTray::name_of(desk, now.held) : closed,
          tool ? Look::solid : Look::outline, longest};
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
    add("throw.restore", fell ? "throw.before_fall" : "throw.before_tear", Look::solid,
        desk.status.can_restore);
  } else {
    add("throw.water", "throw.water", now.water ? Look::solid : Look::outline, true, now.water);
    add("throw.show", "throw.show", now.show.look, !now.show.id.empty());
  }
  add("throw.done", "throw.done", happened ? Look::outline : Look::solid, true);
  // What comes and goes stands last, and its place is kept.
  if (!happened) add("throw.restore", "throw.restore", Look::outline, now.restore);
  column.foot_grid(cells, page.type().target * kMostUsed, page.where().mirrored);
  column.foot_space(page.type().gap);
}

Button way_of(const Desk& desk, const ThrowingControls& now) {
  return now.drawer ? Button{"throw.less", desk.say("throw.less"), Look::solid}
                    : drawer_button(desk, now);
}

/// What stands at the foot of the page: the way to all else, or back from it, and what any screen
/// has.
void standing(Column& column, const Desk& desk, const ThrowingControls& now) {
  const Button way = way_of(desk, now);
  std::vector<Button> row = standing_buttons(desk, true);
  if (now.board && !now.drawer) {  // There it stands among the strokes.
    column.foot_buttons(row);
    column.foot_space(column.page().type().gap);
    return;
  }
  if (column.page().where().portrait) row.insert(row.begin(), way);  // There one row holds it all.
  column.foot_buttons(row);
  column.foot_space(column.page().type().gap);
  if (column.page().where().portrait) return;
  column.foot_buttons({way});
  column.foot_space(column.page().type().gap);
}

/// The vessel, and at the far end the way out of the lesson; and what moves the hand.
void heading(Column& column, const Desk& desk, const ThrowingControls& now) {
  Page& page = column.page();
  const TypeScale& t = page.type();
  const view::Rect at = column.rest();
  const Button skip{"throw.skip", desk.say("throw.skip"), Look::quiet};
  const auto skip_size = page.size(skip, at.w);
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
  if (now.skip)
    page.button(skip,
                {from_right ? at.x : at.x + at.w - skip_size.width, at.y, skip_size.width, height});
  column.space(height);
  // What else was asked is said by the hint, where it is off.
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

/// A row of the drawer, with what it is of before it or, in a narrow column, over it.
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

void drawer(Column& column, const Desk& desk, const ThrowingControls& now) {
  const Page& page = column.page();
  const TypeScale& t = page.type();
  ToolTray::lay_out(column, desk, now.held);
  column.space(t.gap);
  const auto grip = [&](const char* id, Grip which) {
    Button one{id, desk.say(id), now.grip == which ? Look::solid : Look::outline};
    one.on = now.grip == which;
    return one;
  };
  const auto rpm = [&](double speed) {
    const auto turns = static_cast<int>(std::lround(speed * 60.0 / (2 * 3.14159265358979)));
    return desk.say("throw.rpm", {{"rpm", std::to_string(turns)}});
  };
  const std::vector<Button> hand{grip("throw.both", Grip::both),
                                 grip("throw.outside", Grip::outside),
                                 grip("throw.inside", Grip::inside)};
  const std::vector<Button> wheel{{"throw.slower", desk.say("throw.slower"), Look::outline},
                                  {"", rpm(now.speed), Look::plain, rpm(desk.wheel().max_speed)},
                                  {"throw.faster", desk.say("throw.faster"), Look::outline}};
  Button cut{"throw.cut", desk.say("throw.cut"), now.cut ? Look::solid : Look::outline};
  cut.on = now.cut;
  const std::vector<Button> clay{cut, {"throw.renew", desk.say("throw.renew"), Look::outline}};
  const std::vector<Button> feels = desk.force.buttons(desk);
  const std::string of_hand = desk.say("throw.hand"), of_wheel = desk.say("throw.wheel"),
                    of_clay = desk.say("throw.clay"), of_force = desk.say("throw.force");
  float captions = 0;
  for (const std::string& words : {of_hand, of_wheel, of_clay, feels.empty() ? of_clay : of_force})
    captions = std::max(captions, page.size(words, page.style(Face::sans, t.body), -1).width + 4);
  if (!desk.two_hands()) drawer_row(column, of_hand, hand, captions);
  drawer_row(column, of_wheel, wheel, captions);
  drawer_row(column, of_clay, clay, captions);
  if (!feels.empty()) drawer_row(column, of_force, feels, captions);
  column.check();
}

/// Beside strokes by buttons. News go before the hint. The lesson is of hands that draw, and so are
/// hints of where to press: here the part is named that differs most, or what is advised.
std::string sentence_of(const Desk& desk, const ThrowingControls& now, const Hint& hint) {
  if (!desk.note().empty()) return desk.say(desk.note());
  if (hint.key == "hint.wheel_still" || hint.key == "hint.dry") return words_of(hint, desk);
  if (desk.described() != nullptr) return StrokeBoard::advice(desk);
  if (desk.two_hands() && !now.board->begun()) return desk.say("mission.by_buttons");
  return desk.pot_ready() ? StrokeBoard::told(desk, now.parts, 1).front() : std::string();
}

/// What the words' part of the page needs at least, `width` pixels wide, whatever happens.
float height_needed(const Page& page, const Desk& desk, const ThrowingControls& now, float width) {
  constexpr float kEndless = 1e5f;
  const auto height_of = [&](bool open, Mishap mishap, const auto& lay_out) {
    ThrowingControls then = now;
    then.drawer = open;
    then.mishap = mishap;
    Page trial = page;
    Column column(trial, {0, 0, width, kEndless});
    standing(column, desk, then);
    lay_out(column, then);
    return kEndless - column.rest().h;
  };
  const auto closed = [&](Mishap mishap) {
    return height_of(false, mishap, [&](Column& column, const ThrowingControls& then) {
      most_used(column, desk, then);
      heading(column, desk, then);
      if (mishap != Mishap::none)
        tell_mishap(column, desk, mishap);
      else
        column.space(longest_telling(page, desk, width - telling_drawing(page)));
    });
  };
  const auto by_strokes = [&](Column& column, const ThrowingControls& then) {
    most_used(column, desk, then);
    std::string longest = desk.two_hands() ? desk.say("mission.by_buttons") : "";
    for (std::string& hint : all_hints(desk))
      if (hint.size() > longest.size()) longest = std::move(hint);
    then.board->lay_out(column, desk, way_of(desk, then), then.parts, false, longest);
  };
  if (now.board)
    return std::max(height_of(true, Mishap::none,
                              [&](Column& column, const ThrowingControls& then) {
                                drawer(column, desk, then);
                              }),
                    height_of(false, Mishap::none, by_strokes));
  float most = height_of(true, Mishap::none, [&](Column& column, const ThrowingControls& then) {
    drawer(column, desk, then);
  });
  for (const Mishap what : {Mishap::none, Mishap::fell, Mishap::tore_thin, Mishap::tore_wide})
    most = std::max(most, closed(what));
  return most;
}

}  // namespace

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
  if (r.portrait) {
    const float high = height_needed(page, desk, now, r.page.w);
    r.words = {r.page.x, r.page.y + r.page.h - high, r.page.w, high};
    // Less than this and it is no pot to work on: the words are set smaller instead.
    if (r.words.y < all.y + 0.45f * all.h) page.overflowed();
    const float top = all.y + margin;
    r.pot = {r.page.x, top, r.page.w, std::max(r.words.y - margin * 1.5f - top, margin)};
    page.divide(r);
    return;
  }
  const bool wide = desk.screen().larger_text || StrokeBoard::wanted(desk);
  r.words.w = std::round(all.w * (wide ? kLargerColumn : kColumn));
  r.words.x = all.x + margin;
  const float left = r.words.x + r.words.w + margin;
  // The axis on the vertical third, or in the middle of what is left where that lies farther out.
  const float axis = std::max(all.x + all.w * 2 / 3, (left + all.x + all.w) / 2);
  const float half = std::min(axis - left, all.x + all.w - axis);
  r.pot = {axis - half, all.y + margin, 2 * half, all.h - margin * 3.0f};
  if (r.mirrored) {
    r.words.x = 2 * all.x + all.w - r.words.x - r.words.w;
    r.pot.x = 2 * all.x + all.w - r.pot.x - r.pot.w;
  }
  page.divide(r);
}

void lay_out_throwing(Page& page, const Desk& desk, const ThrowingControls& now, const ShowMe& show,
                      const Hint& hint) {
  Column column(page, page.where().words);
  standing(column, desk, now);
  if (now.drawer) return drawer(column, desk, now);
  most_used(column, desk, now);
  if (now.board)
    return now.board->lay_out(column, desk, way_of(desk, now), now.parts, now.working,
                              sentence_of(desk, now, hint));
  heading(column, desk, now);
  if (now.mishap != Mishap::none) return tell_mishap(column, desk, now.mishap);
  lay_out_telling(column, desk, show, hint);
}

}  // namespace onggi::screens
