#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace onggi {

/// The name in `names` nearest to `word` by edit distance (a swap of neighbours counts one, case
/// and '-' for '_' nothing), if within a third of the word's length; else "". The first of those
/// that are equally near. Allocates.
std::string nearest_name(std::string_view word, std::span<const std::string_view> names);
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

/// The names with commas between them, for a remedy: "rib, wire". Allocates.
template <class Names>
std::string joined(const Names& names) {
  std::string all;
  for (const auto& name : names) all.append(all.empty() ? "" : ", ").append(name);
  return all;
}

}  // namespace onggi
