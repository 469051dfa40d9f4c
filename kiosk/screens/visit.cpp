#include "kiosk/screens/visit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/screens/focus.h"
#include "kiosk/screens/idle.h"
#include "kiosk/screens/screen.h"

namespace onggi::screens {

using view::InputEvent;
using view::Key;

std::string_view name_of(ScreenId id) {
  switch (id) {
    case ScreenId::attract:
      return "attract";
    case ScreenId::choose:
      return "choose";
    case ScreenId::throwing:
      return "throw";
    case ScreenId::result:
      return "result";
    case ScreenId::keepsake:
      return "keepsake";
    case ScreenId::fault:
      return "fault";
  }
  return "";
}

namespace {
constexpr double kFade = 0.3;           // s
constexpr double kDeviceMoved = 0.002;  // m: more than a device at rest trembles.
enum class Over { nothing, help, idle };

std::unique_ptr<Screen> make_screen(ScreenId id, Desk& desk) {
  switch (id) {
    case ScreenId::choose:
      return make_choose(desk);
    case ScreenId::throwing:
      return make_throwing(desk);
    case ScreenId::result:
      return make_result(desk);
    case ScreenId::keepsake:
      return make_keepsake(desk);
    case ScreenId::fault:
      return make_fault(desk);
    case ScreenId::attract:
      break;
  }
  return make_attract(desk);
}
}  // namespace

struct Visit::State {
  explicit State(const VisitWorld& world)
      : desk(world), measuring(*world.measure), screen(make_attract(desk)) {}

  Desk desk;
  Measuring measuring;
  std::unique_ptr<Screen> screen;
  std::unique_ptr<Page> page;  ///< The one last shown.
  IdleWatch idle;
  Over over = Over::nothing;
  bool by_keys = false;
  std::string focused, pressed;
  std::uint64_t serial = 1;
  double changed_at = -10, updated_at = -1;
  float shrink = 1;
  std::string shrunk_for;
  Vec3 device_at;

  void reworded();
  void changed();
  void settle();
  void cover(Over what);
  void set_language(std::size_t index);
  void press(const std::string& control);
  void pointer(const InputEvent& e);
  void key(const InputEvent& e);
  void keep_focus();
  std::string control_at(float x, float y) const;
  Page lay_out(int width, int height, float size);
  void lay_out_fitting(int width, int height);
};

/// The words change where they stand: cross-fade.
void Visit::State::reworded() {
  ++serial;
  changed_at = desk.now;
}

/// The picture changes to another: cross-fade, and nothing stays pressed or focused.
void Visit::State::changed() {
  reworded();
  focused.clear();
  pressed.clear();
  page.reset();
}

void Visit::State::settle() {
  if (std::exchange(desk.turned, false) && !desk.next) changed();
  if (!desk.next) return;
  const ScreenId to = *desk.next;
  desk.next.reset();
  screen->let_go();
  over = Over::nothing;
  if (to == ScreenId::attract) desk.forget();
  screen = make_screen(to, desk);
  changed();
}

void Visit::State::cover(Over what) {
  if (over == what) return;
  over = what;
  if (what != Over::nothing) screen->let_go();
  changed();
}

void Visit::State::set_language(std::size_t index) {
  desk.language = index;
  reworded();
}

void Visit::State::press(const std::string& control) {
  if (const auto language = language_of(desk, control)) return set_language(*language);
  if (control == "help") return cover(Over::help);
  if (control == "help.close" || control == "idle.stay") return cover(Over::nothing);
  if (control == "back")
    screen->back();
  else
    screen->press(control);
  settle();
}

std::string Visit::State::control_at(float x, float y) const {
  if (page)
    for (auto c = page->controls().rbegin(); c != page->controls().rend(); ++c)
      if (c->rect.contains(x, y)) return c->id;
  return {};
}

void Visit::State::pointer(const InputEvent& e) {
  using Kind = InputEvent::Kind;
  by_keys = false;
  focused.clear();
  const std::string on = e.kind == Kind::pointer_down || e.kind == Kind::pointer_up
                             ? control_at(e.x, e.y)
                             : std::string();
  if (over == Over::idle) {
    // Any touch says "I am here"; only the language is worth hearing besides.
    if (e.kind == Kind::pointer_down && language_of(desk, on)) set_language(*language_of(desk, on));
    return;
  }
  if (e.kind == Kind::pointer_down) {
    // The first touch is never lost: wherever it lands, the visit begins.
    if (screen->id() == ScreenId::attract && over == Over::nothing && on != "help" &&
        !language_of(desk, on)) {
      desk.go(ScreenId::choose);
      return settle();
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
  if (page && pressed.empty()) screen->pointer(e, *page);
  settle();
}

void Visit::State::key(const InputEvent& e) {
  by_keys = true;
  if (over == Over::idle) {
    if (e.key == Key::language) set_language(*language_of(desk, "language"));
    return;
  }
  if (e.key == Key::language && !e.repeat) return press("language");
  if (e.key == Key::help && !e.repeat) return press(over == Over::help ? "help.close" : "help");
  if (over == Over::help) {
    if (e.key == Key::back) return press("help.close");
  } else {
    if (screen->id() == ScreenId::attract && e.key != Key::back && e.key != Key::none) {
      desk.go(ScreenId::choose);
      return settle();
    }
    if (screen->key(e.key, e.repeat)) return settle();
    if (e.key == Key::back && !e.repeat) return press("back");
  }
  if (!page || page->controls().empty()) return;
  const auto step = [&](Direction to) {
    if (!focused.empty()) focused = step_focus(page->controls(), focused, to);
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
    case Key::enter:
      if (!focused.empty() && !e.repeat) press(focused);
      return;
    default:
      return;
  }
}

/// While keys are used something is always focused, unless the keys move the hand.
void Visit::State::keep_focus() {
  if (!by_keys) return focused.clear();
  const std::string first = over == Over::help   ? "help.close"
                            : over == Over::idle ? "idle.stay"
                                                 : screen->first_focus();
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

Page Visit::State::lay_out(int width, int height, float size) {
  const TypeScale type = type_scale(desk.screen(), width, height, size);
  Page made(measuring, {width,
                        height,
                        type,
                        regions(width, height, type.margin, desk.mirrored()),
                        desk.words().code(),
                        {focused, pressed}});
  switch (over) {
    case Over::nothing:
      screen->lay_out(made);
      break;
    case Over::help:
      lay_out_help(made, desk, screen->help_key());
      break;
    case Over::idle:
      lay_out_idle(made, desk, idle.seconds_left());
      break;
  }
  return made;
}

/// Words that do not fit are set smaller, a step at a time, and then stay so while this picture
/// lasts: sizes that come and go with the words would flicker.
void Visit::State::lay_out_fitting(int width, int height) {
  const std::string now_for = std::to_string(serial) + ' ' + std::to_string(width) + 'x' +
                              std::to_string(height) + desk.words().code();
  if (shrunk_for != now_for) shrink = 1.0f;
  shrunk_for = now_for;
  constexpr float kStep = 0.94f, kLeast = 0.4f;
  int again = 3;
  for (;;) {
    page = std::make_unique<Page>(lay_out(width, height, shrink));
    if (page->restarted() && again-- > 0) continue;
    if (!page->overflow() || shrink < kLeast) return;
    shrink *= kStep;
  }
}

Visit::Visit(const VisitWorld& world) : state_(std::make_unique<State>(world)) {}
Visit::~Visit() = default;

void Visit::input(const InputEvent& event, double now) {
  State& s = *state_;
  s.desk.now = now;
  if (event.kind == InputEvent::Kind::resize || event.kind == InputEvent::Kind::close) return;
  s.idle.touched(now);
  const bool is_key =
      event.kind == InputEvent::Kind::key_down || event.kind == InputEvent::Kind::key_up;
  if (!is_key)
    s.pointer(event);
  else if (event.kind == InputEvent::Kind::key_down)
    s.key(event);
  if (s.over == Over::idle && event.kind != InputEvent::Kind::key_up) s.cover(Over::nothing);
  s.settle();
}

void Visit::update(double now, const loop::LoopStatus& status) {
  State& s = *state_;
  const double dt = s.updated_at < 0 ? 0.0 : std::clamp(now - s.updated_at, 0.0, 0.25);
  s.updated_at = s.desk.now = now;
  s.desk.look_at(status);

  // A device that is moved is a visitor who is there.
  const HandInput& hand = status.hands.hand[0];
  if (!status.scripted && hand.active && length(hand.position - s.device_at) > kDeviceMoved) {
    s.device_at = hand.position;
    s.idle.touched(now);
    if (s.over == Over::idle) s.cover(Over::nothing);
  }

  s.screen->update(dt);
  const ScreenId id = s.screen->id();
  if (id == ScreenId::attract) {
    s.idle.touched(now);
    if (s.over == Over::help && now - s.changed_at > 60.0) s.cover(Over::nothing);
  } else {
    const auto& wait = s.desk.world.exhibit->idle;
    const bool reading = id == ScreenId::result || id == ScreenId::keepsake;
    switch (s.idle.look(now, reading ? wait.result_after : wait.warn_after, wait.countdown)) {
      case IdleWatch::Word::none:
        break;
      case IdleWatch::Word::warn:
        s.cover(Over::idle);
        break;
      case IdleWatch::Word::over:
        s.desk.go(ScreenId::attract);
        break;
    }
  }
  s.settle();
}

view::Frame Visit::frame(int width, int height) {
  State& s = *state_;
  s.keep_focus();
  s.lay_out_fitting(width, height);
  const std::string was = s.focused;
  s.keep_focus();
  if (s.focused != was) s.lay_out_fitting(width, height);

  view::Frame frame;
  frame.width = width;
  frame.height = height;
  frame.pot = s.screen->pot(*s.page);
  if (frame.pot && s.over != Over::nothing) frame.pot->opacity *= 0.12;
  frame.items = std::move(s.page->items());
  frame.screen_serial = s.serial;
  const double since = (s.desk.now - s.changed_at) / kFade;
  if (!s.desk.still() && since < 1) frame.fade = static_cast<float>(1 - std::max(0.0, since));
  return frame;
}

std::optional<Request> Visit::take_request() {
  std::deque<Request>& queue = state_->desk.requests;
  if (queue.empty()) return std::nullopt;
  // Copied: g++ 12 takes a moved variant for uninitialised.
  std::optional<Request> first(queue.front());
  queue.pop_front();
  return first;
}

void Visit::show_postcard(view::PictureId id) {
  if (state_->desk.kept == Desk::Kept::not_asked) return;  // The visitor has gone.
  state_->desk.postcard = id;
  state_->reworded();
}

void Visit::keepsake_kept(const std::string& file) {
  if (state_->desk.kept != Desk::Kept::asked) return;
  state_->desk.kept = Desk::Kept::kept;
  state_->desk.kept_as = file;
  state_->reworded();
}

void Visit::keepsake_failed(const Problem&) {
  if (state_->desk.kept != Desk::Kept::asked) return;
  state_->desk.kept = Desk::Kept::failed;
  state_->reworded();
}

void Visit::fail(const Problem&) {
  if (state_->screen->id() == ScreenId::fault) return;
  state_->desk.go(ScreenId::fault);
  state_->settle();
}

ScreenId Visit::screen() const { return state_->screen->id(); }
bool Visit::idle_warning() const { return state_->over == Over::idle; }
const std::string& Visit::language() const { return state_->desk.words().code(); }

const std::string& Visit::focus() const { return state_->focused; }

std::optional<view::Rect> Visit::control(const std::string& id) const {
  if (state_->page)
    for (const Control& c : state_->page->controls())
      if (c.id == id) return c.rect;
  return std::nullopt;
}

}  // namespace onggi::screens
