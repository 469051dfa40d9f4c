#pragma once

#include <span>
#include <vector>

#include "kiosk/render/gl.h"
#include "kiosk/render/levels.h"
#include "kiosk/view/rows.h"

namespace onggi::render {

/// The clay's radii on the graphics side: two textures (outer, inner; rows x sectors) and the
/// levels that the light needs. Only changed rows are uploaded. Grids beyond kMost in a direction
/// are kept at every n-th row or sector: finer than any screen, and the engine's grid stays whole.
class ClaySurface {
 public:
  static constexpr int kMost = 2048;

  void set_grid(const view::GridShape& shape);
  void update(std::span<const view::RowUpdate> rows);

  bool empty() const { return !seen_; }
  const view::GridShape& shape() const { return shape_; }
  int rows() const { return rows_; }
  int sectors() const { return sectors_; }
  const Texture& outer() const { return outer_; }
  const Texture& inner() const { return inner_; }
  const Levels& levels() const { return levels_; }
  /// Renews the levels where rows have changed; true when they did.
  bool refresh(Texture& levels_texture);
  double max_radius() const;

 private:
  void fill(double outer, double inner);
  void means_of(int row, const float* outer, const float* inner);

  view::GridShape shape_;
  int rows_ = 0, sectors_ = 0, row_step_ = 1, sector_step_ = 1;
  Texture outer_, inner_;
  std::vector<float> mean_outer_, mean_inner_, scratch_;
  Levels levels_;
  bool changed_ = false, seen_ = false;
};

}  // namespace onggi::render
