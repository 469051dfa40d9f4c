#include "kiosk/collection/settings/hours_table.h"

#include <array>
#include <string>

namespace onggi::settings {

namespace {

using Table = toml::TomlReader::Table;

constexpr std::array<const char*, 7> kWeek = {"monday", "tuesday",  "wednesday", "thursday",
                                              "friday", "saturday", "sunday"};
constexpr const char* kHoursRemedy =
    "Write \"10:00-18:00\", \"10:00-12:30, 14:00-18:00\" or \"closed\".";

bool read_spans_at(Table& table, const std::string& key, Hours::Spans& spans) {
  std::string text;
  if (!table.text(key, text)) return false;
  if (read_spans(text, spans)) return true;
  table.complain(key, key + " is \"" + text + "\", which cannot be read as opening hours.",
                 kHoursRemedy);
  return false;
}

}  // namespace

void read_hours(Table table, Hours& hours) {
  hours.kept = table.present();
  const bool all_days = table.has("every_day");
  const Hours::Spans open{{}};
  Hours::Spans usual = open;
  read_spans_at(table, "every_day", usual);
  for (std::size_t day = 0; day < kWeek.size(); ++day) {
    // Hours that cannot be read do not close the museum.
    hours.week[day] = table.has(kWeek[day]) ? open : usual;
    read_spans_at(table, kWeek[day], hours.week[day]);
    if (table.present() && !table.has(kWeek[day]) && !all_days)
      table.complain("", std::string("There are no hours for ") + kWeek[day] + ".",
                     std::string("Write ") + kWeek[day] + " = \"10:00-18:00\" or \"closed\", or " +
                         "every_day for all days without hours of their own.");
  }
  table.boolean("screen_off", hours.screen_off);
  Table exceptions = table.child("exceptions");
  for (const std::string& date : exceptions.keys()) {
    Hours::Spans spans;
    if (!read_spans_at(exceptions, date, spans)) continue;
    if (is_date(date))
      hours.exceptions[date] = spans;
    else
      exceptions.complain(date, "\"" + date + "\" is not a valid date.",
                          "Write \"2026-12-24\", or \"12-24\" for every year.");
  }
  exceptions.finish();
  table.finish();
}

}  // namespace onggi::settings
