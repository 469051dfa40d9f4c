#include "tests/ends/timed_visit.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/program/commands/service_run.h"

namespace onggi::ends {
namespace {

using files::Json;

constexpr double kFaster = 6.0;      // the screens' clock
constexpr double kStall = 0.1;       // s: a longer frame does not hurry the visitor
constexpr double kThrows = 6.0;      // s of the screens' clock at the wheel
constexpr double kPatience = 900.0;  // s of it for a visit
constexpr double kSlow = 0.25;       // s: such a frame is told

struct Taken {
  double processor = 0, wall = 0;
};

class Stopwatch {
 public:
  Taken taken() const {
    return {files::thread_seconds() - processor_, files::monotonic_seconds() - wall_};
  }

 private:
  double processor_ = files::thread_seconds(), wall_ = files::monotonic_seconds();
};

Json json_of(const Taken& taken, const std::string& at = {}) {
  return Json::object({{"processor_s", taken.processor}, {"wall_s", taken.wall}, {"at", at}});
}

class TimedVisit {
 public:
  explicit TimedVisit(const VisitPlan& plan) : plan_(plan) {}

  Json run() {
    const Result<void> ended = visit();
    return Json::object({{"ended", ended.has_value()},
                         {"why", ended ? std::string() : to_text(ended.error())},
                         {"frames", frames_},
                         {"open", json_of(open_)},
                         {"close", json_of(closed_)},
                         {"frame", json_of(longest_, at_)},
                         {"slow", slow_}});
  }

 private:
  Result<void> visit() {
    exhibit::KioskOptions options;
    options.config = plan_.config;
    options.keepsakes = plan_.keepsakes;
    options.window.width = 640;
    options.window.height = 360;
    options.devices = false;
    auto display = files::VirtualDisplay::ensure(640, 480);
    if (!display) return tl::unexpected(display.error());
    display_ = std::move(*display);
    service_.emplace(*commands::ServiceRun::state_folder());
    service_->opens(options.config, false);
    const Stopwatch opening;
    auto kiosk = exhibit::Kiosk::open(options);
    open_ = opening.taken();
    if (!kiosk) return tl::unexpected(kiosk.error());
    kiosk_ = std::move(*kiosk);
    service_->shows(*kiosk_);
    real_ = files::monotonic_seconds();
    while (!kiosk_->doing().open_to_visitors || !kiosk_->shelf().complete())
      if (auto good = frame("opening"); !good) return good;
    rehearsal::ScriptedVisitor::Plan who;
    who.naive = {kThrows, rehearsal::NaiveHands::Pointer::mouse};
    who.mission = plan_.mission;
    who.decorate = true;
    rehearsal::ScriptedVisitor visitor(*kiosk_, who, nullptr);
    while (!visitor.done()) {
      // A save takes its own time, however fast the visitor is.
      faster_ = kiosk_->doing().saving || kiosk_->doing().turning ? 1.0 : kFaster;
      if (auto good = frame(std::string(screens::name_of(kiosk_->visit().screen()))); !good)
        return good;
      // What it touches is a frame's work, too.
      const Stopwatch touching;
      if (auto good = visitor.step(now_); !good) return good;
      note(touching.taken(), std::string(screens::name_of(kiosk_->visit().screen())) + ", a touch");
    }
    // As before another exhibit is opened: systemd waits meanwhile as it waits for a frame.
    const Stopwatch closing;
    kiosk_.reset();
    closed_ = closing.taken();
    service_->end();
    return {};
  }

  Result<void> frame(const std::string& screen) {
    const double real = files::monotonic_seconds();
    now_ += (real - real_) + (faster_ - 1) * std::min(real - real_, kStall);
    real_ = real;
    if (now_ > kPatience)
      return problem("the visit", "It did not come to its end: it stands at " + screen + ".", "",
                     1);
    const Stopwatch making;
    if (!kiosk_->frame(now_)) return problem("the window", "It was closed.", "", 1);
    service_->look(*kiosk_);
    ++frames_;
    note(making.taken(), screen);
    return {};
  }

  void note(const Taken& taken, const std::string& screen) {
    if (taken.processor > longest_.processor) longest_ = taken, at_ = screen;
    if (std::max(taken.processor, taken.wall) > kSlow) slow_.push_back(json_of(taken, screen));
  }

  VisitPlan plan_;
  std::unique_ptr<files::VirtualDisplay>
      display_;  // outlives the kiosk: Xlib ends the process else
  std::optional<commands::ServiceRun> service_;
  std::unique_ptr<exhibit::Kiosk> kiosk_;
  double now_ = 0, real_ = 0, faster_ = kFaster;
  int frames_ = 0;
  Taken open_, closed_, longest_;
  std::string at_;
  Json slow_ = Json::list();
};

}  // namespace

Json timed_visit(const VisitPlan& plan) { return TimedVisit(plan).run(); }

}  // namespace onggi::ends
