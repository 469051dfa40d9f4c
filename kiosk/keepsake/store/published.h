#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/keepsake/store/statistics.h"

namespace onggi::store {

/// Statistics as a museum may hand them on: no figure is about fewer than kLeast people, and none
/// that is left out can be reckoned from those that are told: not from a table and its total, not
/// from days and their month, not from the visits that a fault ended, told twice.
struct PublishedStatistics {
  /// Fewer than this could be known to each other: a class photograph, a family, one guard.
  static constexpr std::int64_t kLeast = 5;

  struct Line {
    std::string name;
    std::optional<std::int64_t> visits;  ///< Nothing: left out, here and below.
    std::optional<std::int64_t> kept;
    std::optional<double> active_min;  ///< All of theirs.
    std::optional<double> likeness;    ///< Mean, 0..100.
  };
  struct Lines {
    std::string name;
    std::vector<Line> lines;  ///< Those without visits last, by name, but for days and hours.
    int left_out = 0;         ///< Lines without visits.
    bool too_few = false;     ///< There are further lines that are not even named.
  };
  std::string from, to;
  Line all;
  std::optional<std::int64_t> brief, pots;
  std::optional<std::int64_t> fetched;  ///< Told where what was kept is, and of neither few.
  std::optional<double> median_min, throwing_min;
  std::vector<Lines> tables;
};

/// Which of one table's counts are left out, whose total is told: `out` (shorter: none beyond),
/// each from 1 to least - 1; and then the next larger ones, until what is left out together is no
/// single count, at least `least`, and more than one each. A zero is told: it is about nobody.
/// Pure.
std::vector<bool> left_out(const std::vector<std::int64_t>& counts, std::int64_t least,
                           std::vector<bool> out = {});

PublishedStatistics publish(const Statistics& statistics);

}  // namespace onggi::store
