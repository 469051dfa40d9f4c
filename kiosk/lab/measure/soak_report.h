#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/ground/files/json.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::measure {

/// A kiosk between two visits.
struct SoakSample {
  double hours = 0;    ///< Of the museum's clock, since it began.
  double minutes = 0;  ///< Of ours.
  int visits = 0;
  double memory = 0;     ///< MiB resident,
  double in_use = 0;     ///< and of it what was asked for and not freed; 0: not known here.
  int descriptors = 0;   ///< Open.
  int threads = 0;       ///< Of the program.
  double wake_us = 0;    ///< How late the 1 kHz loop woke at p99.9, since the sample before,
  double tick_us = 0;    ///< and what a tick took.
  double keepsakes = 0;  ///< MB in their folder.
};

/// What became of a kiosk in days of visits.
struct SoakReport {
  double hours = 0, minutes = 0;  ///< As SoakSample's.
  std::vector<SoakSample> samples;
  int visits = 0, walked_away = 0;
  int kept = 0;         ///< Keepsakes that a visitor was told of,
  int lost = 0;         ///< and that were not there afterwards, or not whole.
  int not_kept = 0;     ///< Visitors who were told that theirs could not be kept.
  int dead_ends = 0;    ///< Visits that ended where no visitor could go on.
  int unexplained = 0;  ///< Of not_kept: while nothing was wrong with the disk or the helper.
  std::vector<std::string> ends;      ///< How each of those came.
  std::vector<std::string> troubles;  ///< What befell it, and how often: "12 x ...".
  std::uint64_t lost_ticks = 0, ticks = 0;

  /// MiB a day of the museum's clock: the median of all slopes between two samples (Theil 1950, Sen
  /// 1968) after a sixth of the time, when fonts, texts and drivers have filled their caches.
  double memory_slope() const;
  double in_use_slope() const;  ///< Likewise: what grows in memory but not here is holes and files.
  /// The most of the last third less the most of the third before.
  int more_descriptors() const;
  int more_threads() const;
  /// The median of p99.9 in the last quarter over that in the first.
  double wake_ratio() const;
  double tick_ratio() const;
  /// Nothing lost, no dead end, no refusal without cause, no more descriptors or threads, and
  /// memory that grows by less than kMostGrowth. The loop's ratios are told and not judged: they
  /// are as much the machine's.
  bool good() const;
  static constexpr double kMostGrowth = 1.0;  ///< MiB a day.
};

files::Json json_of(const SoakReport& report);
std::string text_of(const SoakReport& report);
/// Memory, descriptors, threads and the loop's p99.9 over the museum's hours, each as a share of
/// what it was at a sixth of the time.
drawing::Plot plot_of(const SoakReport& report);

}  // namespace onggi::measure
