#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/surface/melt.h"
#include "engine/surface/surface.h"

namespace onggi::decoration {

/// How slips and glaze look, before and after the fire. Linear colours.
struct Palette {
  struct Coat {
    std::array<float, 3> raw{}, fired{};
    double hides = 5e-5;  ///< The coat that hides 63 % of what lies below, m.
    friend bool operator==(const Coat&, const Coat&) = default;
  };
  std::vector<Coat> pigments;                           ///< By the surface's numbers, at most 16.
  std::array<float, 3> raw_glaze{0.36f, 0.29f, 0.22f};  ///< Glaze is opaque until it melts.
};

/// A decorated surface as two pictures that the graphics side reads. A column is a sector, from the
/// pot's own angle 0 on, and a row is a row of the surface, the foot's first. Renewed by tiles:
/// each tile has the number of the change that it was last drawn in. Main thread. Allocates at its
/// birth; 25 MB for a tall pot.
class CoatPicture {
 public:
  static constexpr int kTileRows = 64, kTileColumns = 60;  ///< As the surface's own.
  static constexpr int kHeights = 512;
  static constexpr int kPolish = 85;
  using Texel = std::array<std::uint8_t, 4>;

  /// Of a bare `surface`, before the fire. For another one touch_all() and draw() follow.
  CoatPicture(const surface::Surface& surface, const Palette& palette);

  /// The rows [from, to) and sectors [first, last), which may go round, have changed.
  void touch(int from, int to, int first, int last);
  /// Everything has changed.
  void touch_all();
  /// From now on after (or again before) the fire, in which the glaze has become `melt`; null: it
  /// lies as it was laid. `melt` is done(), and lives until the next call. Everything changes.
  void fire(bool fired, const surface::Melt* melt = nullptr);
  bool fired() const { return fired_; }
  /// Draws what was touched, `most` tiles at a time; true if some are left.
  bool draw(const surface::Surface& surface, int most);

  int width() const { return surface::kSectors; }
  int height() const { return rows_; }
  /// The square root of the colour's linear light, times 255, and how much of the clay it hides.
  const std::vector<Texel>& paint() const { return paint_; }
  /// Slope of the surface along the outline and round the pot, rising with row and sector:
  /// 128 + 64 * slope. Then how deep it lies under the pot's own clay, 4 um a unit. Then, once
  /// glazed(), the glaze laid on it, surface::kGlazeUnit a unit; else the polish, kPolish for each
  /// pass of the stone. What has melted() is its own top: no depth lies under it.
  const std::vector<Texel>& form() const { return form_; }
  /// True once glaze was laid on the surface: the fourth value of form() is then the coat to
  /// melt. Else the kiln's glaze covers the pot evenly.
  bool glazed() const { return glazed_; }
  /// True once all of the picture shows molten glaze.
  bool melted() const { return melted_; }

  /// How far clay stands out of the outside, a coil above all, so that the outline moves with it:
  /// kBeadUnit a unit, the mean of kBeadRows x kBeadColumns cells; 0 where it is under kLeastBead,
  /// and at the lip. kSectors / kBeadColumns across, kTileRows / kBeadRows to a tile down.
  const std::vector<std::uint8_t>& beads() const { return beads_; }
  static constexpr int kBeadRows = 4, kBeadColumns = 6;
  static constexpr int kBeadUnit = 12, kLeastBead = 150;  ///< um. A coil is 3 mm at most.

  int tiles_down() const { return (rows_ + kTileRows - 1) / kTileRows; }
  int tiles_across() const { return surface::kSectors / kTileColumns; }
  /// Of the tile: the change that drew it last. A number is given once in the program's life, so a
  /// reader that knows the number has the tile.
  std::uint64_t change(int down, int across) const {
    return changes_[static_cast<std::size_t>(down * tiles_across() + across)];
  }
  /// The last change of any tile.
  std::uint64_t change() const { return change_; }

  /// Row of the picture, as a share of its height, for outer and inner wall at kHeights even
  /// heights from the foot (0) to the rim.
  const std::vector<std::array<float, 2>>& rows_by_height() const { return by_height_; }
  /// The lip lies between these shares, the floor from this one to 1.
  float lip_from() const { return lip_from_; }
  float lip_to() const { return lip_to_; }
  float floor_from() const { return floor_from_; }

 private:
  /// The colour that covers the clay, and its share.
  struct Cover {
    std::array<float, 3> light{};
    float share = 0;
  };
  void tell_rows(const surface::Surface& surface);
  void know_shares(const Palette& palette);
  Cover cover(const surface::Surface& surface, int j, int i) const;
  /// Tops of the tile and of the cells round it, nm, into tops_.
  void find_tops(const surface::Surface& surface, int down, int across);
  Texel form_at(const surface::Surface& surface, int j, int i, int row, int column) const;
  void draw_tile(const surface::Surface& surface, int down, int across);
  void even_middle();
  void draw_beads(const surface::Surface& surface, int down, int across);

  Palette palette_;
  /// Of what lies below, the share that a coat hides: by pigment and code of its thickness.
  std::array<std::array<float, surface::kCodes>, surface::kPigments> hides_{};
  std::array<float, surface::kMostGlaze + 1> glaze_hides_{};
  int rows_ = 0;
  bool fired_ = false, glazed_ = false, melted_ = false;
  const surface::Melt* melt_ = nullptr;
  std::vector<Texel> paint_, form_;
  std::vector<std::uint8_t> beads_;
  int outside_ = 0;  // rows of the outside
  std::vector<int> tops_;
  /// The floor's middle has no cells. The last row is drawn all over it, so it is even.
  bool has_middle_ = false, middle_stale_ = false;
  Texel middle_paint_{}, middle_form_{};
  std::vector<std::uint64_t> changes_;
  std::vector<bool> stale_, has_glaze_;
  std::uint64_t change_ = 0;
  std::vector<std::array<float, 2>> by_height_;
  float lip_from_ = 0, lip_to_ = 0, floor_from_ = 0;
};

}  // namespace onggi::decoration
