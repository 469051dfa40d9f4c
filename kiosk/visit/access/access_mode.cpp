#include "kiosk/visit/access/access_mode.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/picture/view/palette.h"

namespace onggi::access {

using screens::ScreenId;
using screens::Visit;
using view::InputEvent;
using view::Key;
using Kind = InputEvent::Kind;

namespace {

constexpr double kStill = 10.0;   // mm that a held finger may move
constexpr double kCorner = 25.0;  // mm: side of the corner of the screen that answers a touch

std::string control_at(const Visit& visit, float x, float y) {
  const auto all = visit.controls();
  for (auto c = all.rbegin(); c != all.rend(); ++c)
    if (c->second.contains(x, y)) return c->first;
  return {};
}

/// A dark ring inside a light one, visible on any background.
void ring(view::Frame& frame, const view::Rect& rect, float px) {
  const auto around = [&](float out, float line, view::Color color) {
    frame.items.push_back(
        view::Box{{rect.x - out, rect.y - out, rect.w + 2 * out, rect.h + 2 * out},
                  out,
                  {0, 0, 0, 0},
                  line,
                  color});
  };
  around(2.6f * px, 0.8f * px, view::kPlaster);
  around(1.9f * px, 1.5f * px, view::kInk);
  around(0.5f * px, 0.5f * px, view::kPlaster);
}

}  // namespace

void AccessMode::watch_hold(const InputEvent& event, const Visit& visit, double px_per_mm,
                            double now) {
  const bool key = event.kind == Kind::key_down || event.kind == Kind::key_up;
  if (event.kind == Kind::key_up || event.kind == Kind::pointer_up) {
    if (held_ && held_->key == key) held_.reset();
  } else if (event.kind == Kind::pointer_move && held_ && !held_->key) {
    if (std::hypot(event.x - held_->x, event.y - held_->y) > kStill * px_per_mm) held_.reset();
  } else if ((event.kind == Kind::pointer_down && event.finger == 0) ||
             (event.kind == Kind::key_down && !event.repeat)) {
    // What stays down on the clay is working.
    const bool one_switch = visit.shown_on().one_switch && visit.screen() != ScreenId::attract;
    if (hold_ > 0 && !one_switch && !visit.works(event)) held_ = Hold{now, event.x, event.y, key};
  }
}

/// Turns speech on, and after a longer hold the one switch.
void AccessMode::held(Visit& visit, double now) {
  if (!held_) return;
  const auto shown = visit.shown_on();
  if (held_->reached == 0 && now - held_->since >= hold_) {
    held_->reached = 1;
    if (!shown.spoken) visit.activate("comfort.spoken", now);
    narrator_.hold_on();
  } else if (held_->reached == 1 && now - held_->since >= 2 * hold_) {
    held_->reached = 2;
    if (!shown.one_switch) visit.activate("comfort.one_switch", now);
  }
}

void AccessMode::press_switch(Visit& visit, double now) {
  const screens::ScreenText reading = visit.reading();
  if (reading.over == "idle") return visit.activate("idle.stay", now);
  const auto chosen = scan_.press(reading, now);
  visit.activate(chosen.value_or(""), now);
}

void AccessMode::ask(Visit& visit, double now) {
  if (visit.screen() == ScreenId::throwing && visit.sight())
    return visit.activate("throw.tell", now);
  narrator_.again();
  visit.activate("", now);
}

/// Speaks the control under a finger. A second touch that lifts on it chooses it.
void AccessMode::explore(const InputEvent& event, Visit& visit, double px_per_mm, double now) {
  if (on_pot_ || event.finger != 0) {
    if (event.kind == Kind::pointer_up && event.finger == 0) on_pot_ = false;
    return visit.input(event, now);
  }
  const std::string on = control_at(visit, event.x, event.y);
  switch (event.kind) {
    case Kind::pointer_down: {
      if (visit.idle_warning()) return visit.activate("idle.stay", now);
      armed_ = on == explored_ ? on : std::string();
      explored_ = on;
      if (!on.empty()) return visit.focus_on(on, now);
      const auto corner = static_cast<float>(kCorner * px_per_mm);
      if (event.x < corner && event.y < corner) return ask(visit, now);
      on_pot_ = visit.sight().has_value();
      return on_pot_ ? visit.input(event, now) : visit.activate("", now);
    }
    case Kind::pointer_move:
      if (on == visit.focus() || on.empty() || !event.glass) return;
      armed_.clear();
      explored_ = on;
      return visit.focus_on(on, now);
    case Kind::pointer_up:
      if (const std::string was = std::exchange(armed_, {}); !was.empty() && was == on) {
        explored_.clear();  // its replacement must be heard first
        visit.activate(was, now);
      }
      return;
    default:
      return;
  }
}

void AccessMode::input(const InputEvent& event, Visit& visit, double px_per_mm, double now) {
  const auto shown = visit.shown_on();
  const bool attract = visit.screen() == ScreenId::attract;
  watch_hold(event, visit, px_per_mm, now);
  if (attract) return visit.input(event, now);
  const bool pressed =
      event.kind == Kind::pointer_down || (event.kind == Kind::key_down && !event.repeat);
  if (shown.one_switch) {
    if (!pressed || held_) return;
    // Whoever turned it on by mistake turns it off at the same place.
    const bool off = event.kind == Kind::pointer_down &&
                     control_at(visit, event.x, event.y) == "comfort.one_switch";
    return off ? visit.activate("comfort.one_switch", now) : press_switch(visit, now);
  }
  const bool key = event.kind == Kind::key_down || event.kind == Kind::key_up;
  if (event.kind == Kind::key_down && event.key == Key::tell && !event.repeat) {
    if (!shown.spoken) return visit.activate("comfort.spoken", now);
    return ask(visit, now);
  }
  // The finger that was held for this presses nothing when it lifts.
  if (!key && shown.spoken && !(held_ && held_->reached > 0))
    return explore(event, visit, px_per_mm, now);
  if (!key && shown.spoken) return;
  visit.input(event, now);
}

void AccessMode::look(Visit& visit, view::Frame& frame, double now) {
  held(visit, now);
  const auto shown = visit.shown_on();
  if (!shown.one_switch) scan_.restart();
  if (!shown.one_switch && !shown.spoken) {
    armed_.clear();
    explored_.clear();
    on_pot_ = false;
  }
  const bool attract = visit.screen() == ScreenId::attract;
  const screens::ScreenText reading =
      shown.one_switch || visit.spoken() ? visit.reading() : screens::ScreenText{};
  if (shown.one_switch && !attract) {
    scan_.look(reading, now);
    const float px = static_cast<float>(std::min(frame.width, frame.height)) / 360.0f;
    view::Rect all;
    for (const std::string& id : scan_.shown())
      if (const auto rect = visit.control(id)) {
        if (all.w <= 0) all = *rect;
        const float right = std::max(all.x + all.w, rect->x + rect->w);
        const float foot = std::max(all.y + all.h, rect->y + rect->h);
        all.x = std::min(all.x, rect->x);
        all.y = std::min(all.y, rect->y);
        all.w = right - all.x;
        all.h = foot - all.y;
      }
    if (all.w > 0) ring(frame, all, px);
  }
  static const std::vector<std::string> kNothing;
  if (auto said = narrator_.look(reading, shown.one_switch ? scan_.shown() : kNothing, now))
    next_ = std::move(said);
  const int before = std::exchange(asked_, reading.asked);
  song_waits_ = (song_waits_ || reading.asked > before) && !reading.working &&
                reading.screen == ScreenId::throwing;
  if (song_waits_ && !narrator_.speaks(now)) {
    song_waits_ = false;
    sings_ = true;
  }
}

std::optional<Utterance> AccessMode::take() { return std::exchange(next_, std::nullopt); }

}  // namespace onggi::access
