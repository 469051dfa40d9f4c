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

constexpr std::int64_t kLeast = AnonymisedStatistics::kLeast;
const std::string kFew = "fewer than " + std::to_string(kLeast);

std::string counted(std::int64_t number, const char* thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

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
  if (s.from.empty() && s.to.empty()) return "On all days";
  if (s.from.empty()) return "Up to " + s.to;
  return "From " + s.from + (s.to.empty() ? " on" : " to " + s.to);
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
  if (table.too_few && table.left_out == 0)
    text += "  Not shown: a line would be about " + kFew + " people.\n";
  if (table.left_out > 0)
    text += "  " + std::to_string(table.left_out) + " more not shown: a line would be about " +
            kFew + " people.\n";
  return text;
}

/// False for an exhibit without missions, which needs no line that nobody chose one.
bool any_named(const AnonymisedStatistics::Lines& table) {
  return table.too_few || std::any_of(table.lines.begin(), table.lines.end(),
                                      [](const Line& line) { return !line.name.empty(); });
}

/// A sentence; with the reason where a figure is left out: it, or what it lacks to the whole, is
/// about a few.
std::string kept_words(const AnonymisedStatistics& s) {
  if (s.all.kept) return "They kept " + counted(*s.all.kept, "pot") + ".";
  return "How many pots they kept is not shown: " + kFew + " were kept, or all but " + kFew + ".";
}

/// Empty if no phone ever fetched a keepsake: most kiosks have no phone page.
std::string fetched_words(const AnonymisedStatistics& s) {
  if (!s.fetched)
    return " How many were opened on a phone is not shown: it would be about " + kFew + " people.";
  if (*s.fetched == 0) return {};
  return " Phones opened " + counted(*s.fetched, "keepsake") + ".";
}

std::string brief_words(const AnonymisedStatistics& s) {
  if (s.brief && *s.brief == 0) return {};
  return (s.brief ? std::to_string(*s.brief) : "Fewer than " + std::to_string(kLeast)) +
         " more only touched the screen in passing.\n";
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
  std::string text = days_of(s) + ", ";
  if (!s.all.visits) return text + kFew + " people played.\n";
  if (*s.all.visits == 0) return text + "nobody played.\n";
  text += std::to_string(*s.all.visits) + " people played, half of them for more than " +
          text_or(s.median_min, "-") + " minutes.\nAll together they played for " +
          text_or(s.all.active_min, "-") + " minutes, " + text_or(s.throwing_min, "-") +
          " of them at the wheel.\nThey began " + counted(s.pots.value_or(0), "pot") + ". " +
          kept_words(s) + fetched_words(s) + "\n";
  if (s.all.likeness)
    text += "Their pots reached " + text_of(*s.all.likeness) + " of 100 points on average.\n";
  text += brief_words(s);
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
