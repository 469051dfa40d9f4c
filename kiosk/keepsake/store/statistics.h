#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/keepsake/store/database.h"

namespace onggi::store {

/// One line of a table: the visits with the same `name`.
struct Cell {
  std::string name;
  std::int64_t visits = 0;
  std::int64_t kept = 0;    ///< Visits with a keepsake.
  double active_s = 0.0;    ///< Sum over its visits.
  std::int64_t judged = 0;  ///< Visits with a pot that was called done,
  double likeness = 0.0;    ///< and the sum of its likeness, 0..100.
  friend bool operator==(const Cell&, const Cell&) = default;
};

struct Table {
  std::string name;  ///< "vessel", "mission", "left", "language", "way", "reached", "ended",
                     ///< "month", "day", "hour".
  std::vector<Cell> cells;
};

/// All figures of some days, exactly as counted. Not for publication (AnonymisedStatistics).
struct Statistics {
  std::string from, to;  ///< Local days, both included; "": open end.
  std::int64_t brief =
      0;     ///< Touches shorter than kBrief, which are not visits and count nowhere else.
  Cell all;  ///< The total over all visits; without a name.
  std::int64_t pots = 0;  ///< Pots begun.
  double throwing_s = 0.0;
  std::int64_t fetched = 0;        ///< Keepsakes opened on a phone on those days.
  std::optional<double> median_s;  ///< Median active time of a visit; absent without visits.
  std::vector<Table> tables;

  static constexpr double kBrief = 3.0;  ///< s
};

/// Reads the visits of `from` .. `to`. Tables are sorted by visits, most first; months, days and
/// hours by time. Problem: the file is not a valid store.
Result<Statistics> read_statistics(Database& database, const std::string& from,
                                   const std::string& to);

/// Reads the same from the store at `file`, which another onggi may be writing, through a copy that
/// is repeated until it is complete. Problem: there is no store, or no complete copy was possible.
Result<Statistics> read_statistics(const std::string& file, const std::string& from,
                                   const std::string& to);

}  // namespace onggi::store
