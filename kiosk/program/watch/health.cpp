#include "kiosk/program/watch/health.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace onggi::watch {

namespace {

class Metrics {
 public:
  Metrics() { text_ << std::fixed; }  // a day of running must not print as 8.6e+04
  template <class Value>
  void put(const char* name, const char* type, const char* help, Value value) {
    text_ << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n'
          << name << ' ' << value << '\n';
  }
  /// A label's value must not hold a quote, backslash or new line.
  void put_version(const std::string& version) {
    text_ << "# HELP onggi_info The program's version.\n# TYPE onggi_info gauge\n"
          << "onggi_info{version=\"" << version << "\"} 1\n";
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

}  // namespace

Health together(const Health& before, const Health& later) {
  Health all = later;
  all.frames += before.frames;
  all.wakes += before.wakes;
  all.late += before.late;
  all.overruns += before.overruns;
  all.lost_ticks += before.lost_ticks;
  all.worst_wake_s = std::max(before.worst_wake_s, later.worst_wake_s);
  all.kept += before.kept;
  all.not_kept += before.not_kept;
  return all;
}

std::string prometheus_text(const Health& h) {
  Metrics m;
  m.put_version(h.version);
  m.put("onggi_safe_mode", "gauge", "1 while the last good exhibit is shown after crashes.",
        h.safe_mode ? 1 : 0);
  m.put("onggi_dark", "gauge", "1 outside of the museum's opening hours.", h.dark ? 1 : 0);
  m.put("onggi_crashes_in_a_row", "gauge", "Runs before this one that crashed at their start.",
        h.crashes);
  m.put("onggi_running_seconds", "gauge", "Since the program began.", h.running_s);
  m.put("onggi_frames_total", "counter", "Pictures made.", h.frames);
  m.put("onggi_loop_wakes_total", "counter", "Times that the 1 kHz loop woke.", h.wakes);
  m.put("onggi_loop_late_total", "counter", "Wakes over 0.5 ms late.", h.late);
  m.put("onggi_loop_overruns_total", "counter", "Wakes that missed a tick or more.", h.overruns);
  m.put("onggi_loop_lost_ticks_total", "counter", "Ticks given up for good.", h.lost_ticks);
  m.put("onggi_loop_worst_wake_seconds", "gauge", "The latest wake so far.", h.worst_wake_s);
  m.put("onggi_keepsakes_total", "counter", "Keepsakes kept in this run.", h.kept);
  m.put("onggi_keepsakes_failed_total", "counter", "Keepsakes that could not be kept.", h.not_kept);
  m.put("onggi_pages_promised_bytes", "gauge", "Keepsakes whose page is promised to a phone.",
        h.promised_bytes);
  m.put("onggi_keepsakes_quota_bytes", "gauge", "What the quota holds; 0 without pages.",
        h.quota_bytes);
  m.put("onggi_disk_writes", "gauge", "1 when the last trial write came through.",
        h.disk_writes ? 1 : 0);
  m.put("onggi_disk_trial_age_seconds", "gauge", "Since a trial write came through.",
        h.disk_trial_age_s);
  m.put("onggi_disk_free_bytes", "gauge", "Free where keepsakes lie.", h.disk_free_bytes);
  return m.text();
}

std::string one_line(const Health& h) {
  char pages[80] = "";
  if (h.quota_bytes > 0 && 2 * h.promised_bytes >= h.quota_bytes)
    std::snprintf(
        pages, sizeof pages, ", pages for phones hold %.0f %% of the quota",
        100.0 * static_cast<double>(h.promised_bytes) / static_cast<double>(h.quota_bytes));
  char text[240];
  std::snprintf(text, sizeof text, "%s, %llu keepsakes kept, %.1f GB free%s%s",
                h.safe_mode ? "Safe mode: the last good exhibit is shown"
                : h.dark    ? "Dark until the museum opens"
                            : "Open",
                static_cast<unsigned long long>(h.kept),
                static_cast<double>(h.disk_free_bytes) * 1e-9, pages,
                h.disk_writes ? "" : ", but the disk cannot be written");
  return text;
}

}  // namespace onggi::watch
