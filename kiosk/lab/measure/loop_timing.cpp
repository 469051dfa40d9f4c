#include "kiosk/lab/measure/loop_timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>
#include <utility>

#include "engine/script/script.h"
#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/lab/measure/measurement_folder.h"
#include "kiosk/wheel/loop/loop_thread.h"

namespace onggi::measure {

namespace {

using loop::Histogram;

// A figure of the tail needs this many ticks.
constexpr std::uint64_t kEnoughTicks = 100'000;
// Limits for a hand at a stiff wall: a late tick holds a force slightly too long.
constexpr double kWakeAllowed = 300.0;     // us at 99.9 %
constexpr double kComputeAllowed = 700.0;  // us at 99.9 %
constexpr double kTickUs = 1000.0;
constexpr double kMissesAllowed = 1e-4;  // of all ticks

constexpr std::pair<const char*, double> kShares[] = {
    {"p50", 0.5}, {"p99", 0.99}, {"p99.9", 0.999}, {"p99.99", 0.9999}, {"max", 1.0}};

/// The loop's own messages from `from` on.
TimingPhase phase_of(const char* name, const loop::LoopThread& loop, const loop::LoopTiming& from,
                     std::uint64_t missed_before, double seconds, const Histogram& shown) {
  const loop::LoopTiming now = loop.timing();
  return {name,
          {now.wake_us.since(from.wake_us), now.compute_us.since(from.compute_us),
           now.device_us.since(from.device_us)},
          shown,
          {},
          0,
          seconds,
          loop.status().deadlines.overruns - missed_before};
}

void settle() { std::this_thread::sleep_for(std::chrono::milliseconds(300)); }

double age_us(const loop::LoopStatus& status) {
  return files::monotonic_seconds() * 1e6 - static_cast<double>(status.at_ns) * 1e-3;
}

Result<TimingPhase> idle(double seconds) {
  const SceneDef def;
  auto scene = Scene::create(def);
  if (!scene) return tl::unexpected(scene.error());
  loop::LoopThread loop;
  loop.start(std::make_unique<Scene>(std::move(*scene)));
  settle();
  const loop::LoopTiming from = loop.timing();
  const std::uint64_t missed = loop.status().deadlines.overruns;
  Histogram shown;
  bool playing = false;
  const double begun = files::monotonic_seconds();
  while (files::monotonic_seconds() - begun < seconds) {
    if (!playing || loop.status().script_done) {
      auto script = make_script("groove", {def, nullptr, 1, 1.0});
      if (!script) return tl::unexpected(script.error());
      loop.play(std::move(*script));
      playing = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
    loop.collect();
    shown.add(age_us(loop.view().status));
  }
  return phase_of("idle", loop, from, missed, files::monotonic_seconds() - begun, shown);
}

Result<TimingPhase> drawing_beside(exhibit::Kiosk& kiosk, double seconds) {
  const auto* loop = dynamic_cast<const loop::LoopThread*>(&kiosk.wheel_host());
  if (loop == nullptr)
    return problem("the loop", "The exhibit does not run it.", "Please report this.", 1);
  double begun = files::monotonic_seconds();
  while (!kiosk.doing().open_to_visitors && files::monotonic_seconds() - begun < 120.0)
    if (!kiosk.frame(files::monotonic_seconds())) break;
  const loop::LoopTiming from = loop->timing();
  const std::uint64_t missed = loop->status().deadlines.overruns;
  Histogram shown, frames;
  std::uint64_t older = 0;
  begun = files::monotonic_seconds();
  while (files::monotonic_seconds() - begun < seconds) {
    const double from_here = files::monotonic_seconds();
    if (!kiosk.frame(from_here))
      return problem("the window", "It was closed.", "Leave it open.", 1);
    const double age = age_us(kiosk.wheel_host().view().status);
    const double took = (files::monotonic_seconds() - from_here) * 1e6;
    shown.add(age);
    frames.add(took);
    older += age > took + kTickUs ? 1 : 0;
  }
  TimingPhase phase =
      phase_of("drawing", *loop, from, missed, files::monotonic_seconds() - begun, shown);
  phase.frame_us = frames;
  phase.older = older;
  return phase;
}

void judge(TimingReport& report) {
  report.fit = report.lacks.empty();
  std::vector<std::string> why = report.lacks;
  char text[240];
  for (const TimingPhase& phase : report.phases) {
    const double wake = phase.timing.wake_us.quantile(0.999);
    const double compute = phase.timing.compute_us.quantile(0.999);
    const double ticks =
        static_cast<double>(std::max<std::uint64_t>(1, phase.timing.wake_us.total()));
    if (wake > kWakeAllowed) {
      std::snprintf(text, sizeof text,
                    "%s: one wake in a thousand is over %.0f us late, but the limit is %.0f us. "
                    "Give the loop real-time priority, a processor of its own "
                    "(isolcpus), and a kernel with PREEMPT_RT if that is not enough.",
                    phase.name.c_str(), wake, kWakeAllowed);
      why.emplace_back(text);
    }
    if (compute > kComputeAllowed) {
      std::snprintf(text, sizeof text,
                    "%s: one tick in a thousand takes over %.0f us of its 1000. Take fewer rows "
                    "and sectors, or effects out of the scene (onggi lab effects has the prices).",
                    phase.name.c_str(), compute);
      why.emplace_back(text);
    }
    if (static_cast<double>(phase.misses) > kMissesAllowed * ticks) {
      std::snprintf(text, sizeof text,
                    "%s: %llu of %.0f ticks were missed whole. Look for what keeps the processor "
                    "busy, for power saving, and for drawing without a graphics card.",
                    phase.name.c_str(), static_cast<unsigned long long>(phase.misses), ticks);
      why.emplace_back(text);
    }
    if (phase.timing.wake_us.total() < kEnoughTicks) {
      std::snprintf(text, sizeof text,
                    "%s: %.0f ticks are too few for the tail; 100000 or more want --seconds 101.",
                    phase.name.c_str(), ticks);
      why.emplace_back(text);
    }
    report.fit = report.fit && wake <= kWakeAllowed && compute <= kComputeAllowed &&
                 static_cast<double>(phase.misses) <= kMissesAllowed * ticks;
  }
  report.words.emplace_back(report.fit
                                ? "This machine is fit for force feedback."
                                : "This machine is not fit for force feedback as it stands.");
  report.words.insert(report.words.end(), why.begin(), why.end());
}

files::Json json_of(const Histogram& histogram) {
  files::Json out = files::Json::object({{"count", histogram.total()}});
  for (const auto& [name, share] : kShares) out[name] = histogram.quantile(share);
  return out;
}

std::string row_of(const char* name, const Histogram& histogram) {
  if (histogram.total() == 0) return "";
  char text[200];
  int at = std::snprintf(text, sizeof text, "  %-22s", name);
  for (const auto& [label, share] : kShares)
    at += std::snprintf(text + at, sizeof text - static_cast<std::size_t>(at), "%10.0f",
                        histogram.quantile(share));
  return std::string(text) + "\n";
}

}  // namespace

Result<TimingReport> measure_loop(const std::filesystem::path& config, double seconds) {
  TimingReport report;
  {
    const loop::LoopThread asked;
    report.lacks = asked.remarks();
  }
  auto alone = idle(seconds);
  if (!alone) return tl::unexpected(alone.error());
  report.phases.push_back(std::move(*alone));

  const auto nowhere = MeasurementFolder::make();
  if (!nowhere) return tl::unexpected(nowhere.error());
  exhibit::KioskOptions options;
  options.config = config;
  options.keepsakes = nowhere->path();
  options.window.width = 1280;
  options.window.height = 720;
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto kiosk = exhibit::Kiosk::open(options);
  if (!kiosk) return tl::unexpected(kiosk.error());
  report.software_drawing = (*kiosk)->renderer().status().software;
  auto beside = drawing_beside(**kiosk, seconds);
  if (!beside) return tl::unexpected(beside.error());
  report.phases.push_back(std::move(*beside));
  judge(report);
  return report;
}

files::Json json_of(const TimingReport& report) {
  files::Json phases = files::Json::list();
  for (const TimingPhase& phase : report.phases)
    phases.push_back(files::Json::object({{"name", phase.name},
                                          {"seconds", phase.seconds},
                                          {"misses", phase.misses},
                                          {"wake_us", json_of(phase.timing.wake_us)},
                                          {"compute_us", json_of(phase.timing.compute_us)},
                                          {"device_age_us", json_of(phase.timing.device_us)},
                                          {"shown_age_us", json_of(phase.shown_us)},
                                          {"frame_us", json_of(phase.frame_us)},
                                          {"older_than_a_tick_and_a_frame", phase.older}}));
  return files::Json::object({{"fit_for_force", report.fit},
                              {"words", files::Json::list_of(report.words)},
                              {"software_drawing", report.software_drawing},
                              {"phases", phases}});
}

std::string text_of(const TimingReport& report) {
  std::string text;
  for (const TimingPhase& phase : report.phases) {
    char head[160];
    std::snprintf(
        head, sizeof head, "%s, %.0f s, %llu ticks, %llu missed%s\n  us %28s%10s%10s%10s%10s\n",
        phase.name.c_str(), phase.seconds,
        static_cast<unsigned long long>(phase.timing.wake_us.total()),
        static_cast<unsigned long long>(phase.misses),
        phase.name == "drawing" && report.software_drawing ? " (drawn without a GPU)" : "", "p50",
        "p99", "p99.9", "p99.99", "max");
    text += head;
    text += row_of("late to wake", phase.timing.wake_us) +
            row_of("a tick's work", phase.timing.compute_us) +
            row_of("a device's news, age", phase.timing.device_us) +
            row_of("what is shown, age", phase.shown_us) + row_of("a frame", phase.frame_us);
    if (phase.frame_us.total() == 0) continue;
    std::snprintf(head, sizeof head,
                  "  %llu of %llu frames showed what was at most a tick and a frame old.\n",
                  static_cast<unsigned long long>(phase.frame_us.total() - phase.older),
                  static_cast<unsigned long long>(phase.frame_us.total()));
    text += head;
  }
  for (const std::string& words : report.words) text += words + "\n";
  return text;
}

drawing::Plot plot_of(const TimingReport& report) {
  drawing::Plot plot;
  plot.title = "How late the 1 kHz loop wakes, and how long it works";
  plot.subtitle = report.words.empty() ? "" : report.words.front();
  plot.x.label = "time, us";
  plot.x.log = plot.y.log = true;
  plot.y.label = "share of ticks beyond it";
  for (const TimingPhase& phase : report.phases)
    for (const auto& [what, histogram] : {std::pair{"late to wake", &phase.timing.wake_us},
                                          std::pair{"work", &phase.timing.compute_us}}) {
      drawing::PlotSeries series;
      series.name = std::string(what) + ", " + phase.name;
      std::uint64_t left = histogram->total();
      for (int bin = 0; bin < Histogram::kBins && left > 0; ++bin) {
        const auto count = histogram->counts()[static_cast<std::size_t>(bin)];
        if (count == 0) continue;
        left -= count;
        if (left == 0) break;
        series.x.push_back(Histogram::upper_end(bin));
        series.y.push_back(static_cast<double>(left) / static_cast<double>(histogram->total()));
      }
      if (!series.x.empty()) plot.series.push_back(series);
    }
  return plot;
}

}  // namespace onggi::measure
