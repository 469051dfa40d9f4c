#include "kiosk/lab/measure/soak_report.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "engine/profile/median.h"

namespace onggi::measure {

namespace {

/// The samples between two shares of the time.
std::vector<SoakSample> between(const SoakReport& report, double from, double to) {
  std::vector<SoakSample> some;
  for (const SoakSample& at : report.samples)
    if (at.hours >= from * report.hours && at.hours <= to * report.hours) some.push_back(at);
  return some;
}

template <class Of>
double median_of(const std::vector<SoakSample>& samples, const Of& of) {
  std::vector<double> values;
  for (const SoakSample& at : samples) values.push_back(of(at));
  return extraction::median(values);
}

template <class Of>
int most_of(const std::vector<SoakSample>& samples, const Of& of) {
  int most = 0;
  for (const SoakSample& at : samples) most = std::max(most, of(at));
  return most;
}

template <class Of>
double ratio(const SoakReport& report, const Of& of) {
  const double first = median_of(between(report, 0, 0.25), of);
  return first > 0 ? median_of(between(report, 0.75, 1), of) / first : 1.0;
}

/// Growth a day, after a sixth of the time.
template <class Of>
double slope(const SoakReport& report, const Of& of) {
  const auto warm = between(report, 1.0 / 6, 1);
  std::vector<double> slopes;
  for (std::size_t n = 0; n < warm.size(); ++n)
    for (std::size_t m = n + 1; m < warm.size(); ++m)
      if (warm[m].hours > warm[n].hours)
        slopes.push_back((of(warm[m]) - of(warm[n])) / (warm[m].hours - warm[n].hours) * 24.0);
  return extraction::median(slopes);
}

double memory(const SoakSample& at) { return at.memory; }
double in_use(const SoakSample& at) { return at.in_use; }
double wake(const SoakSample& at) { return at.wake_us; }
double tick(const SoakSample& at) { return at.tick_us; }
int descriptors(const SoakSample& at) { return at.descriptors; }
int threads(const SoakSample& at) { return at.threads; }

std::string words(const char* format, ...) {
  char line[512];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  return line;
}

}  // namespace

double SoakReport::memory_slope() const { return slope(*this, memory); }
double SoakReport::in_use_slope() const { return slope(*this, in_use); }

int SoakReport::more_descriptors() const {
  return most_of(between(*this, 2.0 / 3, 1), descriptors) -
         most_of(between(*this, 1.0 / 3, 2.0 / 3), descriptors);
}

int SoakReport::more_threads() const {
  return most_of(between(*this, 2.0 / 3, 1), threads) -
         most_of(between(*this, 1.0 / 3, 2.0 / 3), threads);
}

double SoakReport::wake_ratio() const { return ratio(*this, wake); }
double SoakReport::tick_ratio() const { return ratio(*this, tick); }

bool SoakReport::good() const {
  return lost == 0 && dead_ends == 0 && unexplained == 0 && more_descriptors() <= 0 &&
         more_threads() <= 0 && memory_slope() < kMostGrowth && visits > 0;
}

files::Json json_of(const SoakReport& report) {
  files::Json samples = files::Json::list();
  for (const SoakSample& at : report.samples)
    samples.push_back(files::Json::object({{"hours", at.hours},
                                           {"minutes", at.minutes},
                                           {"visits", at.visits},
                                           {"memory_mib", at.memory},
                                           {"in_use_mib", at.in_use},
                                           {"descriptors", at.descriptors},
                                           {"threads", at.threads},
                                           {"wake_p999_us", at.wake_us},
                                           {"tick_p999_us", at.tick_us},
                                           {"keepsakes_mb", at.keepsakes}}));
  return files::Json::object({{"good", report.good()},
                              {"hours", report.hours},
                              {"minutes", report.minutes},
                              {"visits", report.visits},
                              {"walked_away", report.walked_away},
                              {"kept", report.kept},
                              {"lost", report.lost},
                              {"not_kept", report.not_kept},
                              {"not_kept_unexplained", report.unexplained},
                              {"dead_ends", report.dead_ends},
                              {"memory_slope_mib_a_day", report.memory_slope()},
                              {"in_use_slope_mib_a_day", report.in_use_slope()},
                              {"more_descriptors", report.more_descriptors()},
                              {"more_threads", report.more_threads()},
                              {"wake_ratio", report.wake_ratio()},
                              {"tick_ratio", report.tick_ratio()},
                              {"ticks", report.ticks},
                              {"lost_ticks", report.lost_ticks},
                              {"troubles", files::Json::list_of(report.troubles)},
                              {"ends", files::Json::list_of(report.ends)},
                              {"samples", std::move(samples)}});
}

std::string text_of(const SoakReport& report) {
  std::string text = words(
      "%.0f hours of the museum's clock in %.0f minutes: %d visits, %d of them left half-way\n",
      report.hours, report.minutes, report.visits, report.walked_away);
  for (const std::string& trouble : report.troubles) text += "  " + trouble + "\n";
  text += words(
      "keepsakes: %d called kept, %d of them lost; %d called not kept, %d of those without "
      "cause\nvisits that ended in a dead screen: %d\n",
      report.kept, report.lost, report.not_kept, report.unexplained, report.dead_ends);
  for (const std::string& end : report.ends) text += "  " + end + "\n";
  text += words(
      "memory: %+.2f MiB a day (at most %.0f), and what of it is in use %+.2f; descriptors %+d, "
      "threads %+d\n",
      report.memory_slope(), SoakReport::kMostGrowth, report.in_use_slope(),
      report.more_descriptors(), report.more_threads());
  text += words(
      "1 kHz loop, p99.9 of the last quarter over the first: woken late %.2f, a tick %.2f; %llu of "
      "%llu ticks lost\n",
      report.wake_ratio(), report.tick_ratio(), static_cast<unsigned long long>(report.lost_ticks),
      static_cast<unsigned long long>(report.ticks));
  return text + (report.good() ? "Good.\n" : "NOT good.\n");
}

drawing::Plot plot_of(const SoakReport& report) {
  drawing::Plot plot;
  plot.title = words("%.0f hours of visits", report.hours);
  plot.subtitle = words(
      "%d visits in %.0f minutes, with troubles; memory %+.2f MiB a day; %d keepsakes called kept, "
      "%d lost",
      report.visits, report.minutes, report.memory_slope(), report.kept, report.lost);
  plot.x.label = "the museum's clock, hours";
  plot.y.label = "share of what it was after a sixth of the time";
  plot.y.log = true;
  const auto begun = between(report, 1.0 / 6, 1.0 / 3);
  const auto series = [&](const char* name, const auto& of, const char* unit) {
    const double first = median_of(begun, of);
    drawing::PlotSeries line;
    line.name = words("%s (1 is %.0f%s)", name, first, unit);
    for (const SoakSample& at : report.samples) {
      line.x.push_back(at.hours);
      line.y.push_back(first > 0 ? of(at) / first : 0.0);
    }
    plot.series.push_back(std::move(line));
  };
  // Draw constant series last, so that they lie over the others.
  series("woken late, p99.9", wake, " us");
  series("a tick, p99.9", tick, " us");
  series(
      "descriptors", [](const SoakSample& at) { return double(at.descriptors); }, "");
  series(
      "threads", [](const SoakSample& at) { return double(at.threads); }, "");
  series("in use", in_use, " MiB");
  series("memory", memory, " MiB");
  return plot;
}

}  // namespace onggi::measure
