#pragma once

#include <cstdint>
#include <string>

namespace onggi::watch {

/// How the kiosk does, for whoever keeps many of them.
struct Health {
  std::string version;
  bool safe_mode = false;        ///< It shows the last good exhibit, after crashes.
  bool dark = false;             ///< Outside of the museum's hours.
  int crashes = 0;               ///< In a row, before this run.
  double running_s = 0.0;        ///< Since the program began.
  std::uint64_t frames = 0;      ///< Pictures made.
  std::uint64_t wakes = 0;       ///< Of the 1 kHz loop,
  std::uint64_t late = 0;        ///< over 0.5 ms late,
  std::uint64_t overruns = 0;    ///< missed a tick or more.
  std::uint64_t lost_ticks = 0;  ///< Time given up, in ticks.
  double worst_wake_s = 0.0;
  std::uint64_t kept = 0;         ///< Keepsakes of this run,
  std::uint64_t not_kept = 0;     ///< and those that the disk refused.
  bool disk_writes = true;        ///< The last trial write came through.
  double disk_trial_age_s = 0.0;  ///< Since the last trial write that came through.
  std::uint64_t disk_free_bytes = 0;
};

/// The counts of both, and `later` in all else.
Health together(const Health& before, const Health& later);

/// As node_exporter's textfile collector reads it (Prometheus text format 0.0.4).
std::string prometheus_text(const Health& health);

/// One line for `systemctl status`: "Open, 3 keepsakes kept, 12.0 GB free".
std::string one_line(const Health& health);

}  // namespace onggi::watch
