#include "kiosk/visit/screens/todays_pot.h"

#include <algorithm>

namespace onggi::screens {

int number_today(const std::vector<TodaysPot>& todays, const std::string& visit) {
  const auto own = std::find_if(todays.begin(), todays.end(),
                                [&](const TodaysPot& pot) { return pot.visit == visit; });
  if (own == todays.end() || todays.size() >= kMostTodays) return 0;
  return static_cast<int>(std::count_if(
      own, todays.end(), [&](const TodaysPot& pot) { return pot.vessel == own->vessel; }));
}

}  // namespace onggi::screens
