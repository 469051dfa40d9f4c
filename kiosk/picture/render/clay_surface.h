#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/clay/lip.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/levels.h"
#include "kiosk/picture/render/tears.h"

namespace onggi::render {

/// The clay's radii on the graphics side: two textures (outer, inner; rows x sectors), a table from
/// heights to rows, and the levels that the light needs. Radii are kept in steps of 1/65535 of
/// widest(), about two micrometres, and a row is uploaded only if it changed by such a step. The
/// textures have space for all rows that the clay may ever have; the lowest are in use. Grids
/// beyond kMost in a direction are sampled at every n-th row or sector: still finer than any
/// screen. The engine's grid is unaffected.
class ClaySurface {
 public:
  static constexpr int kMost = 2048;
  static constexpr int kHeights = 1024;

  /// Uploads all of `clay`, whatever was shown before.
  void show(const ClayView& clay);
  /// Uploads the changes of the shown clay, or all of it if its grid has changed.
  void update(const ClayView& clay);

  bool empty() const { return rows_ < 1 || sectors_ < 1; }
  int rows() const { return rows_; }               ///< In use,
  int texture_rows() const { return all_drawn_; }  ///< and in the textures.
  /// The middle of the highest row in use, as a share of the radius textures.
  float top_row() const;
  int sectors() const { return sectors_; }
  double height() const { return height_; }        ///< Metres.
  double floor_top() const { return floor_top_; }  ///< Metres.
  const Texture& outer() const { return outer_.texture; }
  const Texture& inner() const { return inner_.texture; }
  /// Radius of a texel of 1, metres.
  float widest() const { return widest_; }
  /// A table over kHeights equal steps of the height, foot and rim included. Entries: the row
  /// there, as a share of the radius textures, and the derivative of that share with respect to the
  /// share of the height.
  const Texture& row_at() const { return row_at_; }
  /// Radii as the shader reads them, metres: `round` is the share of a turn, `up` of the height.
  float outer_at(float round, float up) const { return radius_at(outer_, round, up, 0.0f); }
  float inner_at(float round, float up) const {
    return radius_at(inner_, round, up, first_wall_row_);
  }
  /// The lowest row above the floor, as a share of the radius textures; the topmost if all is
  /// floor.
  float first_wall_row() const { return first_wall_row_; }
  const Tears& tears() const { return tears_; }
  /// Radius of the rim's edges, from its mean thickness, and the thickness, m.
  float lip() const;
  double rim_wall() const;
  const Levels& levels() const { return levels_; }
  /// Renews the levels if rows have changed; returns true if so.
  bool refresh(Texture& levels_texture);
  /// True if no picture shows some of the rows yet.
  bool changed() const { return changed_; }
  double max_radius() const;  ///< Metres, mean around the axis,
  double mouth() const;       ///< and of the inner wall at the rim.
  /// Share of the circle that can be visible, centred on `eye` (metres): beyond it the outer wall
  /// is hidden at every height. 1 if nothing is hidden.
  double facing(Vec3 eye) const;
  /// The greatest depth that `eye` sees through the mouth, from the lip (0) to the floor (1).
  double seen_into(Vec3 eye) const;

 private:
  /// A texture, its texels on the CPU, and the block still to be uploaded.
  struct Radii {
    Texture texture;
    std::vector<std::uint16_t> steps;
    int from = 0, to = 0;     // rows
    int left = 0, right = 0;  // sectors
  };
  float radius_at(const Radii& radii, float round, float up, float lowest) const;
  void make_room(const ClayView& clay);
  /// A texel of 1 covers the clay's widest radius with a margin.
  void make_wide(const ClayView& clay);
  void take_row(int j, const ClayView& clay, int row);
  void take_radii(Radii& radii, int j, std::span<const float> of);
  void send(Radii& radii);
  void stack();

  void use_rows(int rows);

  int all_rows_ = 0, all_sectors_ = 0;  // of the view: the most
  int all_drawn_ = 0;
  int rows_ = 0, sectors_ = 0, row_step_ = 1, sector_step_ = 1;
  double height_ = 0, floor_top_ = 0;
  Radii outer_, inner_;
  Texture row_at_;
  float widest_ = 0;
  std::vector<std::uint16_t> row_;
  std::vector<float> mean_outer_, mean_inner_, middle_, heights_;
  float first_wall_row_ = 0;
  Levels levels_;
  Tears tears_;
  std::uint64_t seen_ = 0;  // ClayView::change() at the last look
  bool changed_ = false, stacked_ = false;
};

}  // namespace onggi::render
