#pragma once

#include <string>

#include "kiosk/keepsake/store/anonymised_statistics.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::desk {

/// True for "" and for a day of the calendar, as "2026-05-31".
bool is_day(const std::string& text);

/// Visits per day, or per month if there are too many days; suppressed counts are gaps.
drawing::Plot plot_of(const store::AnonymisedStatistics& s);

}  // namespace onggi::desk
