#include "kiosk/lab/measure/soak.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/virtual_display.h"

namespace onggi::measure {

namespace {

constexpr double kReportEvery = 30.0;
// Compare the least memory of the last quarter with that of the third: the first half fills the
// caches of text, fonts and drivers, and a postcard in work is no growth.
constexpr double kGrowthAllowed = 16.0;  // MiB

void report(double elapsed, int visits, exhibit::Kiosk& kiosk) {
  const loop::LoopStatus status = kiosk.wheel_host().status();
  const render::RenderStatus drawn = kiosk.renderer().status();
  std::fprintf(
      stderr,
      "%6.0f s  %d visits  %.1f MiB  frame %.1f ms at scale %.2f  wakes %llu  late %llu  "
      "overruns %llu  "
      "lost ticks %llu  worst tick %.0f us\n",
      elapsed, visits, static_cast<double>(files::resident_bytes()) / 1048576.0, drawn.frame_ms,
      drawn.render_scale, static_cast<unsigned long long>(status.deadlines.wakes),
      static_cast<unsigned long long>(status.deadlines.late),
      static_cast<unsigned long long>(status.deadlines.overruns),
      static_cast<unsigned long long>(status.deadlines.lost_ticks), status.deadlines.worst_tick_us);
}

}  // namespace

Result<int> soak(const SoakPlan& plan) {
  exhibit::KioskOptions options;
  options.config = plan.config;
  options.keepsakes = plan.keepsakes;
  options.window = plan.window;
  auto display = files::VirtualDisplay::ensure(std::max(options.window.width, 640),
                                               std::max(options.window.height, 480));
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  exhibit::Kiosk& kiosk = **opened;

  const double begun = files::monotonic_seconds(), length = plan.minutes * 60;
  double next_report = kReportEvery;
  long third_quarter = 0, last_quarter = 0;  // Smallest resident size, bytes; 0: not measured yet.
  int visits = 0;
  std::unique_ptr<rehearsal::ScriptedVisitor> visitor;
  for (double now = begun; now - begun < length; now = files::monotonic_seconds()) {
    if (!kiosk.frame(now))
      return problem("the window", "It was closed during the soak.", "Leave it open.", 1);
    if (!kiosk.doing().open_to_visitors) continue;
    if (visitor && visitor->done()) {
      visitor.reset();
      ++visits;
    }
    if (!visitor) {
      rehearsal::ScriptedVisitor::Plan next;
      next.script = plan.script;
      next.card = visits % std::max(1, static_cast<int>(kiosk.shelf().cards().size()));
      next.seed = static_cast<std::uint64_t>(visits) + 1;
      next.pace = plan.pace;
      if (plan.by_device) next.hand = rehearsal::ScriptedVisitor::Plan::Hand::device_alone;
      visitor = std::make_unique<rehearsal::ScriptedVisitor>(kiosk, next, nullptr);
    }
    if (auto good = visitor->step(now); !good) return tl::unexpected(good.error());
    const double elapsed = now - begun;
    if (elapsed > 0.5 * length) {
      long& least = elapsed > 0.75 * length ? last_quarter : third_quarter;
      const long now_bytes = files::resident_bytes();
      least = least == 0 ? now_bytes : std::min(least, now_bytes);
    }
    if (elapsed >= next_report) {
      report(elapsed, visits, kiosk);
      next_report += kReportEvery;
    }
  }
  report(length, visits, kiosk);
  const auto lost = kiosk.wheel_host().status().deadlines.lost_ticks;
  const double grown = static_cast<double>(last_quarter - third_quarter) / 1048576.0;
  std::printf(
      "soak: %d visits in %.1f min; memory %+.1f MiB from the third quarter to the last; %llu "
      "ticks lost\n",
      visits, plan.minutes, grown, static_cast<unsigned long long>(lost));
  if (visits == 0)
    return problem("soak", "No visit ended in that time.", "Let it run longer: --minutes 10.", 1);
  if (grown > kGrowthAllowed)
    return problem("soak", "Memory keeps growing.",
                   "Run it under valgrind --tool=massif to see where.", 1);
  return lost == 0 ? 0 : 1;
}

}  // namespace onggi::measure
