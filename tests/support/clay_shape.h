#pragma once

#include <vector>

#include "engine/clay/clay.h"

namespace onggi::test {

/// Everything that makes a pot's shape, to be compared bit for bit: radii, the rows' thickness, the
/// floor.
inline std::vector<double> exact_shape(const Clay& clay) {
  std::vector<double> all;
  for (int j = 0; j < clay.rows(); ++j) {
    all.insert(all.end(), clay.outer(j).begin(), clay.outer(j).end());
    all.insert(all.end(), clay.inner(j).begin(), clay.inner(j).end());
    all.push_back(clay.row_thickness(j));
  }
  all.push_back(clay.floor_top());
  all.push_back(clay.floor_rows());
  return all;
}

}  // namespace onggi::test
