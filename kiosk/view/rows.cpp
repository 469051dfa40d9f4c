#include "kiosk/view/rows.h"

#include <algorithm>

namespace onggi::view {

std::vector<RowUpdate> rows_of(const Profile& profile, const GridShape& shape) {
  std::vector<RowUpdate> rows(static_cast<std::size_t>(std::max(shape.rows, 0)));
  const auto sectors = static_cast<std::size_t>(std::max(shape.sectors, 0));
  for (int j = 0; j < shape.rows; ++j) {
    const double h = (j + 0.5) * shape.height / shape.rows;
    const auto outer = static_cast<float>(profile.outer_at(h));
    const auto inner = h < shape.floor_height ? 0.0f : static_cast<float>(profile.inner_at(h));
    RowUpdate& row = rows[static_cast<std::size_t>(j)];
    row.row = j;
    row.radii.assign(2 * sectors, outer);
    std::fill(row.radii.begin() + static_cast<std::ptrdiff_t>(sectors), row.radii.end(), inner);
  }
  return rows;
}

}  // namespace onggi::view
