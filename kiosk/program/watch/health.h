#pragma once

#include <cstdint>
#include <string>

namespace onggi::watch {

/// The kiosk's health, for people who look after many kiosks.
struct Health {
  std::string version;
  bool safe_mode = false;        ///< The last good exhibit is shown after crashes.
  bool dark = false;             ///< Outside the museum's hours.
  int crashes = 0;               ///< In a row, before this run.
  double running_s = 0.0;        ///< Since the program began.
  std::uint64_t frames = 0;      ///< Frames drawn.
  std::uint64_t wakes = 0;       ///< Wakes of the 1 kHz loop,
  std::uint64_t late = 0;        ///< those over 0.5 ms late,
  std::uint64_t overruns = 0;    ///< those that missed a tick or more,
  std::uint64_t lost_ticks = 0;  ///< and dropped time, in ticks.
  double worst_wake_s = 0.0;
  std::uint64_t kept = 0;            ///< Keepsakes of this run,
  std::uint64_t not_kept = 0;        ///< and those that could not be saved.
  std::uint64_t promised_bytes = 0;  ///< Of keepsakes whose page is promised to a phone;
  std::uint64_t quota_bytes = 0;     ///< the quota holds them. 0: phones have no pages.
  bool disk_writes = true;           ///< The last trial write succeeded.
  double disk_trial_age_s = 0.0;     ///< Since the last successful trial write.
  std::uint64_t disk_free_bytes = 0;
};

/// The counts of both, and everything else from `later`.
Health together(const Health& before, const Health& later);

/// In the format of node_exporter's textfile collector (Prometheus text format 0.0.4).
std::string prometheus_text(const Health& health);

/// One line for `systemctl status`: "Open, 3 keepsakes kept, 12.0 GB free".
std::string one_line(const Health& health);

}  // namespace onggi::watch
