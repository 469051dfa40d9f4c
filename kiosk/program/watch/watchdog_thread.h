#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "kiosk/program/watch/health.h"
#include "kiosk/program/watch/liveness.h"
#include "kiosk/program/watch/run_history.h"

namespace onggi::watch {

/// The exhibit that visitors see.
struct Shown {
  std::filesystem::path site{};  ///< The site that may become the last good exhibit; empty: none.
  std::string files{};           ///< files_of(site), taken before it was opened.
  std::filesystem::path keepsakes;  ///< Folder for trial writes.
  bool safe = false;                ///< It replaces the museum's own exhibit.
};

/// Settings of the watchdog. Times in seconds.
struct WatchdogOptions {
  std::filesystem::path state;     ///< Folder for the record of runs and the last good exhibit.
  std::filesystem::path health{};  ///< File for the health; empty: none.
  std::string version;
  double watchdog_s = 0.0;   ///< Service::watchdog_s().
  double health_every = 15;  ///< Time between two writes of the health,
  double trial_every = 60;   ///< and between two trial writes.
  double good_after = 3600;  ///< Time without a crash after which an exhibit counts as good.
};

/// Watchdog for an unattended kiosk: feeds systemd's watchdog while picture and wheel run, tests
/// the disk, writes the health file, and saves a proven exhibit as the last good one. Disk work has
/// its own thread: a hanging disk is reported in the health file and never delays a frame.
class WatchdogThread {
 public:
  /// `history`: this run's, begun. Main thread.
  WatchdogThread(WatchdogOptions options, RunHistory& history);
  ~WatchdogThread();

  /// Call before the first look(), and when another exhibit opens: its trial hour begins. Main
  /// thread.
  void shows(Shown shown);
  /// Call once a frame on the main thread; `now` never goes back. Never waits.
  void look(const Moves& moves, const Health& health, double now);
  /// Messages for staff, each once: which part stopped, why the disk refused.
  std::vector<std::string> remarks();

 private:
  void attend();  ///< Runs on the watchdog's thread.
  void attend_once(const Shown& shown, const Health& health, double now, double shown_for);
  void try_disk(const std::filesystem::path& keepsakes, double now);
  void keep_if_good(const Shown& shown, double now, double shown_for);
  void remark(std::string line);

  WatchdogOptions options_;
  RunHistory& history_;
  Liveness liveness_;
  double began_ = -1.0, fed_ = -1.0;
  bool said_ready_ = false;
  std::string stood_;

  std::mutex mutex_;  // guards the members below
  std::condition_variable wake_;
  Shown shown_;
  Health health_;
  double now_ = -1.0, shown_at_ = 0.0;  ///< Since the first look; below 0: none yet.
  bool ending_ = false;
  std::vector<std::string> remarks_;

  // The thread's own members.
  double wrote_health_ = -1e9, tried_ = -1e9, trial_good_ = -1.0, tried_to_keep_ = -1e9;
  std::string kept_;                 ///< Files of the saved site,
  std::string not_kept_;             ///< why the shown one could not be saved,
  std::filesystem::path keepsakes_;  ///< and the recorded keepsake folder.
  bool disk_writes_ = true, lasted_ = false, health_failed_ = false;
  std::thread thread_;
};

}  // namespace onggi::watch
