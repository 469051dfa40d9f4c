#include "kiosk/lab/measure/frame_rate.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/exhibit/rehearsal/touch_at.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/lab/measure/measurement_folder.h"
#include "kiosk/lab/measure/similarity.h"
#include "kiosk/picture/render/canvas.h"
#include "kiosk/picture/view/looks_same.h"

namespace onggi::measure {
namespace {

constexpr double kOpening = 120.0, kWarmUp = 3.0, kReachedBy = 60.0, kComesAbout = 15.0;  // s
constexpr double kCompared = 1.0;  // s between comparisons
constexpr int kDecoratedPairs = 60;

Problem closed() { return {"the window", "It was closed.", "Leave it open.", 1}; }

/// The observed exhibit: every frame goes through here.
class Watched {
 public:
  explicit Watched(exhibit::Kiosk& kiosk) : kiosk_(kiosk) {}

  bool frame() { return open_ = kiosk_.frame(files::monotonic_seconds()) && open_; }
  bool open() const { return open_; }

  /// Runs frames for `seconds`, with `visitor` between them if there is one.
  Result<FrameRateRow> observe(const char* screen, double seconds,
                               rehearsal::ScriptedVisitor* visitor);
  Result<FrameDelays> delays();

 private:
  void compare(std::vector<double>& similar);
  template <typename Until>
  /// False if it did not happen within kComesAbout.
  Result<bool> frames_until(Until&& until);

  exhibit::Kiosk& kiosk_;
  bool open_ = true;
};

void Watched::compare(std::vector<double>& similar) {
  const view::Frame frame = kiosk_.shown();
  if (!frame.pot || frame.fade > 0) return;
  const ClayView& clay = kiosk_.wheel_host().view().clay;
  if (clay.rows() == 0) return;
  double radius = 0.01;
  for (const ProfilePoint& at : clay.profile().points) radius = std::max(radius, at.outer);
  const view::Rect reach =
      render::reach_of(*frame.pot, clay.profile().height(), radius, frame.width, frame.height);
  const view::Image shown = kiosk_.renderer().read_pixels();
  similar.push_back(structural_similarity(shown, kiosk_.renderer().draw_offscreen(frame), reach));
}

Result<FrameRateRow> Watched::observe(const char* screen, double seconds,
                                      rehearsal::ScriptedVisitor* visitor) {
  FrameRateRow row{kiosk_.renderer().width(), kiosk_.renderer().height(), screen};
  std::vector<double> took, similar;
  double scales = 0, busy = 0, watched = 0, compared_at = files::monotonic_seconds();
  for (double left = seconds; left > 0;) {
    const double from = files::monotonic_seconds(), busy_from = files::thread_seconds();
    if (!frame()) return tl::unexpected(closed());
    if (visitor != nullptr)
      if (auto good = visitor->step(files::monotonic_seconds()); !good)
        return tl::unexpected(good.error());
    const double now = files::monotonic_seconds();
    took.push_back(now - from);
    watched += now - from;
    busy += files::thread_seconds() - busy_from;
    scales += kiosk_.renderer().status().render_scale;
    left -= now - from;
    if (now - compared_at < kCompared) continue;
    compare(similar);
    // Frames disturbed by the comparison do not count.
    if (!frame()) return tl::unexpected(closed());
    compared_at = files::monotonic_seconds();
  }
  row.frames = static_cast<int>(took.size());
  std::sort(took.begin(), took.end());
  const auto slower_than = [&took](double share) {
    return took[static_cast<std::size_t>(share * static_cast<double>(took.size() - 1))];
  };
  row.fps_median = 1.0 / slower_than(0.5);
  row.fps_p5 = 1.0 / slower_than(0.95);
  row.main_thread_share = busy / watched;
  row.render_scale = scales / static_cast<double>(took.size());
  row.ssim_least = 1;
  for (const double s : similar) {
    row.ssim += s / static_cast<double>(similar.size());
    row.ssim_least = std::min(row.ssim_least, s);
  }
  return row;
}

template <typename Until>
Result<bool> Watched::frames_until(Until&& until) {
  const double from = files::monotonic_seconds();
  while (!until()) {
    if (!frame()) return tl::unexpected(closed());
    if (files::monotonic_seconds() - from > kComesAbout) return false;
  }
  return true;
}

Result<FrameDelays> Watched::delays() {
  FrameDelays delays{kiosk_.renderer().width(), kiosk_.renderer().height(), 0, {}, {}};
  screens::Visit& visit = kiosk_.visit();
  // Stop the wheel with its own button.
  while (const auto way = rehearsal::way_to(visit, "throw.slower")) {
    rehearsal::touch_at(visit, way->x + 2, way->y + 2, files::monotonic_seconds());
    if (!frame()) return tl::unexpected(closed());
  }
  while (kiosk_.wheel_host().view().status.feedback.wheel_speed != 0) {
    const auto slower = visit.control("throw.slower");
    if (!slower) break;
    for (const auto kind :
         {view::InputEvent::Kind::pointer_down, view::InputEvent::Kind::pointer_up})
      visit.input({.kind = kind, .x = slower->x + 2, .y = slower->y + 2},
                  files::monotonic_seconds());
    if (!frame()) return tl::unexpected(closed());
  }
  const ClayView& clay = kiosk_.wheel_host().view().clay;
  std::optional<view::PotView> before = kiosk_.shown().pot;
  std::uint64_t change = clay.change();
  double moved_at = files::monotonic_seconds();
  const auto still = frames_until([&] {
    const auto& now = kiosk_.shown().pot;
    if (now && before && change == clay.change() && view::looks_same(*before, *now))
      return kiosk_.renderer().status().full_quality && files::monotonic_seconds() > moved_at;
    moved_at = files::monotonic_seconds();
    before = now;
    change = clay.change();
    return false;
  });
  if (!still) return tl::unexpected(still.error());
  if (*still) delays.still_ms = (files::monotonic_seconds() - moved_at) * 1000;

  const auto pot = kiosk_.shown().pot;
  if (!pot) return delays;
  const auto drag = [&](view::InputEvent::Kind kind, double y) {
    if (const auto at = pot->camera.project({0.19, y, 0}))
      visit.input({.kind = kind, .x = at->first, .y = at->second}, files::monotonic_seconds());
  };
  drag(view::InputEvent::Kind::pointer_down, 0.10);
  for (int i = 0; i < 40; ++i)
    if (!frame()) return tl::unexpected(closed());
  const auto hands = [&] { return kiosk_.shown().pot->hands; };
  const auto held = hands();
  drag(view::InputEvent::Kind::pointer_move, 0.16);
  int frames = -1;
  const auto seen = frames_until([&] {
    ++frames;
    return !(hands() == held);
  });
  if (!seen) return tl::unexpected(seen.error());
  if (*seen) delays.drag_frames = frames;
  drag(view::InputEvent::Kind::pointer_up, 0.16);
  return delays;
}

Result<void> time_size(const FrameRatePlan& plan, std::pair<int, int> size, FrameRateReport& report,
                       std::FILE* progress) {
  const auto say = [&](const char* what) {
    std::fprintf(progress, "%d x %d: %s\n", size.first, size.second, what);
    std::fflush(progress);
  };
  const auto nowhere = MeasurementFolder::make();
  if (!nowhere) return tl::unexpected(nowhere.error());
  exhibit::KioskOptions options;
  options.config = plan.config;
  options.keepsakes = nowhere->path();
  options.window.width = size.first;
  options.window.height = size.second;
  const double opening = files::monotonic_seconds();
  auto kiosk = exhibit::Kiosk::open(options);
  if (!kiosk) return tl::unexpected(kiosk.error());
  report.device = (*kiosk)->renderer().status().device;
  report.software = (*kiosk)->renderer().status().software;
  Watched watched(**kiosk);
  while (!(*kiosk)->doing().open_to_visitors && files::monotonic_seconds() - opening < kOpening)
    if (!watched.frame()) return tl::unexpected(closed());
  const double first = files::monotonic_seconds() - opening;

  say("attract");
  if (auto warm = watched.observe("", kWarmUp, nullptr); !warm) return tl::unexpected(warm.error());
  auto attract = watched.observe("attract", plan.seconds, nullptr);
  if (!attract) return tl::unexpected(attract.error());
  report.rows.push_back(*attract);

  rehearsal::ScriptedVisitor::Plan visit;
  visit.naive = rehearsal::ScriptedVisitor::Naive{600, rehearsal::NaiveHands::Pointer::mouse};
  visit.linger = 0.5;
  rehearsal::ScriptedVisitor visitor(**kiosk, visit, {});
  const double asked = files::monotonic_seconds();
  while (!visitor.throwing()) {
    if (!watched.frame()) return tl::unexpected(closed());
    if (auto good = visitor.step(files::monotonic_seconds()); !good)
      return tl::unexpected(good.error());
    if (files::monotonic_seconds() - asked > kReachedBy)
      return problem("the exhibit", "Its wheel was not reached within a minute.", "Read its log.",
                     1);
  }
  say("throwing");
  if (auto warm = watched.observe("", kWarmUp, &visitor); !warm)
    return tl::unexpected(warm.error());
  auto throwing = watched.observe("throwing", plan.seconds, &visitor);
  if (!throwing) return tl::unexpected(throwing.error());
  report.rows.push_back(*throwing);

  say("standing still");
  (*kiosk)->visit().input({.kind = view::InputEvent::Kind::pointer_up}, files::monotonic_seconds());
  auto delays = watched.delays();
  if (!delays) return tl::unexpected(delays.error());
  delays->first_picture_ms = first * 1000;
  report.delays.push_back(*delays);
  return {};
}

}  // namespace

Result<FrameRateReport> measure_frames(const FrameRatePlan& plan, std::FILE* progress) {
  int width = 320, height = 240;
  for (const auto& [w, h] : plan.sizes) {
    width = std::max(width, w);
    height = std::max(height, h);
  }
  auto display = files::VirtualDisplay::ensure(width, height);
  if (!display) return tl::unexpected(display.error());
  FrameRateReport report;
  for (const auto& size : plan.sizes) {
    if (!plan.only_loads) {
      if (auto good = time_size(plan, size, report, progress); !good)
        return tl::unexpected(good.error());
      std::fprintf(progress, "%d x %d: decorated pots\n", size.first, size.second);
      auto decorated = measure_decorated(plan.config, size, kDecoratedPairs);
      if (!decorated) return tl::unexpected(decorated.error());
      report.decorated.insert(report.decorated.end(), decorated->begin(), decorated->end());
    }
    std::fprintf(progress, "%d x %d: counting\n", size.first, size.second);
    FrameLoadPlan load;
    load.config = plan.config;
    load.size = size;
    auto loads = measure_load(load);
    if (!loads) return tl::unexpected(loads.error());
    report.loads.insert(report.loads.end(), loads->begin(), loads->end());
  }
  return report;
}

files::Json json_of(const FrameRateReport& report) {
  files::Json rows = files::Json::list(), delays = files::Json::list(), loads = files::Json::list(),
              decorated = files::Json::list();
  const auto size_of = [](const auto& of) {
    return std::to_string(of.width) + "x" + std::to_string(of.height);
  };
  for (const FrameRateRow& row : report.rows)
    rows.push_back(files::Json::object({{"size", size_of(row)},
                                        {"screen", row.screen},
                                        {"frames", row.frames},
                                        {"fps_median", row.fps_median},
                                        {"fps_p5", row.fps_p5},
                                        {"main_thread_share", row.main_thread_share},
                                        {"render_scale", row.render_scale},
                                        {"ssim", row.ssim},
                                        {"ssim_least", row.ssim_least}}));
  for (const FrameDelays& delay : report.delays) {
    files::Json one = files::Json::object(
        {{"size", size_of(delay)}, {"first_picture_ms", delay.first_picture_ms}});
    if (delay.still_ms) one["still_ms"] = *delay.still_ms;
    if (delay.drag_frames) one["drag_frames"] = *delay.drag_frames;
    delays.push_back(one);
  }
  for (const DecoratedFrames& row : report.decorated) decorated.push_back(json_of(row));
  for (const FrameLoad& load : report.loads) loads.push_back(json_of(load));
  return files::Json::object({{"device", report.device},
                              {"software", report.software},
                              {"rows", rows},
                              {"delays", delays},
                              {"decorated", decorated},
                              {"loads", loads}});
}

std::string text_of(const FrameRateReport& report) {
  if (report.rows.empty()) return text_of(report.loads);
  std::string text = "Drawn by " + report.device + (report.software ? ", without a GPU.\n" : ".\n");
  char line[200];
  std::snprintf(line, sizeof line, "%-11s%-10s%8s%9s%8s%14s%8s%8s%8s\n", "size", "screen", "frames",
                "fps p50", "fps p5", "main thread", "scale", "ssim", "least");
  text += line;
  for (const FrameRateRow& row : report.rows) {
    const std::string size = std::to_string(row.width) + "x" + std::to_string(row.height);
    std::snprintf(line, sizeof line, "%-11s%-10s%8d%9.1f%8.1f%13.0f%%%8.2f%8.3f%8.3f\n",
                  size.c_str(), row.screen.c_str(), row.frames, row.fps_median, row.fps_p5,
                  100 * row.main_thread_share, row.render_scale, row.ssim, row.ssim_least);
    text += line;
  }
  for (const FrameDelays& delay : report.delays) {
    std::snprintf(line, sizeof line, "%dx%d: first picture after %.0f ms", delay.width,
                  delay.height, delay.first_picture_ms);
    text += line;
    if (delay.still_ms) {
      std::snprintf(line, sizeof line, "; a still one at full quality %.0f ms after motion ends",
                    *delay.still_ms);
      text += line;
    }
    if (delay.drag_frames)
      text += "; a drag is on the screen in frame " + std::to_string(*delay.drag_frames);
    text += ".\n";
  }
  return text + text_of(report.decorated) + text_of(report.loads);
}

drawing::Plot plot_of(const FrameRateReport& report) {
  drawing::Plot plot;
  plot.title = "Frames a second beside the 1 kHz loop";
  plot.subtitle = "onggi lab frames; drawn by " + report.device;
  plot.y.label = "frames a second";
  plot.y.low = 0.0;
  plot.x.label = "screen";
  drawing::PlotSeries median, slow;
  median.kind = slow.kind = drawing::PlotSeries::Kind::bars;
  median.name = "median";
  slow.name = "slowest of twenty";
  for (const FrameRateRow& row : report.rows) {
    plot.x.names.push_back(std::to_string(row.width) + " x " + std::to_string(row.height) + ", " +
                           row.screen);
    median.y.push_back(row.fps_median);
    slow.y.push_back(row.fps_p5);
  }
  plot.series = {median, slow};
  return plot;
}

}  // namespace onggi::measure
