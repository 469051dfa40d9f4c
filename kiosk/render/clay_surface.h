#pragma once

#include <span>
#include <vector>

#include "kiosk/render/gl.h"
#include "kiosk/render/levels.h"
#include "kiosk/render/tears.h"
#include "kiosk/view/rows.h"

namespace onggi::render {

/// The clay's radii on the graphics side: two textures (outer, inner; rows x sectors), where each
/// height has its row in them, and the levels that the light needs. Only changed rows are uploaded.
/// Grids beyond kMost in a direction are kept at every n-th row or sector: finer than any screen,
/// and the engine's grid stays whole.
class ClaySurface {
 public:
  static constexpr int kMost = 2048;
  static constexpr int kHeights = 1024;

  void set_grid(const view::GridShape& shape);
  void update(std::span<const view::RowUpdate> rows);

  bool empty() const { return !seen_; }
  const view::GridShape& shape() const { return shape_; }
  int rows() const { return rows_; }
  int sectors() const { return sectors_; }
  const Texture& outer() const { return outer_; }
  const Texture& inner() const { return inner_; }
  /// Over kHeights even shares of the height, foot and rim included: the row there, as a share of
  /// the radius textures, and by how much that share grows with the share of the height.
  const Texture& row_at() const { return row_at_; }
  /// The lowest row that is no floor, as a share of the radius textures.
  float first_wall_row() const { return first_wall_row_; }
  /// Which rings are torn.
  const Tears& tears() const { return tears_; }
  /// Radius of the rim's edges, from its mean thickness, m.
  float lip() const;
  const Levels& levels() const { return levels_; }
  /// Renews the levels where rows have changed; true when they did.
  bool refresh(Texture& levels_texture);
  double max_radius() const;

 private:
  void fill(double outer, double inner);
  void stack();
  void means_of(int row, const float* outer, const float* inner);

  view::GridShape shape_;
  int rows_ = 0, sectors_ = 0, row_step_ = 1, sector_step_ = 1;
  Texture outer_, inner_, row_at_;
  std::vector<float> mean_outer_, mean_inner_, scratch_, middle_, heights_;
  float first_wall_row_ = 0;
  Levels levels_;
  Tears tears_;
  bool changed_ = false, stacked_ = false, seen_ = false;
};

}  // namespace onggi::render
