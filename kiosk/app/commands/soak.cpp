#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "kiosk/app/commands/commands.h"
#include "kiosk/app/kiosk.h"
#include "kiosk/app/log.h"
#include "kiosk/app/monotonic.h"
#include "kiosk/app/paths.h"
#include "kiosk/app/scripted_visitor.h"
#include "kiosk/app/window_size.h"
#include "kiosk/files/virtual_display.h"

namespace onggi::app {

namespace {

constexpr double kReportEvery = 30.0;
// Memory is judged by the least of the last quarter against the least of the one before: the first
// half fills the caches of text, fonts and drivers, and a postcard in the making is no growth.
constexpr double kGrowthAllowed = 16.0;  // MiB

struct SoakArguments {
  std::string config, window = "1280x720", out = "keepsakes/soak", script = "follow";
  double minutes = 10;
  double pace = 3;
};

void report(double elapsed, int visits, Kiosk& kiosk) {
  const loop::LoopStatus status = kiosk.potter().status();
  const render::RenderStatus drawn = kiosk.renderer().status();
  std::fprintf(stderr,
               "%6.0f s  %d visits  %.1f MiB  frame %.1f ms at scale %.2f  wakes %llu  late %llu  "
               "overruns %llu  "
               "lost ticks %llu  worst tick %.0f us\n",
               elapsed, visits, static_cast<double>(resident_bytes()) / 1048576.0, drawn.frame_ms,
               drawn.render_scale, static_cast<unsigned long long>(status.deadlines.wakes),
               static_cast<unsigned long long>(status.deadlines.late),
               static_cast<unsigned long long>(status.deadlines.overruns),
               static_cast<unsigned long long>(status.deadlines.lost_ticks),
               status.deadlines.worst_tick_us);
}

Result<int> soak(const SoakArguments& arguments) {
  const auto config = exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  KioskOptions options;
  options.config = *config;
  options.keepsakes = arguments.out;
  if (auto good = read_window_size(arguments.window, options.window); !good)
    return tl::unexpected(good.error());
  auto display = files::VirtualDisplay::ensure(std::max(options.window.width, 640),
                                               std::max(options.window.height, 480));
  if (!display) return tl::unexpected(display.error());
  auto opened = Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  Kiosk& kiosk = **opened;

  const double begun = monotonic_seconds(), length = arguments.minutes * 60;
  double next_report = kReportEvery;
  long third_quarter = 0, last_quarter = 0;  // Least resident bytes; 0: not yet looked.
  int visits = 0;
  std::unique_ptr<ScriptedVisitor> visitor;
  for (double now = begun; now - begun < length; now = monotonic_seconds()) {
    if (!kiosk.frame(now))
      return problem("the window", "It was closed during the soak.", "Leave it open.", 1);
    if (!kiosk.open_to_visitors()) continue;
    if (visitor && visitor->done()) {
      visitor.reset();
      ++visits;
    }
    if (!visitor) {
      ScriptedVisitor::Plan plan;
      plan.script = arguments.script;
      plan.card = visits % std::max(1, static_cast<int>(kiosk.shelf().cards().size()));
      plan.seed = static_cast<std::uint64_t>(visits) + 1;
      plan.pace = arguments.pace;
      visitor = std::make_unique<ScriptedVisitor>(kiosk, plan, nullptr);
    }
    if (auto good = visitor->step(now); !good) return tl::unexpected(good.error());
    const double elapsed = now - begun;
    if (elapsed > 0.5 * length) {
      long& least = elapsed > 0.75 * length ? last_quarter : third_quarter;
      const long now_bytes = resident_bytes();
      least = least == 0 ? now_bytes : std::min(least, now_bytes);
    }
    if (elapsed >= next_report) {
      report(elapsed, visits, kiosk);
      next_report += kReportEvery;
    }
  }
  report(length, visits, kiosk);
  const auto lost = kiosk.potter().status().deadlines.lost_ticks;
  const double grown = static_cast<double>(last_quarter - third_quarter) / 1048576.0;
  std::printf(
      "soak: %d visits in %.1f min; memory %+.1f MiB from the third quarter to the last; %llu "
      "ticks lost\n",
      visits, arguments.minutes, grown, static_cast<unsigned long long>(lost));
  if (visits == 0)
    return problem("soak", "No visit came to its end in that time.",
                   "Let it run longer: --minutes 10.", 1);
  if (grown > kGrowthAllowed)
    return problem("soak", "Memory goes on growing.",
                   "Run it under valgrind --tool=massif to see where.", 1);
  return lost == 0 ? 0 : 1;
}

}  // namespace

void add_soak(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<SoakArguments>();
  CLI::App* command = app.add_subcommand(
      "soak", "Let scripted visitors come and go, and watch memory and the 1 kHz loop");
  command->footer("Example: onggi soak --minutes 10 --window 1280x720");
  command->add_option("--minutes", arguments->minutes, "How long [10]")
      ->check(CLI::Range(0.1, 1e5));
  command->add_option("--pace", arguments->pace, "Of the hands, 0.25 to 4 [3]")
      ->check(CLI::Range(0.25, 4.0));
  command->add_option("--script", arguments->script, "What the hands do [follow]");
  command->add_option("--out", arguments->out, "Where its keepsakes go [keepsakes/soak]");
  command->add_option("--window", arguments->window, "WIDTHxHEIGHT [1280x720]");
  command->add_option("--config", arguments->config, "The exhibit's TOML [config/exhibit.toml]");
  command->callback([arguments, &exit_code] {
    const auto code = soak(*arguments);
    exit_code = code ? *code : exit_with(code.error());
  });
}

}  // namespace onggi::app
