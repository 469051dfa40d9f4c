#include "kiosk/program/watch/watchdog_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/program/watch/last_good.h"
#include "kiosk/program/watch/service.h"

namespace fs = std::filesystem;

namespace onggi::watch {

namespace {

/// systemd waits for all of WatchdogSec. Feeding at a third of it survives one lost datagram.
constexpr double kFeedShare = 1.0 / 3.0;
/// A part that has stopped for half of it is stuck, so a hang is found within one and a half
/// WatchdogSec.
constexpr double kPatienceShare = 0.5;
constexpr double kPatience = 5.0;  // without systemd
constexpr const char* kTrial = ".trial";

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// The process may be healthy while the disk is not, so test the disk.
Result<void> trial_write(const fs::path& folder) {
  if (auto made = files::make_folder(folder); !made) return made;
  return files::write_durably(folder / kTrial, as_bytes("a trial\n"));
}

}  // namespace

WatchdogThread::WatchdogThread(WatchdogOptions options, RunHistory& history)
    : options_(std::move(options)),
      history_(history),
      liveness_(options_.watchdog_s > 0 ? kPatienceShare * options_.watchdog_s : kPatience),
      thread_([this] { attend(); }) {}

WatchdogThread::~WatchdogThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void WatchdogThread::shows(Shown shown) {
  const std::lock_guard lock(mutex_);
  shown_ = std::move(shown);
  shown_at_ = std::max(now_, 0.0);
}

void WatchdogThread::look(const Moves& moves, const Health& health, double now) {
  if (began_ < 0) began_ = now;
  const bool beats = liveness_.beats(moves, now);
  if (const std::string stands = liveness_.standing(); stands != stood_) {
    remark(stands.empty() ? "Everything runs again." : "Stopped: " + stands + ".");
    stood_ = stands;
  }
  if (!said_ready_) {
    said_ready_ = true;
    Service::ready();
  }
  if (beats && options_.watchdog_s > 0 && now - fed_ >= kFeedShare * options_.watchdog_s) {
    fed_ = now;
    Service::alive();
  }
  // The thread holds the lock only to copy a few bytes, never during disk work.
  const std::lock_guard lock(mutex_);
  health_ = health;
  now_ = now - began_;
}

std::vector<std::string> WatchdogThread::remarks() {
  const std::lock_guard lock(mutex_);
  return std::exchange(remarks_, {});
}

void WatchdogThread::remark(std::string line) {
  const std::lock_guard lock(mutex_);
  remarks_.push_back(std::move(line));
}

void WatchdogThread::attend() {
  const double least = std::min({options_.health_every, options_.trial_every, 1.0});
  std::unique_lock lock(mutex_);
  while (!ending_) {
    if (now_ >= 0.0) {
      const Shown shown = shown_;
      const Health health = health_;
      const double now = now_, shown_for = now_ - shown_at_;
      lock.unlock();
      attend_once(shown, health, now, shown_for);
      lock.lock();
    }
    wake_.wait_for(lock, std::chrono::duration<double>(least), [this] { return ending_; });
  }
}

void WatchdogThread::try_disk(const fs::path& keepsakes, double now) {
  tried_ = now;
  const auto written = trial_write(keepsakes);
  if (written) trial_good_ = now;
  if (written.has_value() == disk_writes_) return;
  disk_writes_ = written.has_value();
  remark(written ? "The disk can be written again." : to_text(written.error()));
}

void WatchdogThread::keep_if_good(const Shown& shown, double now, double shown_for) {
  if (shown.site.empty() || shown.files == kept_ || shown_for < options_.good_after) return;
  if (now - tried_to_keep_ < options_.trial_every) return;
  tried_to_keep_ = now;
  const auto kept = keep_last_good(shown.site, shown.files, shown.keepsakes, options_.state);
  if (kept && !*kept) return;  // a change that reload refused: it may be fixed or undone
  if (!kept) {
    // Tried again with the next trial write; reported once.
    const std::string why = to_text(kept.error());
    if (std::exchange(not_kept_, why) != why) remark(why);
    return;
  }
  not_kept_.clear();
  kept_ = shown.files;
  remark("This exhibit runs well. It is saved as the last good one.");
}

void WatchdogThread::attend_once(const Shown& shown, const Health& given, double now,
                                 double shown_for) {
  if (!lasted_ && now >= RunHistory::kSteady) {
    lasted_ = true;
    if (auto good = history_.lasted(now); !good) remark(to_text(good.error()));
  }
  if (shown.keepsakes != keepsakes_) {
    keepsakes_ = shown.keepsakes;
    if (auto good = remember_keepsakes(keepsakes_, options_.state); !good)
      remark(to_text(good.error()));
  }
  if (now - tried_ >= options_.trial_every) try_disk(shown.keepsakes, now);
  keep_if_good(shown, now, shown_for);
  if (options_.health.empty() || now - wrote_health_ < options_.health_every) return;
  wrote_health_ = now;
  Health health = given;
  health.version = options_.version;
  health.safe_mode = shown.safe;
  health.crashes = history_.crashes();
  health.running_s = now;
  health.disk_writes = disk_writes_;
  health.disk_trial_age_s = trial_good_ < 0 ? now : now - trial_good_;
  std::error_code unknown;
  const auto space = fs::space(shown.keepsakes, unknown);
  if (!unknown) health.disk_free_bytes = space.available;
  Service::says(one_line(health));
  const auto written = files::write_durably(options_.health, as_bytes(prometheus_text(health)));
  if (!written && !health_failed_) remark(to_text(written.error()));
  health_failed_ = !written;
}

}  // namespace onggi::watch
