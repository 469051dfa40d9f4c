#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/keepsake/store/statistics.h"

namespace onggi::store {

/// Statistics that a museum may publish: no figure is about fewer than kLeast people, and a
/// suppressed figure cannot be computed from the published ones: not from a table and its total,
/// not from days and their month, and not from the visits that a fault ended, which appear twice.
struct AnonymisedStatistics {
  /// Smaller groups may know each other: a class photograph, a family, one guard.
  static constexpr std::int64_t kLeast = 5;

  struct Line {
    std::string name;
    std::optional<std::int64_t> visits;  ///< Absent: suppressed, here and below.
    std::optional<std::int64_t> kept;
    std::optional<double> active_min;  ///< Sum over its visits.
    std::optional<double> likeness;    ///< Mean, 0..100.
  };
  struct Lines {
    std::string name;
    /// Lines with suppressed visits come last, by name, except for days and hours.
    std::vector<Line> lines;
    int left_out = 0;      ///< Lines whose visits are suppressed.
    bool too_few = false;  ///< There are more lines, whose names are suppressed too.
  };
  std::string from, to;
  Line all;
  std::optional<std::int64_t> brief, pots;
  /// Published only if the kept count is, and if both groups are large enough.
  std::optional<std::int64_t> fetched;
  std::optional<double> median_min, throwing_min;
  std::vector<Lines> tables;
};

/// Which counts of a table with a published total to suppress (a shorter result: none beyond its
/// end): each from 1 to least - 1, then the next larger ones, until the suppressed ones together
/// are more than one count, at least `least`, and more than one each. A zero is published, because
/// it is about nobody. Pure.
std::vector<bool> left_out(const std::vector<std::int64_t>& counts, std::int64_t least,
                           std::vector<bool> out = {});

AnonymisedStatistics publish(const Statistics& statistics);

}  // namespace onggi::store
