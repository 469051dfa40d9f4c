#include "tests/pages/every_screen.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/script/script.h"
#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/exhibit/rehearsal/touch_at.h"

namespace onggi::pages {

namespace {

constexpr int kScreenTicks = 40;                 // a frame
constexpr double kFrame = 0.001 * kScreenTicks;  // s
constexpr double kSettled = 1.5;                 // s: cross-fades and easing are over
constexpr double kLongestWait = 400.0;  // s in which attract's pot has to be done, or a script

class Looker {
 public:
  Looker(exhibit::Kiosk& kiosk, const LookAtScreen& look) : kiosk_(kiosk), look_(look) {}

  bool good() const { return good_.has_value(); }
  Result<void> result() const { return good_; }

  void frames(double seconds) {
    for (double until = now_ + seconds; good() && now_ < until;) frame();
  }
  template <class Done>
  void until(const char* what, const Done& done, bool here = true) {
    for (const double last = now_ + kLongestWait; good() && !done();) {
      // Who works at the wheel is there.
      view::InputEvent moved;
      moved.kind = view::InputEvent::Kind::pointer_move;
      if (here) kiosk_.visit().input(moved, now_);
      frame();
      if (now_ > last) fail(what);
    }
  }
  void touch(const std::string& control) {
    frames(2 * kFrame);
    while (const auto way = rehearsal::way_to(kiosk_.visit(), control)) {
      rehearsal::touch_at(kiosk_.visit(), way->x + way->w / 2, way->y + way->h / 2, now_);
      frames(kSettled);
    }
    const auto rect = kiosk_.visit().control(control);
    if (good() && !rect) return fail(control);
    if (rect)
      rehearsal::touch_at(kiosk_.visit(), rect->x + rect->w / 2, rect->y + rect->h / 2, now_);
  }
  void press_clay() {
    const auto& pot = kiosk_.shown().pot;
    const auto at = pot ? pot->camera.project({0, 0.05, 0}) : std::nullopt;
    if (!at) return fail("attract's pot");
    rehearsal::touch_at(kiosk_.visit(), at->first, at->second, now_);
  }
  bool has(const std::string& control) const { return kiosk_.visit().control(control).has_value(); }
  /// Waits until all stands, and looks.
  void look(const std::string& state) {
    frames(kSettled);
    look_now(state);
  }
  void look_now(const std::string& state) {
    if (good()) good_ = look_(state);
    // What was laid out last was another size.
    frames(2 * kFrame);
  }
  void over(const std::string& control, const std::string& state) {
    touch(control);
    look(state);
    touch(control + ".close");
    frames(kSettled);  // for a moment it still takes the touches
  }
  bool says(const std::string& words) const {
    for (const view::Item& item : kiosk_.shown().items)
      if (const auto* text = std::get_if<view::Text>(&item); text && text->text == words)
        return text->color.a >= 1;
    return false;
  }

 private:
  void frame() {
    kiosk_.advance(kScreenTicks);
    kiosk_.frame(now_ += kFrame, false);
    // A save runs on a worker, at its own pace.
    if (kiosk_.doing().saving) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  void fail(const std::string& what) {
    good_ = problem("screen " + std::string(screens::name_of(kiosk_.visit().screen())),
                    "Looking at every screen, " + what + " was not found.",
                    "This is a fault of the program: please report it.", 1);
  }

  exhibit::Kiosk& kiosk_;
  const LookAtScreen& look_;
  Result<void> good_;
  double now_ = 0;
};

/// The hands of a script throw at `target` until the pot is half there.
void throw_half(exhibit::Kiosk& kiosk, Looker& looker, const Profile& target) {
  auto script = make_script("follow", {kiosk.doing().pot, &target, 1, 1.0});
  if (!script) return;
  kiosk.wheel_host().play(std::move(*script));
  looker.until("half a pot", [&] { return kiosk.wheel_host().status().script_progress > 0.45; });
}

void look_into_drawers(Looker& looker, const std::string& name) {
  for (const char* drawer : {"tools", "wheel"}) {
    looker.touch(std::string("throw.") + drawer);
    looker.look(name + " " + drawer);
    looker.touch("throw.less");
  }
}

void throw_pot(exhibit::Kiosk& kiosk, Looker& looker, int card) {
  looker.look("throw begin");
  throw_half(kiosk, looker, kiosk.shelf().cards()[static_cast<std::size_t>(card)].target);
  looker.look_now("throw");
  look_into_drawers(looker, "throw");
  looker.over("help", "throw help");
  looker.until("the end of the script", [&] { return kiosk.wheel_host().status().script_done; });
  looker.touch("throw.done");
}

/// From the result to the gallery of what was kept.
void keep_pot(exhibit::Kiosk& kiosk, Looker& looker, const std::string& name) {
  looker.touch("result.keep");
  if (kiosk.visit().screen() == screens::ScreenId::kiln) {
    looker.touch("kiln.glaze.0");
    looker.frames(12);
    looker.look_now(name + " kiln");
    looker.touch("kiln.keep");
  }
  looker.until("the keepsake", [&] { return kiosk.doing().kept && kiosk.doing().kept->saved; });
  looker.look(name + " keepsake");
  if (!looker.has("keepsake.gallery")) return;
  looker.touch("keepsake.gallery");
  looker.look(name + " gallery");
  looker.touch("back");
  looker.frames(kSettled);
}

using MissionKind = settings::Mission::Kind;

std::string name_of_kind(MissionKind kind) {
  switch (kind) {
    case MissionKind::today:
      return "today";
    case MissionKind::describe:
      return "described";
    case MissionKind::eyes_closed:
      return "eyes closed";
    case MissionKind::two_hands:
      return "two hands";
  }
  return {};
}

void look_at_mission(exhibit::Kiosk& kiosk, Looker& looker, std::size_t n) {
  const MissionKind kind = kiosk.missions().cards()[n].mission->kind;
  const std::string name = name_of_kind(kind), card = "choose.mission." + std::to_string(n);
  while (looker.good() && !looker.has(card) && looker.has("choose.next")) {
    looker.touch("choose.next");
    looker.frames(kSettled);
  }
  looker.touch(card);
  looker.look(name + " label");
  looker.touch("choose.throw");
  looker.look(name + " begin");
  if (!looker.good()) return;
  throw_half(kiosk, looker, kiosk.card(kiosk.doing().card)->target);
  if (kind != MissionKind::today) {
    looker.look_now(name);
    look_into_drawers(looker, name);
  }
  if (kind == MissionKind::eyes_closed) {
    looker.over("help", name + " help");
    looker.over("comfort", name + " comfort");
  }
  // Half a pot, so that there is a difference to tell.
  looker.touch("throw.done");
  looker.look(name + " result");
}

}  // namespace

Result<void> look_at_every_screen(exhibit::Kiosk& kiosk, int card, const LookAtScreen& look) {
  Looker looker(kiosk, look);
  const std::string shown = "choose.card." + std::to_string(card);
  looker.frames(20);
  looker.look_now("attract");
  looker.over("help", "attract help");
  looker.over("language", "languages");
  const auto& label = [&] {
    return kiosk.shelf()
        .cards()[static_cast<std::size_t>(std::max(0, kiosk.doing().card))]
        .vessel->label(kiosk.visit().language())
        .title;
  };
  looker.until("the name of attract's vessel", [&] { return looker.says(label()); });
  looker.look_now("attract name");
  looker.press_clay();
  looker.look("clay");
  looker.touch("back");
  looker.frames(kSettled);
  looker.touch("attract.begin");
  looker.look("choose");
  if (looker.has("choose.next")) {
    looker.touch("choose.next");
    looker.look("choose on");
    looker.touch("choose.previous");
    looker.frames(kSettled);
  }
  looker.over("comfort", "comfort");
  while (looker.good() && !looker.has(shown)) {
    looker.touch("choose.next");
    looker.frames(kSettled);
  }
  looker.touch(shown);
  looker.look("label");
  looker.touch("choose.throw");
  throw_pot(kiosk, looker, card);
  looker.look("result");
  looker.over("help", "result help");
  looker.touch("result.other");
  looker.look("leaving");
  looker.touch("leaving.close");
  looker.frames(kSettled);
  looker.touch("result.keep");
  if (kiosk.visit().screen() == screens::ScreenId::kiln) {
    looker.look("kiln");
    looker.touch("kiln.glaze.0");
    looker.frames(3.6);
    looker.look_now("kiln firing");
    looker.frames(6);
    looker.look_now("kiln fired");
    looker.touch("kiln.keep");
  }
  looker.frames(2 * kFrame);
  looker.look_now("keepsake waiting");
  looker.until("the keepsake", [&] { return kiosk.doing().kept && kiosk.doing().kept->saved; });
  looker.look("keepsake");
  if (looker.has("keepsake.gallery")) {
    looker.touch("keepsake.gallery");
    looker.look("gallery");
    looker.touch("back");
    looker.frames(kSettled);
  }
  looker.until(
      "the question", [&] { return kiosk.visit().idle_warning(); }, false);
  looker.look("idle");
  looker.touch("idle.stay");
  looker.frames(kSettled);
  looker.touch("keepsake.done");
  looker.look("thanks");
  looker.touch("keepsake.done");
  looker.look("attract again");
  if (looker.good()) kiosk.visit().fail({"every screen", "It is looked at.", "", 1});
  looker.look("fault");
  return looker.result();
}

Result<void> look_at_every_mission(exhibit::Kiosk& kiosk, const LookAtScreen& look) {
  Looker looker(kiosk, look);
  looker.frames(5);
  const std::size_t missions = kiosk.missions().cards().size();
  if (missions == 0)
    return problem("missions", "None is on.", "This is a fault of the program: please report it.",
                   1);
  looker.touch("attract.begin");
  looker.look("missions");
  // Look at the gallery last: it has all pots of the day.
  for (const bool described : {false, true})
    for (std::size_t n = 0; n < missions; ++n) {
      const MissionKind kind = kiosk.missions().cards()[n].mission->kind;
      if ((kind == MissionKind::describe) != described) continue;
      look_at_mission(kiosk, looker, n);
      if (described) keep_pot(kiosk, looker, name_of_kind(kind));
      looker.touch(described ? "keepsake.again" : "result.other");
      if (!described) looker.touch("leaving.go");
      looker.frames(kSettled);
    }
  return looker.result();
}

}  // namespace onggi::pages
