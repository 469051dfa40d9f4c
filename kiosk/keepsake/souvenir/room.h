#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>

#include "engine/base/result.h"
#include "kiosk/keepsake/souvenir/keepsake.h"

namespace onggi::souvenir {

/// How much of the quota keepsakes take, and how much of that is promised to phones: the quota
/// never takes a keepsake whose page is promised, so new pages are promised only while there is
/// room.
struct Room {
  std::uintmax_t quota = 0;     ///< Bytes.
  std::uintmax_t held = 0;      ///< By all keepsakes.
  std::uintmax_t promised = 0;  ///< By those whose page is promised;
  std::size_t pages = 0;        ///< these.

  /// True while one more page can be promised.
  bool for_a_page() const;
  /// Pages that can still be promised, if keepsakes stay as large as they are.
  std::size_t pages_left() const;
};

/// Of the keepsakes in `folder`. Lists it and reads each pass; a worker's.
Room room_in(const std::filesystem::path& folder, const KeepsakeLimits& limits, std::time_t now);

/// What staff must know: from half the quota on, long before the last page. `hours`: of a page.
/// Where it says how much the quota must be, the half is free again.
std::optional<Problem> warning_of(const Room& room, double hours);

}  // namespace onggi::souvenir
