#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/keepsake/store/database.h"

namespace onggi::store {

/// One line of a table: the visits that have `name` in common.
struct Cell {
  std::string name;
  std::int64_t visits = 0;
  std::int64_t kept = 0;    ///< Of them with a keepsake.
  double active_s = 0.0;    ///< All of theirs.
  std::int64_t judged = 0;  ///< Of them with a pot that was called done,
  double likeness = 0.0;    ///< and the sum of its likeness, 0..100.
  friend bool operator==(const Cell&, const Cell&) = default;
};

struct Table {
  std::string name;  ///< "vessel", "mission", "left", "language", "way", "reached", "ended",
                     ///< "month", "day", "hour".
  std::vector<Cell> cells;
};

/// All figures of some days, exactly as counted: not for anybody outside (PublishedStatistics).
struct Statistics {
  std::string from, to;  ///< Local days, both counted; "": without that end.
  std::int64_t brief =
      0;     ///< Touches shorter than kBrief, which are no visit and count nowhere else.
  Cell all;  ///< Of every visit; without a name.
  std::int64_t pots = 0;  ///< Lumps begun.
  double throwing_s = 0.0;
  std::int64_t fetched = 0;        ///< Keepsakes that were opened on a phone on those days.
  std::optional<double> median_s;  ///< Of a visit's active time; nothing where there is no visit.
  std::vector<Table> tables;

  static constexpr double kBrief = 3.0;  ///< s
};

/// Reads the visits of `from` .. `to`. Each table is by visits, most first, months, days and hours
/// in their order. Problem: the file is not what a store writes.
Result<Statistics> read_statistics(Database& database, const std::string& from,
                                   const std::string& to);

/// Reads the same out of the store at `file`, which another onggi may be writing at the time: from
/// a copy of it, made anew until it is whole. Problem: there is none, or no whole copy was had.
Result<Statistics> read_statistics(const std::string& file, const std::string& from,
                                   const std::string& to);

}  // namespace onggi::store
