#include "kiosk/keepsake/store/anonymised_statistics.h"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace onggi::store {

namespace {

constexpr std::int64_t kLeastPeople = AnonymisedStatistics::kLeast;

using Lines = std::vector<std::size_t>;  // of a table, by their numbers
using Share = std::int64_t Cell::*;

bool is_few(std::int64_t count) { return count > 0 && count < kLeastPeople; }

std::optional<std::int64_t> told(std::int64_t count) {
  return is_few(count) ? std::nullopt : std::optional(count);
}

/// A share may be published only if both groups, with and without it, are large enough.
bool is_share_told(const Cell& cell, Share share) {
  return !is_few(cell.*share) && !is_few(cell.visits - cell.*share);
}

/// Some counts of people are suppressed, but their sum is known: does it reveal one of them? If
/// there are no more people than counts, and no count is zero, each is one.
bool gives_away(std::int64_t together, std::int64_t number, std::int64_t least) {
  return number > 0 && (number < 2 || together < least || together <= number);
}

/// A table, and what is suppressed in each line.
struct Screened {
  explicit Screened(const Table& of)
      : table(&of), visits(of.cells.size()), kept(visits), judged(visits), unnamed(visits) {}
  const Cell& cell(std::size_t n) const { return table->cells[n]; }
  const Table* table;
  std::vector<bool> visits, kept, judged;
  std::vector<bool> unnamed;  ///< Even the line's name is suppressed.
};

/// Screens lines whose visits add up to a published figure.
void screen_visits(Screened& s, const Lines& lines) {
  std::vector<std::int64_t> counts;
  std::vector<bool> seeds;
  for (const std::size_t n : lines) {
    counts.push_back(s.cell(n).visits);
    seeds.push_back(s.visits[n]);
  }
  const std::vector<bool> out = left_out(counts, kLeastPeople, seeds);
  std::int64_t together = 0, number = 0;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    s.visits[lines[n]] = out[n];
    together += out[n] ? counts[n] : 0;
    number += out[n] ? 1 : 0;
  }
  // No line is left that could hide the others.
  if (!gives_away(together, number, kLeastPeople)) return;
  for (const std::size_t n : lines) s.visits[n] = s.unnamed[n] = true;
}

/// Screens lines whose shares add up to that of `whole`. A share is suppressed with its line or if
/// it may not be published, then for the smallest lines, until the suppressed ones together have
/// enough people with and without it. If nobody or everybody has it, publishing the whole reveals
/// every line.
void screen_share(const Screened& s, std::vector<bool>& out, const Lines& lines, Share share,
                  const Cell& whole, bool whole_told) {
  for (const std::size_t n : lines)
    out[n] = out[n] || !whole_told || s.visits[n] || !is_share_told(s.cell(n), share);
  if (!whole_told || whole.*share == 0 || whole.*share == whole.visits) return;
  for (;;) {
    std::int64_t have = 0, have_not = 0;
    int number = 0;
    std::optional<std::size_t> smallest;
    for (const std::size_t n : lines) {
      if (out[n]) {
        have += s.cell(n).*share;
        have_not += s.cell(n).visits - s.cell(n).*share;
        ++number;
      } else if (!smallest || s.cell(n).visits < s.cell(*smallest).visits) {
        smallest = n;
      }
    }
    const bool enough = number >= 2 && have >= kLeastPeople && have_not >= kLeastPeople;
    if (number == 0 || enough || !smallest) return;
    out[*smallest] = true;
  }
}

struct Whole {
  const Cell* cell;
  bool visits, kept, judged;  ///< Published.
};

void screen(Screened& s, const Lines& lines, const Whole& whole) {
  if (whole.visits)
    screen_visits(s, lines);
  else
    for (const std::size_t n : lines) s.visits[n] = s.unnamed[n] = true;
  screen_share(s, s.kept, lines, &Cell::kept, *whole.cell, whole.kept);
  screen_share(s, s.judged, lines, &Cell::judged, *whole.cell, whole.judged);
}

Screened* table_named(std::vector<Screened>& all, std::string_view table) {
  for (Screened& s : all)
    if (s.table->name == table) return &s;
  return nullptr;
}

/// The days of a month add up to the month, and the months to the total.
void screen_days(Screened& days, const Screened& months) {
  for (std::size_t m = 0; m < months.table->cells.size(); ++m) {
    Lines lines;
    for (std::size_t n = 0; n < days.table->cells.size(); ++n)
      if (days.cell(n).name.starts_with(months.cell(m).name + '-')) lines.push_back(n);
    screen(days, lines, {&months.cell(m), !months.visits[m], !months.kept[m], !months.judged[m]});
  }
}

/// Line `name` is about the same visits in both tables, so both must be shown or both suppressed.
/// True if one of them changed.
bool join(Screened* one, Screened* other, const std::string& name) {
  bool changed = false;
  if (one == nullptr || other == nullptr) return false;
  const auto line_of = [&name](const Screened& s) {
    const auto& cells = s.table->cells;
    return static_cast<std::size_t>(
        std::find_if(cells.begin(), cells.end(), [&](const Cell& c) { return c.name == name; }) -
        cells.begin());
  };
  const std::size_t a = line_of(*one), b = line_of(*other);
  if (a == one->visits.size() || b == other->visits.size()) return false;
  for (auto flags : {&Screened::visits, &Screened::kept, &Screened::judged}) {
    if ((one->*flags)[a] == (other->*flags)[b]) continue;
    (one->*flags)[a] = (other->*flags)[b] = changed = true;
  }
  return changed;
}

/// A visit that a fault ended also counts as left at the fault screen; a pot that answers a
/// description appears under the same name among the vessels.
bool join_same(std::vector<Screened>& all) {
  bool changed = join(table_named(all, "left"), table_named(all, "ended"), "fault");
  Screened* const missions = table_named(all, "mission");
  if (missions == nullptr) return changed;
  for (const Cell& mission : missions->table->cells)
    if (!mission.name.empty())
      changed = join(missions, table_named(all, "vessel"), mission.name) || changed;
  return changed;
}

std::vector<Screened> screened(const Statistics& s, const Whole& all) {
  std::vector<Screened> tables(s.tables.begin(), s.tables.end());
  Screened *const months = table_named(tables, "month"), *const days = table_named(tables, "day");
  do {
    for (Screened& one : tables) {
      if (&one == days && months != nullptr) continue;
      Lines lines(one.table->cells.size());
      std::iota(lines.begin(), lines.end(), std::size_t{0});
      screen(one, lines, all);
    }
    if (days != nullptr && months != nullptr) screen_days(*days, *months);
  } while (join_same(tables));
  return tables;
}

AnonymisedStatistics::Line line_of(const Cell& cell, bool visits, bool kept, bool likeness) {
  AnonymisedStatistics::Line line;
  line.name = cell.name;
  if (!visits) return line;
  line.visits = cell.visits;
  line.active_min = cell.active_s / 60.0;
  if (kept) line.kept = cell.kept;
  if (likeness && cell.judged > 0) line.likeness = cell.likeness / static_cast<double>(cell.judged);
  return line;
}

AnonymisedStatistics::Lines lines_of(const Screened& s) {
  AnonymisedStatistics::Lines lines{s.table->name, {}, 0, false};
  std::vector<AnonymisedStatistics::Line> hidden;
  const bool in_order = lines.name == "month" || lines.name == "day" || lines.name == "hour";
  for (std::size_t n = 0; n < s.visits.size(); ++n) {
    lines.too_few = lines.too_few || s.unnamed[n];
    if (s.unnamed[n]) continue;
    auto& to = s.visits[n] && !in_order ? hidden : lines.lines;
    to.push_back(line_of(s.cell(n), !s.visits[n], !s.kept[n], !s.judged[n]));
    lines.left_out += s.visits[n] ? 1 : 0;
  }
  // Sort by name: their position would tell which has more.
  std::sort(hidden.begin(), hidden.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  lines.lines.insert(lines.lines.end(), hidden.begin(), hidden.end());
  return lines;
}

}  // namespace

std::vector<bool> left_out(const std::vector<std::int64_t>& counts, std::int64_t least,
                           std::vector<bool> out) {
  out.resize(counts.size());
  std::vector<std::size_t> order;
  std::int64_t together = 0, number = 0;
  for (std::size_t n = 0; n < counts.size(); ++n) {
    if (out[n]) {
      together += counts[n];
      ++number;
    } else if (counts[n] > 0) {
      order.push_back(n);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
  for (const std::size_t n : order) {
    if (counts[n] >= least && !gives_away(together, number, least)) break;
    out[n] = true;
    together += counts[n];
    ++number;
  }
  return out;
}

AnonymisedStatistics publish(const Statistics& s) {
  AnonymisedStatistics p;
  p.from = s.from;
  p.to = s.to;
  p.brief = told(s.brief);
  const Whole all{&s.all, !is_few(s.all.visits), is_share_told(s.all, &Cell::kept),
                  is_share_told(s.all, &Cell::judged)};
  p.all = line_of(s.all, all.visits, all.kept, all.judged);
  // Fetched keepsakes belong to kept ones, unless there are more: then some are from earlier days.
  if (all.visits && all.kept && !is_few(s.fetched) && !is_few(s.all.kept - s.fetched))
    p.fetched = s.fetched;
  if (all.visits) {
    p.pots = s.pots;
    p.throwing_min = s.throwing_s / 60.0;
    if (s.median_s) p.median_min = *s.median_s / 60.0;
  }
  for (const Screened& one : screened(s, all)) p.tables.push_back(lines_of(one));
  return p;
}

}  // namespace onggi::store
