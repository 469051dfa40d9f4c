#include "kiosk/visit/screens/visit.h"

#include <algorithm>

#include "kiosk/picture/view/dark.h"
#include "kiosk/picture/view/high_contrast.h"
#include "kiosk/visit/screens/focus.h"
#include "kiosk/visit/screens/visit_state.h"

namespace onggi::screens {

using view::InputEvent;

namespace {
constexpr double kFade = 0.3;    // s
constexpr double kCalm = 0.4;    // s that a page which has closed still takes the touches
constexpr double kClosed = 1.5;  // s that a touch is still meant for what a closed page had there
constexpr double kLookedAway = 60.0;  // s that an overlay and another language stay on over attract
constexpr double kStepsToAct = 40, kStepsToStay = 10;  // times the switch's time for an item
constexpr double kDeviceMoved = 0.002;                 // m: more than a resting device trembles
}  // namespace

Visit::Visit(const VisitInputs& world) : state_(std::make_unique<State>(world)) {}
Visit::~Visit() = default;

void Visit::input(const InputEvent& event, double now) {
  State& s = *state_;
  s.desk.now = now;
  if (event.kind == InputEvent::Kind::resize || event.kind == InputEvent::Kind::close) return;
  s.idle.touched(now);
  const bool is_key =
      event.kind == InputEvent::Kind::key_down || event.kind == InputEvent::Kind::key_up;
  s.desk.notes.touch(is_key        ? NoteTaker::By::keys
                     : event.glass ? NoteTaker::By::glass
                                   : NoteTaker::By::mouse,
                     now);
  if (!is_key)
    s.pointer(event);
  else if (event.kind == InputEvent::Kind::key_down)
    s.key(event);
  if (s.over == Over::idle && event.kind != InputEvent::Kind::key_up) s.cover(Over::nothing);
  if (is_key) s.uncovered = 0;  // no finger is there that could touch twice
  s.apply_pending_screen();
}

void Visit::update(double now) {
  State& s = *state_;
  const double dt = s.updated_at < 0 ? 0.0 : std::clamp(now - s.updated_at, 0.0, 0.25);
  s.updated_at = s.desk.now = now;
  s.desk.look();

  // A moved device means that a visitor is there.
  const loop::LoopStatus& status = s.desk.status;
  for (std::size_t n = 0; n < s.device_at.size(); ++n) {
    const HandInput& hand = status.hands.hand[n];
    if (status.scripted || !hand.active) continue;
    if (length(hand.position - s.device_at[n]) <= kDeviceMoved) continue;
    s.device_at[n] = hand.position;
    s.idle.touched(now);
    if (status.hands_taken && s.desk.world.devices != nullptr)
      s.desk.notes.device(s.desk.world.devices->hand(), now);
    if (s.over == Over::idle) s.cover(Over::nothing);
  }

  s.screen->update(dt);
  const bool taken_now = status.hands_taken;
  const ScreenId id = s.screen->id();
  if (s.desk.curated) {
    s.idle.touched(now);
  } else if (id == ScreenId::attract) {
    s.idle.touched(now);
    // Taking a device begins a visit. Still leaning on one from the last visit does not.
    if (status.hands_taken && !s.hands_taken) s.desk.go(ScreenId::choose);
    if (now - s.changed_at > kLookedAway) {
      if (s.over == Over::help || s.over == Over::languages) s.cover(Over::nothing);
      if (s.desk.language != 0) s.set_language(0);
    }
  } else {
    const auto& wait = s.desk.world.exhibit->idle;
    const bool reading = kind_of(id).reads_long;
    // A visitor with one switch steps through everything and needs more time.
    const settings::Exhibit::Screen own = s.desk.screen();
    const double step = own.one_switch ? own.scan_seconds : 0.0;
    switch (s.idle.look(now, (reading ? wait.result_after : wait.warn_after) + kStepsToAct * step,
                        wait.countdown + kStepsToStay * step)) {
      case IdleWatch::Word::none:
        break;
      case IdleWatch::Word::warn:
        s.cover(Over::idle);
        break;
      case IdleWatch::Word::over:
        s.desk.leaves = VisitNotes::End::idle;
        s.desk.go(ScreenId::attract);
        break;
    }
  }
  s.hands_taken = taken_now;
  s.apply_pending_screen();
}

view::Frame Visit::frame(int width, int height) {
  State& s = *state_;
  s.measuring.begin_frame();
  s.keep_focus();
  s.lay_out_fitting(width, height);
  if (s.uncovered > 0 && --s.uncovered == 0) {
    s.calm_until = s.desk.now + kCalm;
    s.closed_until = s.desk.now + kClosed;
  }
  const std::string was = s.focused;
  s.keep_focus();
  if (s.focused != was) s.lay_out_fitting(width, height);

  view::Frame frame;
  frame.width = width;
  frame.height = height;
  frame.pot = s.screen->pot(*s.page);
  if (frame.pot && s.over != Over::nothing) frame.pot->opacity *= 0.12;
  frame.items = std::move(s.page->items());
  if (s.screen->dark())
    view::to_dark(frame.items, width, height);
  else if (s.desk.screen().high_contrast)
    view::to_high_contrast(frame.items);
  frame.screen_serial = s.serial;
  const double since = (s.desk.now - s.changed_at) / kFade;
  if (!s.desk.still() && since < 1) frame.fade = static_cast<float>(1 - std::max(0.0, since));
  return frame;
}

std::optional<Request> Visit::take_request() {
  std::deque<Request>& queue = state_->desk.requests;
  if (queue.empty()) return std::nullopt;
  // Copied: g++ 12 warns that a moved variant may be uninitialised.
  std::optional<Request> first(queue.front());
  queue.pop_front();
  return first;
}

void Visit::wander() { state_->wanders = true; }

void Visit::show_postcard(view::PictureId id) {
  if (state_->desk.kept == Desk::Kept::not_asked) return;  // the visitor has left
  state_->desk.postcard = id;
  state_->reworded();
}

void Visit::keepsake_kept(const std::string& name, const std::string& page,
                          const std::string& folder) {
  if (state_->desk.kept != Desk::Kept::asked) return;
  state_->desk.kept = Desk::Kept::kept;
  state_->desk.kept_as = name;
  state_->desk.kept_at = page;
  state_->desk.kept_in = folder;
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
  state_->apply_pending_screen();
}

void Visit::decorate(int card, const Profile& pot, double now) {
  Desk& desk = state_->desk;
  desk.now = now;
  desk.requests.clear();  // attract's
  desk.card = card;
  desk.made = pot;
  desk.curated = true;
  if (desk.pot_to_decorate() == nullptr) return;
  desk.go(ScreenId::decorate);
  state_->apply_pending_screen();
}

bool Visit::has_decorated() const { return state_->desk.curated_to_end; }

void Visit::close(double now) {
  if (state_->screen->id() == ScreenId::attract) return;
  state_->desk.now = now;
  state_->desk.leaves = VisitNotes::End::closed;
  state_->desk.go(ScreenId::attract);
  state_->apply_pending_screen();
}

ScreenId Visit::screen() const { return state_->screen->id(); }
bool Visit::idle_warning() const { return state_->over == Over::idle; }
const std::string& Visit::language() const { return state_->desk.words().code(); }
void Visit::speak(const std::string& code) {
  const auto& all = *state_->desk.world.languages;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].code() == code) state_->set_language(i);
}
const decorating::DecoratedPot* Visit::decorated_pot() const {
  return state_->desk.decorated.get();
}

const decoration::CoatPicture* Visit::decoration() const {
  const ScreenId on = screen();
  const bool shown = on == ScreenId::result || on == ScreenId::decorate || on == ScreenId::kiln ||
                     on == ScreenId::keepsake;
  const auto& pot = state_->desk.decorated;
  return shown && pot && (!pot->plain() || pot->shows_example()) ? &pot->picture() : nullptr;
}

double Visit::force_share() const { return state_->desk.force.share(); }
double Visit::volume_share() const {
  const Desk& desk = state_->desk;
  return static_cast<double>(desk.comfort.volume(desk.world.exhibit->screen)) / Comfort::kLoudest;
}
settings::Exhibit::Screen Visit::shown_on() const { return state_->desk.screen(); }
const score::Score& Visit::score() const { return state_->desk.score; }

std::vector<std::pair<std::string, view::Rect>> Visit::controls() const {
  std::vector<std::pair<std::string, view::Rect>> all;
  if (state_->page)
    for (const Control& c : state_->page->controls()) all.emplace_back(c.id, c.rect);
  return all;
}

ScreenText Visit::reading() const {
  const State& s = *state_;
  ScreenText r;
  r.screen = s.screen->id();
  r.over = s.over == Over::help        ? "help"
           : s.over == Over::comfort   ? "comfort"
           : s.over == Over::languages ? "languages"
           : s.over == Over::leaving   ? "leaving"
           : s.over == Over::idle      ? "idle"
                                       : "";
  r.language = &s.desk.words();
  if (s.page) {
    r.words = s.page->told();
    r.controls = in_reading_order(s.page->controls(), s.page->right_to_left());
  }
  r.first = s.first_control();
  r.focus = s.focused;
  const settings::Exhibit::Screen shown = s.desk.screen();
  r.spoken = spoken();
  r.unasked = !shown.spoken;
  r.one_switch = shown.one_switch;
  r.scan_seconds = shown.scan_seconds;
  if (s.over == Over::nothing)
    if (auto pot = s.screen->told()) {
      r.working = pot->working;
      r.asked = pot->asked;
      r.differences = std::move(pot->differences);
    }
  return r;
}

bool Visit::works(const InputEvent& event) const {
  return state_->over == Over::nothing && state_->screen->works(event);
}

bool Visit::spoken() const { return state_->desk.screen().spoken || state_->screen->dark(); }

void Visit::activate(const std::string& control, double now) {
  State& s = *state_;
  s.desk.now = now;
  s.idle.touched(now);
  s.desk.notes.touch(NoteTaker::By::keys, now);
  s.by_keys = !s.desk.screen().one_switch;  // it has its own ring
  if (!control.empty()) s.press(control);
  s.uncovered = 0;
  s.apply_pending_screen();
}

void Visit::focus_on(const std::string& control, double now) {
  State& s = *state_;
  s.desk.now = now;
  s.idle.touched(now);
  s.by_keys = true;
  s.focused = control;
}

std::optional<WheelSnapshot> Visit::sight() const { return state_->screen->sight(); }

const std::string& Visit::focus() const { return state_->focused; }

std::optional<view::Rect> Visit::control(const std::string& id) const {
  if (state_->page)
    for (const Control& c : state_->page->controls())
      if (c.id == id) return c.rect;
  return std::nullopt;
}

}  // namespace onggi::screens
