#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace onggi::extraction {

/// The median of `values` by rank, the upper one of two; 0 if empty. Reorders them.
inline double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace onggi::extraction
