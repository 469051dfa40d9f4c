#include "kiosk/keepsake/souvenir/room.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::souvenir {
namespace {

constexpr std::uintmax_t kUsual = 8'000'000;  // bytes: a keepsake has no more, but for a long visit

std::uintmax_t of_a_page(const Room& room) {
  return room.pages == 0 ? kUsual : std::max(kUsual, room.promised / room.pages);
}

std::string mb(std::uintmax_t bytes) { return std::to_string((bytes + 500'000) / 1'000'000); }

}  // namespace

// The next page is promised before its size is known, while another keepsake may be on its way.
bool Room::for_a_page() const { return promised + 2 * of_a_page(*this) <= quota; }

std::size_t Room::pages_left() const {
  if (!for_a_page()) return 0;
  return static_cast<std::size_t>((quota - promised) / of_a_page(*this)) - 1;
}

Room room_in(const std::filesystem::path& folder, const KeepsakeLimits& limits, std::time_t now) {
  Room room;
  room.quota = static_cast<std::uintmax_t>(std::max(limits.quota_mb, 0)) * 1'000'000;
  const std::set<std::string> promised = Passes(folder).promised(now);
  for (const VisitOnDisk& visit : visits_in(folder)) {
    room.held += visit.bytes;
    if (!promised.contains(visit.folder.filename().string())) continue;
    room.promised += visit.bytes;
    ++room.pages;
  }
  return room;
}

std::optional<Problem> warning_of(const Room& room, double hours) {
  if (2 * room.promised < room.quota && room.for_a_page()) return {};
  const std::string now = "The pages of " + std::to_string(room.pages) +
                          " visitors, promised for " + std::to_string(std::lround(hours)) +
                          " hours, hold " + mb(room.promised) + " of " + mb(room.quota) + " MB. ";
  const std::string then = room.for_a_page()
                               ? "There is room for " + std::to_string(room.pages_left()) +
                                     " more; after that visitors get no page until older pages end."
                               : "So visitors get no page on their phones until older pages end.";
  const std::uintmax_t enough = 2 * std::max(room.promised, 2 * of_a_page(room)) + 1'000'000;
  return Problem{"[keepsake] quota_mb", now + then,
                 "Write at least " + mb(enough) +
                     " there, if the disk has as much, or fewer hours "
                     "below [phone]."};
}

}  // namespace onggi::souvenir
