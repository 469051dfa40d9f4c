#include "kiosk/lab/measure/soak_days.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/composition/reload.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/exhibit/rehearsal/touch_at.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/lab/measure/soak_troubles.h"
#include "kiosk/wheel/loop/loop_thread.h"

namespace fs = std::filesystem;

namespace onggi::measure {

namespace {

constexpr double kFaster = 6.0;        // the screens' clock, within a visit
constexpr double kStall = 0.1;         // s: a longer frame does not speed the visitor up
constexpr double kThrows = 12.0;       // s of the screens' clock at the wheel
constexpr double kLinger = 1.6;        // s of it on each screen
constexpr double kSkip = 20.0;         // s skipped at once between two visits
constexpr double kSampleEvery = 0.25;  // h
constexpr int kWalksAway = 7;          // every this many visits
constexpr double kPatience = 300.0;    // s of real time that a visit may take

int count_in(const fs::path& folder) {
  std::error_code none;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(folder, none)) count += entry.exists(none);
  return count;
}

double megabytes_in(const fs::path& folder) {
  std::error_code none;
  double bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder, none)) {
    const auto size = entry.is_regular_file(none) ? entry.file_size(none) : 0;
    if (!none) bytes += static_cast<double>(size);
  }
  return 1e-6 * bytes;
}

bool whole(const souvenir::KeepsakeFiles& files) {
  std::error_code none;
  for (const fs::path& file : {files.postcard, files.glb, files.replay})
    if (const auto size = fs::file_size(file, none); none || size == 0) return false;
  return true;
}

class SoakDays {
 public:
  explicit SoakDays(const SoakDaysPlan& plan) : plan_(plan) {}
  Result<SoakReport> run();

 private:
  Result<void> open();
  Result<void> frame();
  Result<void> open_anew();
  Result<void> visit();
  Result<void> walk_away();
  Result<void> rest();
  void dead_end(const std::string& how);
  void look_at_keepsake();
  void look_at_all_keepsakes();
  void sample();
  void note_ticks();

  double hours() const { return (now_ - begun_) / 3600; }

  SoakDaysPlan plan_;
  fs::path exhibit_, keepsakes_;
  exhibit::KioskOptions options_;
  std::unique_ptr<exhibit::Kiosk> kiosk_;
  std::unique_ptr<exhibit::Reload> reload_;
  std::unique_ptr<SoakTroubles> troubles_;
  std::unique_ptr<rehearsal::ScriptedVisitor> visitor_;
  std::vector<souvenir::KeepsakeFiles> kept_;  ///< Since the folder was last removed.
  loop::LoopTiming timing_;                    ///< At the last sample.
  SoakReport report_;
  double real_ = 0, now_ = 0, begun_ = 0, real_begun_ = 0, faster_ = 1;
  double next_sample_ = 0, next_word_ = 1;
};

Result<void> SoakDays::open() {
  auto kiosk = exhibit::Kiosk::open(options_);
  if (!kiosk) return tl::unexpected(kiosk.error());
  kiosk_ = std::move(*kiosk);
  timing_ = {};
  const double begun = files::monotonic_seconds();
  while (!kiosk_->doing().open_to_visitors || !kiosk_->shelf().complete()) {
    if (files::monotonic_seconds() - begun > kPatience)
      return problem("the exhibit", "It does not open.", "Run onggi check.", 1);
    if (auto good = frame(); !good) return good;
  }
  return {};
}

Result<void> SoakDays::frame() {
  const double real = files::monotonic_seconds();
  const double passed = real - real_;
  now_ += passed + (faster_ - 1) * std::min(passed, kStall);
  real_ = real;
  files::set_wall_ahead(static_cast<std::int64_t>((now_ - begun_) - (real_ - real_begun_)));
  if (!kiosk_->frame(now_))
    return problem("the window", "It was closed during the soak.", "Leave it open.", 1);
  if (reload_ && kiosk_->doing().open_to_visitors && kiosk_->shelf().complete())
    reload_->look(now_);
  return {};
}

void SoakDays::note_ticks() {
  const loop::LoopStatus status = kiosk_->wheel_host().status();
  report_.lost_ticks += status.deadlines.lost_ticks;
  report_.ticks += status.deadlines.wakes;
}

Result<void> SoakDays::open_anew() {
  note_ticks();
  kiosk_.reset();
  reload_->taken_up();
  return open();
}

void SoakDays::dead_end(const std::string& how) {
  ++report_.dead_ends;
  const std::string over = kiosk_->visit().reading().over;
  report_.ends.push_back("visit " + std::to_string(report_.visits) + ": " + how +
                         (over.empty() ? "" : " Over the screen: " + over + "."));
}

void SoakDays::look_at_keepsake() {
  const exhibit::KeptVisit* const kept = kiosk_->doing().kept;
  if (!kept || !kept->saved) return;
  if (!*kept->saved) {
    ++report_.not_kept;
    if (!troubles_->may_refuse()) {
      ++report_.unexplained;
      report_.ends.push_back("visit " + std::to_string(report_.visits) +
                             ": not kept: " + kept->saved->error().what);
    }
    return;
  }
  ++report_.kept;
  kept_.push_back(**kept->saved);
  if (!whole(kept_.back())) {
    ++report_.lost;
    kept_.pop_back();
  }
}

// Keepsakes that the quota has not removed. It removes the oldest first, so after one that exists
// all must exist.
void SoakDays::look_at_all_keepsakes() {
  bool there = false;
  for (const souvenir::KeepsakeFiles& files : kept_) {
    const bool is_whole = whole(files);
    report_.lost += there && !is_whole ? 1 : 0;
    there = there || is_whole;
  }
  if (!kept_.empty() && !there) ++report_.lost;
  kept_.clear();
}

Result<void> SoakDays::walk_away() {
  ++report_.walked_away;
  visitor_.reset();
  faster_ = 1;
  for (int n = 0; n < 200 && kiosk_->visit().screen() != screens::ScreenId::attract; ++n) {
    now_ += kSkip;
    if (auto good = frame(); !good) return good;
  }
  if (kiosk_->visit().screen() != screens::ScreenId::attract)
    dead_end("nobody was there, and it did not go back to the start");
  return {};
}

Result<void> SoakDays::visit() {
  const int n = report_.visits;
  // Check the folder's content before removing the folder.
  if (n % SoakTroubles::kEvery == 13) look_at_all_keepsakes();
  troubles_->before(n);
  rehearsal::ScriptedVisitor::Plan plan;
  plan.naive = {kThrows, n % 2 == 0 ? rehearsal::NaiveHands::Pointer::mouse
                                    : rehearsal::NaiveHands::Pointer::finger};
  plan.card = n % std::max(1, static_cast<int>(kiosk_->shelf().cards().size()));
  plan.glaze = n % std::max(1, static_cast<int>(kiosk_->glazes().size()));
  plan.seed = plan_.seed + static_cast<std::uint64_t>(n);
  plan.linger = kLinger;
  visitor_ = std::make_unique<rehearsal::ScriptedVisitor>(*kiosk_, plan, nullptr);
  ++report_.visits;
  const double begun = real_;
  bool changed_language = false;
  while (!visitor_->done()) {
    // A save takes real time. At six times the speed for the visitor, a hanging helper would make
    // the visitor count as gone.
    faster_ = kiosk_->doing().saving || kiosk_->doing().turning ? 1 : kFaster;
    if (auto good = frame(); !good) return good;
    troubles_->during(kiosk_->doing().saving);
    if (n % 2 == 1 && !changed_language && kiosk_->visit().screen() == screens::ScreenId::choose) {
      const screens::ScreenText reading = kiosk_->visit().reading();
      const auto other = std::ranges::find_if(reading.controls, [&](const screens::Control& c) {
        return reading.over == "languages" ? c.on == false : c.id == "language";
      });
      if (other != reading.controls.end()) {
        changed_language = reading.over == "languages";
        rehearsal::touch_at(kiosk_->visit(), other->rect.x + other->rect.w / 2,
                            other->rect.y + other->rect.h / 2, now_);
        continue;
      }
    }
    if (n % kWalksAway == kWalksAway - 1 && visitor_->throwing() && visitor_->progress() > 0.5) {
      if (auto good = walk_away(); !good) return good;
      troubles_->after();
      return {};
    }
    const auto good = visitor_->step(now_);
    if (!good) {
      const exhibit::KeptVisit* const kept = kiosk_->doing().kept;
      const bool refused = kept && kept->saved && !*kept->saved;
      if (!refused) dead_end(good.error().what);
      break;
    }
    if (real_ - begun > kPatience) {
      dead_end("it did not come to its end in " + std::to_string(static_cast<int>(kPatience)) +
               " s");
      break;
    }
  }
  look_at_keepsake();
  const bool came_home = visitor_->done();
  visitor_.reset();
  // A visitor who was told that nothing could be kept leaves too.
  if (!came_home)
    if (auto good = walk_away(); !good) return good;
  faster_ = 1;
  while (kiosk_->doing().saving)
    if (auto good = frame(); !good) return good;
  troubles_->after();
  return {};
}

/// Until the next visitor: the exhibit plays to nobody, and takes changes.
Result<void> SoakDays::rest() {
  const double until = begun_ + 3600.0 * report_.visits / plan_.visits_an_hour;
  for (int frames = 0; frames < 8 || now_ < until; ++frames) {
    now_ += std::clamp(until - now_, 0.0, kSkip);
    if (auto good = frame(); !good) return good;
    if (reload_->wanted() && kiosk_->doing().nobody_is_here) {
      if (auto good = open_anew(); !good) return good;
    }
  }
  return {};
}

void SoakDays::sample() {
  if (hours() < next_sample_) return;
  next_sample_ = hours() + kSampleEvery;
  SoakSample at;
  at.hours = hours();
  at.minutes = (real_ - real_begun_) / 60;
  at.visits = report_.visits;
  at.memory = static_cast<double>(files::resident_bytes()) / 1048576.0;
  at.in_use = static_cast<double>(files::bytes_in_use()) / 1048576.0;
  at.descriptors = count_in("/proc/self/fd");
  at.threads = count_in("/proc/self/task");
  at.keepsakes = megabytes_in(keepsakes_);
  if (const auto* loop = dynamic_cast<const loop::LoopThread*>(&kiosk_->wheel_host())) {
    const loop::LoopTiming timing = loop->timing();
    at.wake_us = timing.wake_us.since(timing_.wake_us).quantile(0.999);
    at.tick_us = timing.compute_us.since(timing_.compute_us).quantile(0.999);
    timing_ = timing;
  }
  report_.samples.push_back(at);
  if (at.hours < next_word_) return;
  next_word_ = at.hours + 1;
  std::fprintf(stderr,
               "%5.1f h  %.1f min  %d visits  %.1f MiB, %.1f in use  %d descriptors  %d threads  "
               "woken late %.0f "
               "us, a tick %.0f us at p99.9  %d kept, %d lost, %d not kept, %d dead ends\n",
               at.hours, at.minutes, at.visits, at.memory, at.in_use, at.descriptors, at.threads,
               at.wake_us, at.tick_us, report_.kept, report_.lost, report_.not_kept,
               report_.dead_ends);
}

Result<SoakReport> SoakDays::run() {
  // Leave the museum's own site alone: change and break a copy.
  const fs::path own = files::site_exhibit(plan_.config);
  if (own.empty())
    return problem(plan_.config.string(),
                   "It is not in a site, which has config and content side by side.",
                   "Give --config the exhibit.toml of a site.");
  const fs::path from = own.parent_path().parent_path(), site = plan_.folder / "site";
  std::error_code failed;
  fs::remove_all(site, failed);
  fs::create_directories(site, failed);
  for (const char* part : {"config", "content"})
    if (!failed) fs::copy(from / part, site / part, fs::copy_options::recursive, failed);
  if (failed) return problem(site.string(), failed.message(), "Make room, or give --out.", 1);
  exhibit_ = site / "config" / fs::absolute(plan_.config).filename();
  keepsakes_ = fs::absolute(plan_.folder / "keepsakes");
  options_.config = exhibit_;
  options_.keepsakes = keepsakes_;
  options_.window = plan_.window;
  options_.seed = plan_.seed;
  auto display = files::VirtualDisplay::ensure(std::max(options_.window.width, 640),
                                               std::max(options_.window.height, 480));
  if (!display) return tl::unexpected(display.error());
  reload_ = std::make_unique<exhibit::Reload>(exhibit_, exhibit::Reload::Shown::this_one);
  troubles_ = std::make_unique<SoakTroubles>(exhibit_, keepsakes_);
  real_ = real_begun_ = now_ = begun_ = files::monotonic_seconds();
  if (auto good = open(); !good) return tl::unexpected(good.error());
  while (hours() < plan_.hours) {
    if (auto good = visit(); !good) return tl::unexpected(good.error());
    if (auto good = rest(); !good) return tl::unexpected(good.error());
    sample();
  }
  look_at_all_keepsakes();
  note_ticks();
  report_.hours = hours();
  report_.minutes = (real_ - real_begun_) / 60;
  report_.troubles = troubles_->told();
  kiosk_.reset();
  files::set_wall_ahead(0);
  return report_;
}

}  // namespace

Result<SoakReport> soak_days(const SoakDaysPlan& plan) { return SoakDays(plan).run(); }

}  // namespace onggi::measure
