#include "kiosk/visit/screens/visit_state.h"

#include <algorithm>
#include <utility>

#include "kiosk/visit/screens/comfort_page.h"
#include "kiosk/visit/screens/drift.h"
#include "kiosk/visit/screens/focus.h"
#include "kiosk/visit/screens/language_page.h"
#include "kiosk/visit/screens/overlays.h"

namespace onggi::screens {

using view::InputEvent;
using view::Key;

/// The words change in place: cross-fade.
void Visit::State::reworded() {
  ++serial;
  changed_at = desk.now;
}

/// The picture changes: cross-fade, and release press and focus.
void Visit::State::changed() {
  reworded();
  focused.clear();
  pressed.clear();
  page.reset();
}

void Visit::State::apply_pending_screen() {
  if (std::exchange(desk.turned, false) && !desk.next) changed();
  if (!desk.next) return;
  const ScreenId to = *desk.next;
  desk.next.reset();
  screen->let_go();
  if (desk.curated && to != ScreenId::decorate) {
    desk.curated_to_end = true;
    return;
  }
  over = Over::nothing;
  if (to == ScreenId::attract)
    desk.forget();
  else
    desk.notes.enter(to, desk.now);
  screen = kind_of(to).make(desk);
  changed();
}

void Visit::State::cover(Over what) {
  if (over == what) return;
  const bool closes = what == Over::nothing || (over == Over::languages && what == under_languages);
  // Touches that came while a slow machine drew the first frame were made before it was seen.
  uncovered = closes ? 2 : 0;
  calm_until = closed_until = 0;
  closed.clear();
  if (closes && over == Over::languages && page) closed = page->controls();
  over = what;
  if (what != Over::nothing) screen->let_go();
  changed();
}

void Visit::State::set_language(std::size_t index) {
  desk.language = index;
  reworded();
}

void Visit::State::press(const std::string& control) {
  if (press_language(control)) return;
  if (control == "help") return cover(Over::help);
  if (control == "comfort") return open_comfort();
  if (desk.comfort.press(control, desk.world.exhibit->screen)) {
    screen->comforted();
    return reworded();
  }
  if (control == "help.close" || control == "comfort.close" || control == "idle.stay" ||
      control == "leaving.close")
    return cover(Over::nothing);
  if (over == Over::nothing && desk.unkept() && screen->leaves_pot(control)) {
    leaving = control;
    return cover(Over::leaving);
  }
  if (control == "leaving.go") {
    desk.touched = false;
    cover(Over::nothing);
    return press(leaving);
  }
  if (control == "back")
    screen->back();
  else
    screen->press(control);
  apply_pending_screen();
}

/// Afterwards the visitor is where they were. A language may be tried before a visit begins.
void Visit::State::open_languages() {
  under_languages = over == Over::idle ? Over::nothing : over;
  cover(Over::languages);
}

bool Visit::State::press_language(const std::string& control) {
  if (control == "language" && over != Over::languages) return open_languages(), true;
  if (!control.starts_with("language")) return false;
  if (const auto language = language_of(desk, control)) set_language(*language);
  return cover(under_languages), true;
}

/// A new visitor asks for it: the choices last for the visit.
void Visit::State::open_comfort() {
  if (screen->id() == ScreenId::attract) {
    desk.go(ScreenId::choose);
    apply_pending_screen();
  }
  cover(Over::comfort);
}

std::string Visit::State::control_at(float x, float y) const {
  if (page)
    for (auto c = page->controls().rbegin(); c != page->controls().rend(); ++c)
      if (!c->by_keys && c->rect.contains(x, y)) return c->id;
  return {};
}

bool Visit::State::meant_for_closed(float x, float y) const {
  if (desk.now >= closed_until) return false;
  const auto was = std::ranges::find_if(
      closed, [&](const Control& c) { return !c.by_keys && c.rect.contains(x, y); });
  return was != closed.end() && was->id != control_at(x, y);
}

void Visit::State::pointer(const InputEvent& e) {
  using Kind = InputEvent::Kind;
  if (e.finger != 0) {
    // A second hand at the wheel, or two that turn and tilt a pot.
    const bool leaves = e.kind == Kind::pointer_up;
    if (screen->more_fingers() && over == Over::nothing && page && (pressed.empty() || leaves))
      screen->pointer(e, *page);
    return;
  }
  if (!screen->keys_are_anothers()) {
    by_keys = desk.by_keys = false;
    focused.clear();
  }
  // Nobody means what they have not seen yet.
  if (e.kind == Kind::pointer_down)
    swallowed = uncovered > 0 || desk.now < calm_until || meant_for_closed(e.x, e.y);
  if (swallowed) return;
  const std::string on = e.kind == Kind::pointer_down || e.kind == Kind::pointer_up
                             ? control_at(e.x, e.y)
                             : std::string();
  if (over == Over::idle) {
    // Any touch means "I am here". Apart from that, only the controls for legibility act.
    if (e.kind != Kind::pointer_down) return;
    swallowed = true;
    if (on == "language") open_languages();
    if (on == "comfort") open_comfort();
    return;
  }
  if (over == Over::nothing && page && screen->drag(e, *page)) {
    pressed.clear();
    return apply_pending_screen();
  }
  if (e.kind == Kind::pointer_down) {
    // The first touch always begins the visit, wherever it lands.
    if (screen->id() == ScreenId::attract && over == Over::nothing && on != "help" &&
        on != "comfort" && on != "language" && screen->begins_with(on)) {
      screen->begin(e);
      return apply_pending_screen();
    }
    pressed = on;
    if (!on.empty()) return over == Over::nothing ? screen->hold(on) : void();
  }
  if (e.kind == Kind::pointer_up && !pressed.empty()) {
    const std::string was = std::exchange(pressed, {});
    if (was == on) press(was);
    return;
  }
  if (over == Over::help) {
    if (e.kind == Kind::pointer_up) cover(Over::nothing);
    return;
  }
  // A near miss beside a switch of the Accessibility page must not close the page.
  if (over == Over::nothing && page && pressed.empty()) screen->pointer(e, *page);
  // The finger that began a screen lifted before that was laid out.
  if (!page && e.kind == InputEvent::Kind::pointer_up) screen->let_go();
  apply_pending_screen();
}

void Visit::State::key(const InputEvent& e) {
  by_keys = desk.by_keys = true;
  if (over == Over::idle) {
    if (e.key == Key::language) open_languages();
    if (e.key == Key::comfort) open_comfort();
    return;
  }
  if (e.key == Key::language && !e.repeat) return press("language");
  if (e.key == Key::comfort && !e.repeat)
    return press(over == Over::comfort ? "comfort.close" : "comfort");
  if (e.key == Key::help && !e.repeat) return press(over == Over::help ? "help.close" : "help");
  if (over == Over::languages && e.key == Key::back) return press("language.close");
  if (over != Over::nothing) {
    if (e.key == Key::back) return cover(Over::nothing);
  } else {
    if (screen->id() == ScreenId::attract && e.key != Key::back && e.key != Key::none &&
        e.key != Key::other && screen->begins_with({})) {
      screen->begin(e);
      return apply_pending_screen();
    }
    if (screen->key(e.key, e.repeat)) return apply_pending_screen();
    if (e.key == Key::back && !e.repeat) return press("back");
  }
  if (!page || page->controls().empty()) return;
  const auto in_order = [&](bool onward) {
    const std::vector<Control> all = in_reading_order(page->controls(), page->right_to_left());
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const Control& c) { return c.id == focused; });
    if (at == all.end()) return;
    const auto i = static_cast<std::size_t>(at - all.begin());
    focused = all[(i + (onward ? 1 : all.size() - 1)) % all.size()].id;
  };
  const auto step = [&](Direction to) {
    if (focused.empty()) return;
    const std::string known = over == Over::nothing ? screen->step(focused, to) : std::string();
    if (known.empty()) {
      focused = step_focus(page->controls(), focused, to);
    } else if (std::exchange(focused, known) != known) {
      page.reset();  // its control may be missing on this page
    }
  };
  switch (e.key) {
    case Key::up:
      return step(Direction::up);
    case Key::down:
      return step(Direction::down);
    case Key::left:
      return step(Direction::left);
    case Key::right:
      return step(Direction::right);
    case Key::next:
    case Key::previous:
      return in_order(e.key == Key::next);
    case Key::enter:
      if (!focused.empty() && !e.repeat) press(focused);
      return;
    default:
      return;
  }
}

/// The control where the keyboard starts; empty while the keys move the hand.
std::string Visit::State::first_control() const {
  return over == Over::help        ? "help.close"
         : over == Over::comfort   ? first_comfort()
         : over == Over::languages ? language_control(desk.words())
         : over == Over::leaving   ? "leaving.close"
         : over == Over::idle      ? "idle.stay"
                                   : screen->first_focus();
}

/// With keys in use something is always focused, unless the keys move the hand.
void Visit::State::keep_focus() {
  if (!by_keys) return focused.clear();
  const std::string first = first_control();
  if (first.empty()) return focused.clear();
  const auto is_there = [&](const std::string& id) {
    return page && std::any_of(page->controls().begin(), page->controls().end(),
                               [&](const Control& c) { return c.id == id; });
  };
  if (focused.empty() || (page && !is_there(focused)))
    focused = !page || is_there(first)   ? first
              : page->controls().empty() ? std::string()
                                         : page->controls().front().id;
}

Page Visit::State::lay_out(int width, int height, const GiveWay& gives) {
  const settings::Exhibit::Screen own = desk.screen();
  const TypeScale type = type_scale(own, width, height, gives);
  Regions home = regions(in_reach(own, width, height), type.margin, desk.mirrored(),
                         own.larger_text || gives.roomy);
  read_above(home, type.margin, gives.above);
  Page made(measuring, {width,
                        height,
                        type,
                        wanders ? moved(home, drift(desk.now, type.margin)) : home,
                        desk.words().code(),
                        {focused, pressed},
                        desk.words().right_to_left()});
  switch (over) {
    case Over::nothing:
      screen->lay_out(made);
      break;
    case Over::help:
      lay_out_help(made, desk, screen->help(), desk.say(screen->help_key() + "_keys"));
      break;
    case Over::comfort:
      lay_out_comfort(made, desk);
      break;
    case Over::languages:
      lay_out_languages(made, desk);
      break;
    case Over::leaving:
      lay_out_leaving(made, desk);
      break;
    case Over::idle:
      lay_out_idle(made, desk, idle.seconds_left(), idle.countdown());
      break;
  }
  return made;
}

/// If words do not fit, give up something, step by step. Keep that for this picture: sizes that
/// change with the words would flicker.
void Visit::State::lay_out_fitting(int width, int height) {
  const std::string stands_for =
      std::to_string(width) + 'x' + std::to_string(height) + (desk.mirrored() ? " mirrored" : "");
  // An overlay covers only its words. After a change of size the overlay places the pots.
  if (over != Over::nothing && stands_for != laid_out_for) {
    const Over covers = std::exchange(over, Over::nothing);
    lay_out_fitting(width, height);
    over = covers;
    tight_for.clear();
  }
  laid_out_for = stands_for;
  const std::string now_for = std::to_string(serial) + ' ' + std::to_string(width) + 'x' +
                              std::to_string(height) + desk.words().code();
  if (tight_for != now_for) tight = 0;
  tight_for = now_for;
  int again = 3;
  for (;;) {
    page = std::make_unique<Page>(lay_out(width, height, give_way(tight, desk.screen().low_reach)));
    // Decide nothing on a page with guessed sizes. The next frame continues here.
    if (measuring.spent()) return;
    if (page->restarted() && again-- > 0) continue;
    if (!page->overflow() || tight >= kLastGiveWay) return;
    ++tight;
  }
}

}  // namespace onggi::screens
