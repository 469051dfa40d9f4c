#include "kiosk/store/published.h"

#include <algorithm>

namespace onggi::store {

namespace {

constexpr std::int64_t kLeastPeople = PublishedStatistics::kLeast;

std::optional<std::int64_t> told(std::int64_t count) {
  return count > 0 && count < kLeastPeople ? std::nullopt : std::optional(count);
}

PublishedStatistics::Line line_of(const Cell& cell, bool hidden, bool kept_hidden,
                                  bool likeness_hidden) {
  PublishedStatistics::Line line;
  line.name = cell.name;
  if (hidden) return line;
  line.visits = cell.visits;
  line.active_min = cell.active_s / 60.0;
  if (!kept_hidden) line.kept = cell.kept;
  if (!likeness_hidden && cell.judged > 0)
    line.likeness = cell.likeness / static_cast<double>(cell.judged);
  return line;
}

/// A share of a cell is left out with the cell, where it is small, and where all but a few have it.
std::vector<bool> share_left_out(const Table& table, const std::vector<bool>& hidden,
                                 std::int64_t Cell::*share) {
  std::vector<std::int64_t> shares, others;
  for (std::size_t n = 0; n < table.cells.size(); ++n) {
    shares.push_back(hidden[n] ? 0 : table.cells[n].*share);
    others.push_back(hidden[n] ? 0 : table.cells[n].visits - table.cells[n].*share);
  }
  std::vector<bool> out = left_out(shares, kLeastPeople);
  const std::vector<bool> rest = left_out(others, kLeastPeople);
  for (std::size_t n = 0; n < out.size(); ++n) out[n] = out[n] || rest[n] || hidden[n];
  return out;
}

}  // namespace

std::vector<bool> left_out(const std::vector<std::int64_t>& counts, std::int64_t least) {
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < counts.size(); ++n)
    if (counts[n] > 0) order.push_back(n);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
  std::vector<bool> out(counts.size(), false);
  std::int64_t together = 0;
  int number = 0;
  for (const std::size_t n : order) {
    const bool small = counts[n] < least;
    const bool gives_away = number > 0 && (number < 2 || together < least);
    if (!small && !gives_away) break;
    out[n] = true;
    together += counts[n];
    ++number;
  }
  return out;
}

PublishedStatistics publish(const Statistics& s) {
  PublishedStatistics p;
  p.from = s.from;
  p.to = s.to;
  p.brief = told(s.brief);
  const bool few = !told(s.all.visits);
  const auto share_told = [&](std::int64_t share) {
    return told(share) && told(s.all.visits - share);
  };
  p.all = line_of(s.all, few, !share_told(s.all.kept), !share_told(s.all.judged));
  if (!few) {
    p.pots = s.pots;
    p.throwing_min = s.throwing_s / 60.0;
    if (s.median_s) p.median_min = *s.median_s / 60.0;
  }
  for (const Table& table : s.tables) {
    std::vector<std::int64_t> counts;
    for (const Cell& cell : table.cells) counts.push_back(cell.visits);
    const std::vector<bool> hidden = left_out(counts, kLeastPeople);
    const std::vector<bool> kept = share_left_out(table, hidden, &Cell::kept);
    const std::vector<bool> judged = share_left_out(table, hidden, &Cell::judged);
    PublishedStatistics::Lines lines{table.name, {}, 0};
    for (std::size_t n = 0; n < table.cells.size(); ++n) {
      lines.lines.push_back(line_of(table.cells[n], hidden[n], kept[n], judged[n]));
      lines.left_out += hidden[n] ? 1 : 0;
    }
    p.tables.push_back(std::move(lines));
  }
  return p;
}

}  // namespace onggi::store
