#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/clay/clay_mesh.h"
#include "engine/profile/profile.h"
#include "kiosk/collection/decoration/coat_picture.h"
#include "kiosk/picture/view/image.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::exhibit {

/// A decorated pot's skin as one picture, read off with the shader that draws the pot: from the
/// left once round, from the top along the outline from the foot over the lip to the floor's end.
/// Both sides are powers of two, as some phones want a texture. It is filled some rows at a time.
class UnrolledPot {
 public:
  static constexpr int kWidth = 1024;
  static constexpr int kStrip = 32;  ///< Rows at a time: about as many places as a pot's mesh has.

  /// `made`: the clay that `coat` lies on.
  UnrolledPot(const Profile& made, const decoration::CoatPicture& coat);

  int height() const { return picture_.height; }
  bool whole() const { return row_ == picture_.height; }
  /// The places of the next rows on the clay, and their skin, once it is read.
  ClayMesh next_places() const;
  void take(const std::vector<view::SkinPoint>& skin);
  const view::Image& picture() const { return picture_; }
  /// How rough it is there, in grey, 0..255 for 0..1, half as wide and high: a coat has no finer
  /// detail. A whole picture only.
  view::Image roughness() const;

  /// Where the positions of the clay's mesh lie in it, 0..1 from the left and from the top. All
  /// that is under the foot lies at the top.
  std::vector<std::array<float, 2>> places_of(const ClayMesh& pot) const;
  /// The outline of the outside, from the foot to where the rounding of the lip begins. m; x:
  /// radius, y: height.
  std::vector<Vec2> outline() const;
  /// The outside as it is seen, up to the lip: true along the outline, and round the pot where it
  /// is widest. A whole picture only.
  view::Image rollout() const;

 private:
  struct Spot {
    double height = 0, radius = 0;
    ClayFace face = ClayFace::outer;
  };
  // `wall`: 0 outside, 1 inside.
  double row_on(std::size_t wall, double height) const;
  double height_on(std::size_t wall, double row) const;
  Spot spot_at(double row) const;
  /// Of a position `rho` from the axis.
  double row_of(double rho, double height, ClayFace face) const;
  double lip_edge() const;  // radius of its rounding, m

  Profile made_;
  std::vector<std::array<float, 2>> by_height_;
  double floor_from_ = 0;
  double rim_ = 0, shoulder_ = 0, out_ = 0, in_ = 0;  // of the lip, m
  double lip_from_ = 0, lip_to_ = 0;                  // where the shoulders lie
  double outline_ = 0;                                // of the outside, m
  view::Image picture_;
  std::vector<std::uint8_t> rough_;  ///< Of its pixels.
  int row_ = 0;                      // the next to be read
};

}  // namespace onggi::exhibit
