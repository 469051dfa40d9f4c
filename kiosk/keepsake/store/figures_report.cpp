#include "kiosk/keepsake/store/figures_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <utility>

#include "engine/base/plain_text.h"

namespace onggi::store {

namespace {

using files::Json;
using Line = AnonymisedStatistics::Line;

double tenth(double value) { return std::round(10.0 * value) / 10.0; }

std::string text_of(double value) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

template <class Figure>
Json json_or_null(const std::optional<Figure>& value) {
  if (!value) return {};
  if constexpr (std::is_same_v<Figure, double>)
    return tenth(*value);
  else
    return *value;
}

template <class Figure>
std::string text_or(const std::optional<Figure>& value, const char* otherwise) {
  if (!value) return otherwise;
  if constexpr (std::is_same_v<Figure, double>)
    return text_of(*value);
  else
    return std::to_string(*value);
}

void put_line(Json& json, const Line& line) {
  json["visits"] = json_or_null(line.visits);
  json["keepsakes"] = json_or_null(line.kept);
  json["active_minutes"] = json_or_null(line.active_min);
  json["likeness"] = json_or_null(line.likeness);
}

std::string csv_cell(std::string text) {
  if (!text.empty() && std::string("=+-@\t\r").find(text[0]) != std::string::npos)
    text.insert(0, 1, '\'');
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string csv_line(const std::string& table, const Line& line, const std::string& fetched = {}) {
  return table + ',' + csv_cell(line.name) + ',' + text_or(line.visits, "") + ',' +
         text_or(line.kept, "") + ',' + text_or(line.active_min, "") + ',' +
         text_or(line.likeness, "") + ',' + fetched + '\n';
}

std::string days_of(const AnonymisedStatistics& s) {
  if (s.from.empty() && s.to.empty()) return "all days";
  if (s.from.empty()) return "up to " + s.to;
  return s.to.empty() ? "from " + s.from : s.from + " to " + s.to;
}

std::string put_table(const AnonymisedStatistics::Lines& table, const char* title) {
  if (table.lines.empty() && !table.too_few) return {};
  std::string text = std::string("\n") + title + '\n';
  for (const Line& line : table.lines) {
    if (!line.visits) continue;
    char row[160];
    std::snprintf(row, sizeof row, " %7s visits %7s kept %9s min  likeness %s\n",
                  text_or(line.visits, "-").c_str(), text_or(line.kept, "-").c_str(),
                  text_or(line.active_min, "-").c_str(), text_or(line.likeness, "-").c_str());
    text += "  " + terminal::column(line.name.empty() ? "(none chosen)" : line.name, 24) + row;
  }
  if (table.too_few && table.left_out == 0) text += "  Left out: too few to show.\n";
  if (table.left_out > 0)
    text += "  and " + std::to_string(table.left_out) + " more, left out: too few to show.\n";
  return text;
}

/// False for an exhibit without missions, which needs no line that nobody chose one.
bool any_named(const AnonymisedStatistics::Lines& table) {
  return table.too_few || std::any_of(table.lines.begin(), table.lines.end(),
                                      [](const Line& line) { return !line.name.empty(); });
}

/// Empty if no phone ever fetched a keepsake: most kiosks have no phone page.
std::string fetched_words(const AnonymisedStatistics& s) {
  if (!s.fetched) return ", and too few to show were opened on a phone";
  if (*s.fetched == 0) return {};
  return "; " + std::to_string(*s.fetched) + " keepsakes were opened on a phone";
}

}  // namespace

Json json_of(const AnonymisedStatistics& s) {
  Json json =
      Json::object({{"from", s.from}, {"to", s.to}, {"least", AnonymisedStatistics::kLeast}});
  put_line(json, s.all);
  json["brief"] = json_or_null(s.brief);
  json["pots"] = json_or_null(s.pots);
  json["fetched_by_phone"] = json_or_null(s.fetched);
  json["median_minutes"] = json_or_null(s.median_min);
  json["throwing_minutes"] = json_or_null(s.throwing_min);
  Json tables = Json::object();
  for (const auto& table : s.tables) {
    Json lines = Json::list();
    for (const Line& line : table.lines) {
      Json one = Json::object({{"name", line.name}});
      put_line(one, line);
      lines.push_back(std::move(one));
    }
    tables[table.name] = std::move(lines);
  }
  json["tables"] = std::move(tables);
  return json;
}

std::string csv_of(const AnonymisedStatistics& s) {
  std::string text = "table,name,visits,keepsakes,active_minutes,likeness,fetched_by_phone\n";
  text += csv_line("all", s.all, text_or(s.fetched, ""));
  for (const auto& table : s.tables)
    for (const Line& line : table.lines) text += csv_line(table.name, line);
  return text;
}

std::string words_of(const AnonymisedStatistics& s) {
  std::string text = "Visits, " + days_of(s) + ": ";
  if (!s.all.visits) return text + "too few to show.\n";
  if (*s.all.visits == 0) return text + "none.\n";
  text += std::to_string(*s.all.visits) + " visitors were active for " +
          text_or(s.all.active_min, "-") + " minutes in all, half of them for more than " +
          text_or(s.median_min, "-") + ". They spent " + text_or(s.throwing_min, "-") +
          " minutes at the wheel. They began " + text_or(s.pots, "-") + " pots and kept " +
          text_or(s.all.kept, "too few to show") + " (likeness " + text_or(s.all.likeness, "-") +
          " of 100 on average)" + fetched_words(s) + ". " + text_or(s.brief, "Few") +
          " more only touched the screen in passing.\n";
  constexpr std::pair<const char*, const char*> kTold[] = {
      {"vessel", "Vessels"},       {"mission", "Missions"},   {"reached", "How far they came"},
      {"left", "Where they left"}, {"ended", "How it ended"}, {"language", "Language"},
      {"way", "How they played"}};
  for (const auto& [name, title] : kTold)
    for (const auto& table : s.tables)
      if (table.name == name && (table.name != "mission" || any_named(table)))
        text += put_table(table, title);
  return text;
}

}  // namespace onggi::store
