#include "engine/base/nearest_name.h"

#include <algorithm>
#include <cstddef>

namespace onggi {
namespace {

// Longer than any key; keeps a hostile file from costing length squared.
constexpr std::size_t kLongestName = 64;

std::string plain(std::string_view word) {
  std::string out(word);
  for (char& c : out) {
    if (c == '-') c = '_';
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

/// Optimal string alignment distance: insert, delete, replace, or swap two neighbours.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view word, std::span<const std::string_view> names) {
  if (word.empty() || word.size() > kLongestName) return "";
  const std::string wanted = plain(word);
  std::string best;
  std::size_t best_distance = wanted.size() / 3 + 1;
  for (const std::string_view name : names) {
    if (name.size() > kLongestName) continue;
    const std::size_t distance = edit_distance(wanted, plain(name));
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  return nearest_name(word, std::vector<std::string_view>(names.begin(), names.end()));
}

}  // namespace onggi
