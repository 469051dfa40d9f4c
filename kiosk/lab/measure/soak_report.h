#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/ground/files/json.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::measure {

/// The state of a kiosk between two visits.
struct SoakSample {
  double hours = 0;    ///< Of the museum's clock, since it began.
  double minutes = 0;  ///< Of real time.
  int visits = 0;
  double memory = 0;     ///< MiB resident,
  double in_use = 0;     ///< and the part that is allocated and not freed; 0: not known here.
  int descriptors = 0;   ///< Open.
  int threads = 0;       ///< Of the program.
  double wake_us = 0;    ///< Delay of the 1 kHz loop's wakes at p99.9, since the last sample,
  double tick_us = 0;    ///< and the duration of a tick.
  double keepsakes = 0;  ///< MB in their folder.
};

/// The result of days of visits.
struct SoakReport {
  double hours = 0, minutes = 0;  ///< As SoakSample's.
  std::vector<SoakSample> samples;
  int visits = 0, walked_away = 0;
  int kept = 0;                       ///< Keepsakes reported as kept to a visitor,
  int lost = 0;                       ///< and those of them that were later missing or incomplete.
  int not_kept = 0;                   ///< Visitors who were told that their pot could not be kept.
  int dead_ends = 0;                  ///< Visits that ended in a state without a way on.
  int unexplained = 0;                ///< The part of not_kept while disk and helper were fine.
  std::vector<std::string> ends;      ///< How each dead end came about.
  std::vector<std::string> troubles;  ///< The troubles, with their number: "12 x ...".
  std::uint64_t lost_ticks = 0, ticks = 0;

  /// MiB a day of the museum's clock: the median of all slopes between two samples (Theil 1950, Sen
  /// 1968) after a sixth of the time, when fonts, texts and drivers have filled their caches.
  double memory_slope() const;
  /// The same for allocated memory; growth only in total memory comes from gaps and files.
  double in_use_slope() const;
  /// The largest of the last third minus the largest of the third before.
  int more_descriptors() const;
  int more_threads() const;
  /// The median of p99.9 in the last quarter divided by that in the first.
  double wake_ratio() const;
  double tick_ratio() const;
  /// True if nothing was lost, and there was no dead end, no refusal without cause, no growth of
  /// descriptors or threads, and memory growth under kMostGrowth. The loop's ratios are reported
  /// but not judged, because they depend as much on the machine.
  bool good() const;
  static constexpr double kMostGrowth = 1.0;  ///< MiB a day.
};

files::Json json_of(const SoakReport& report);
std::string text_of(const SoakReport& report);
/// Memory, descriptors, threads and the loop's p99.9 over the museum's hours, each relative to its
/// value at a sixth of the time.
drawing::Plot plot_of(const SoakReport& report);

}  // namespace onggi::measure
