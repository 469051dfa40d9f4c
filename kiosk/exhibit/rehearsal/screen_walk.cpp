#include "kiosk/exhibit/rehearsal/screen_walk.h"

#include <chrono>
#include <thread>

#include "engine/script/script.h"
#include "kiosk/exhibit/rehearsal/touch_at.h"

namespace onggi::rehearsal {

namespace {

constexpr int kWalkTicks = 40;                     // a frame
constexpr double kWalkFrame = 0.001 * kWalkTicks;  // s
constexpr double kLongestWait = 400.0;  // s in which attract's pot has to be done, or a script

}  // namespace

void ScreenWalk::frames(double seconds) {
  for (const double until = now_ + seconds; good() && now_ < until;) frame();
}

void ScreenWalk::until(const char* what, const std::function<bool()>& done, bool here) {
  for (const double last = now_ + kLongestWait; good() && !done();) {
    // Who works at the wheel is there.
    view::InputEvent moved;
    moved.kind = view::InputEvent::Kind::pointer_move;
    if (here) kiosk_.visit().input(moved, now_);
    frame();
    if (now_ > last) miss(what);
  }
}

void ScreenWalk::touch(const std::string& control) {
  frames(2 * kWalkFrame);  // what was laid out last may have been another size
  if (!good()) return;
  while (const auto way = way_to(kiosk_.visit(), control)) {
    touch_at(kiosk_.visit(), way->x + way->w / 2, way->y + way->h / 2, now_);
    frames(kSettled);
  }
  const auto rect = kiosk_.visit().control(control);
  if (!rect) return miss(control);
  touch_at(kiosk_.visit(), rect->x + rect->w / 2, rect->y + rect->h / 2, now_);
}

void ScreenWalk::touch_clay() {
  if (!good()) return;
  const auto& pot = kiosk_.shown().pot;
  const auto at = pot ? pot->camera.project({0, 0.05, 0}) : std::nullopt;
  if (!at) return miss("attract's pot");
  touch_at(kiosk_.visit(), at->first, at->second, now_);
}

void ScreenWalk::turn_to(const std::string& control) {
  while (good() && !has(control) && has("choose.next")) {
    touch("choose.next");
    frames(kSettled);
  }
}

void ScreenWalk::throw_pot(double part) {
  if (!good()) return;
  const auto* card = kiosk_.card(kiosk_.doing().card);
  if (card == nullptr) return miss("the pot on the wheel");
  auto script = make_script("follow", {kiosk_.doing().pot, &card->target, 1, 1.0});
  if (!script) return fail(tl::unexpected(script.error()));
  kiosk_.wheel_host().play(std::move(*script));
  until("the end of the throwing", [&] {
    const loop::LoopStatus status = kiosk_.wheel_host().status();
    return status.script_done || status.script_progress > part;
  });
}

void ScreenWalk::frame() {
  kiosk_.advance(kWalkTicks);
  kiosk_.frame(now_ += kWalkFrame, false);
  // A save runs on a worker, at its own pace.
  if (kiosk_.doing().saving) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

void ScreenWalk::miss(const std::string& what) {
  fail(problem("screen " + std::string(screens::name_of(kiosk_.visit().screen())),
               "On the way through the screens, " + what + " was not found.",
               "This is a fault of the program: please report it.", 1));
}

}  // namespace onggi::rehearsal
