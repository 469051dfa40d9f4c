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

/// The clay's radii on the graphics side: two textures (outer, inner; rows x sectors), where each
/// height has its row in them, and the levels that the light needs. Radii are kept in steps of
/// 1/65535 of widest(), some two micrometres, and only where a row took such a step is it uploaded.
/// The textures have all the rows that the clay may come to have; the lowest are in use.
/// Grids beyond kMost in a direction are kept at every n-th row or sector: finer than any screen,
/// and the engine's grid stays whole.
class ClaySurface {
 public:
  static constexpr int kMost = 2048;
  static constexpr int kHeights = 1024;

  /// All of `clay`, whatever was shown before.
  void show(const ClayView& clay);
  /// What changed of the clay that was shown last; all of it where it has another grid.
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
  /// What a texel of 1 is, metres.
  float widest() const { return widest_; }
  /// Over kHeights even shares of the height, foot and rim included: the row there, as a share of
  /// the radius textures, and by how much that share grows with the share of the height.
  const Texture& row_at() const { return row_at_; }
  /// The lowest row that is no floor, as a share of the radius textures.
  float first_wall_row() const { return first_wall_row_; }
  /// Which rings are torn.
  const Tears& tears() const { return tears_; }
  /// Radius of the rim's edges, from its mean thickness, and that, m.
  float lip() const;
  double rim_wall() const;
  const Levels& levels() const { return levels_; }
  /// Renews the levels where rows have changed; true when they did.
  bool refresh(Texture& levels_texture);
  /// There are rows that no picture shows yet.
  bool changed() const { return changed_; }
  double max_radius() const;  ///< Metres, mean round the axis,
  double mouth() const;       ///< and of the inner wall at the rim.
  /// Share of the way round beyond which, to both sides of where `eye` (metres) is, the outer wall
  /// turns its back on it at every height. 1 where it does not.
  double facing(Vec3 eye) const;
  /// How deep `eye` sees through the mouth at the most, from the lip (0) to the floor (1).
  double seen_into(Vec3 eye) const;

 private:
  /// A texture, its texels as it is to have them, and the block of them that it lacks yet.
  struct Radii {
    Texture texture;
    std::vector<std::uint16_t> steps;
    int from = 0, to = 0;     // rows
    int left = 0, right = 0;  // sectors
  };
  void make_room(const ClayView& clay);
  /// A texel of 1 is to be as wide as the clay's widest, and a little more.
  void make_wide(const ClayView& clay);
  void take_row(int j, const ClayView& clay, int row);
  void take_radii(Radii& radii, int j, std::span<const float> of);
  void send(Radii& radii);
  void stack();

  void use_rows(int rows);

  int all_rows_ = 0, all_sectors_ = 0;  // of the view, at the most
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
  std::uint64_t seen_ = 0;  // ClayView::change() as last looked at
  bool changed_ = false, stacked_ = false;
};

}  // namespace onggi::render
