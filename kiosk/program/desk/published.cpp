#include "kiosk/program/desk/published.h"

#include <chrono>
#include <cstdio>
#include <limits>
#include <string>

namespace onggi::desk {

bool is_day(const std::string& day) {
  if (day.empty()) return true;
  int y = 0, m = 0, d = 0, end = 0;
  if (day.size() != 10 || day.find_first_not_of("0123456789-") != std::string::npos ||
      day.front() == '-' || std::sscanf(day.c_str(), "%4d-%2d-%2d%n", &y, &m, &d, &end) != 3 ||
      end != 10)
    return false;
  return std::chrono::year_month_day{std::chrono::year(y),
                                     std::chrono::month(static_cast<unsigned>(m)),
                                     std::chrono::day(static_cast<unsigned>(d))}
      .ok();
}

drawing::Plot plot_of(const store::AnonymisedStatistics& s) {
  constexpr std::size_t kMostDays = 45;
  std::string step = "day";
  for (const auto& table : s.tables)
    if (table.name == "day" && table.lines.size() > kMostDays) step = "month";
  drawing::Plot plot;
  plot.title = "Visits per " + step;
  plot.subtitle =
      "Counts below " + std::to_string(store::AnonymisedStatistics::kLeast) + " are not shown.";
  plot.x.label = step;
  plot.y.label = "visits";
  drawing::PlotSeries visits{.name = "visits", .kind = drawing::PlotSeries::Kind::bars};
  drawing::PlotSeries kept{.name = "with a keepsake", .kind = drawing::PlotSeries::Kind::bars};
  for (const auto& table : s.tables) {
    if (table.name != step) continue;
    for (const auto& line : table.lines) {
      plot.x.names.push_back(step == "day" ? line.name.substr(5) : line.name);
      const double nothing = std::numeric_limits<double>::quiet_NaN();
      visits.y.push_back(line.visits ? static_cast<double>(*line.visits) : nothing);
      kept.y.push_back(line.kept ? static_cast<double>(*line.kept) : nothing);
    }
  }
  if (visits.y.empty()) {
    const bool none = s.all.visits == 0;
    plot.notes.push_back({0.0, 0.0, none ? "No visits in these days." : "Too few visits to show."});
    return plot;
  }
  plot.series = {visits, kept};
  return plot;
}

}  // namespace onggi::desk
