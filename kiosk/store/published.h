#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/store/statistics.h"

namespace onggi::store {

/// Statistics as a museum may hand them on: no figure is about fewer than kLeast people, nor can
/// one be had by subtracting others of the same table from its total.
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
    std::vector<Line> lines;
    int left_out = 0;  ///< Lines without visits.
  };
  std::string from, to;
  Line all;
  std::optional<std::int64_t> brief, pots;
  std::optional<double> median_min, throwing_min;
  std::vector<Lines> tables;
};

/// Which of one table's counts are left out, whose total is told: each from 1 to least - 1; and
/// then the next larger ones, until what is left out together is no single count and at least
/// `least`. A zero is told: it is about nobody. Pure.
std::vector<bool> left_out(const std::vector<std::int64_t>& counts, std::int64_t least);

PublishedStatistics publish(const Statistics& statistics);

}  // namespace onggi::store
