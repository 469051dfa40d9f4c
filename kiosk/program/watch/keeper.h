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
#include "kiosk/program/watch/pulse.h"
#include "kiosk/program/watch/run_ledger.h"

namespace onggi::watch {

/// What visitors are shown.
struct Shown {
  std::filesystem::path site{};     ///< What may become the last good exhibit; empty: nothing does.
  std::string files{};              ///< files_of(site) from before it was opened.
  std::filesystem::path keepsakes;  ///< Where trial writes go.
  bool safe = false;                ///< It stands in for the museum's.
};

/// What the keeper goes by. Times in seconds.
struct KeeperOptions {
  std::filesystem::path state;     ///< Where it remembers runs and the last good exhibit.
  std::filesystem::path health{};  ///< Where the health is written; empty: nowhere.
  std::string version;
  double watchdog_s = 0.0;   ///< Service::watchdog_s().
  double health_every = 15;  ///< Between two writes of the health,
  double trial_every = 60;   ///< and between two trial writes.
  double good_after = 3600;  ///< So long without a crash, and an exhibit is good.
};

/// Looks after a kiosk that nobody looks at: feeds systemd's watchdog while picture and wheel move,
/// tries the disk, writes the health, keeps the exhibit that has proved itself. Disk work is a
/// thread of its own: a disk that hangs costs a line of the health and no frame.
class Keeper {
 public:
  /// `ledger` of this run, begun. Main thread.
  Keeper(KeeperOptions options, RunLedger& ledger);
  ~Keeper();

  /// Before the first look(), and when another exhibit is opened: its hour begins. Main thread.
  void shows(Shown shown);
  /// Once a frame, main thread; `now` never goes back. Never waits.
  void look(const Moves& moves, const Health& health, double now);
  /// What staff should know, a line each, once: what stands, what the disk refused.
  std::vector<std::string> remarks();

 private:
  void attend();  ///< The thread's.
  void attend_once(const Shown& shown, const Health& health, double now, double shown_for);
  void try_disk(const std::filesystem::path& keepsakes, double now);
  void keep_if_good(const Shown& shown, double now, double shown_for);
  void remark(std::string line);

  KeeperOptions options_;
  RunLedger& ledger_;
  Pulse pulse_;
  double began_ = -1.0, fed_ = -1.0;
  bool said_ready_ = false;
  std::string stood_;

  std::mutex mutex_;  // guards what follows
  std::condition_variable wake_;
  Shown shown_;
  Health health_;
  double now_ = -1.0, shown_at_ = 0.0;  ///< Since the first look; below 0: there was none.
  bool ending_ = false;
  std::vector<std::string> remarks_;

  // The thread's own.
  double wrote_health_ = -1e9, tried_ = -1e9, trial_good_ = -1.0, tried_to_keep_ = -1e9;
  std::string kept_;                 ///< Files of the site that is kept,
  std::string not_kept_;             ///< why the one shown could not be,
  std::filesystem::path keepsakes_;  ///< and where keepsakes go, as it is remembered.
  bool disk_writes_ = true, lasted_ = false, health_failed_ = false;
  std::thread thread_;
};

}  // namespace onggi::watch
