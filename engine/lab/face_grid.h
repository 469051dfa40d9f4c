#pragma once

#include <vector>

#include "engine/clay/clay.h"
#include "engine/lab/plain_wall.h"

namespace onggi::lab {

/// Level rows of one face of the clay as it is drawn: a surface through the middles of its
/// elements, straight between them.
struct FaceGrid {
  int rows = 0, sectors = 0;
  double bottom = 0.0;         ///< Height of the first row's middle, m.
  double thickness = 0.0;      ///< From one row to the next, m.
  double turned = 0.0;         ///< Angle of the first element less half a sector, rad.
  std::vector<double> radius;  ///< rows x sectors, m.
};

/// The rows of `clay` whose middle lies in low..high (m); all rows must still be level. Allocates.
FaceGrid face_of(const Clay& clay, WallSide side, double low, double high);
template <class Real>
FaceGrid face_of(const PlainWall<Real>& wall, WallSide side);

/// Radius at `height` (m, clamped to its rows) and `angle` (rad).
double radius_at(const FaceGrid& face, double height, double angle);

/// Distance of two surfaces, m.
struct FaceDifference {
  double rms = 0.0, most = 0.0;
};
/// `face` at the middles of `truth`'s elements, where it has rows on either side.
FaceDifference difference(const FaceGrid& face, const FaceGrid& truth);

/// Volume pressed away of a face that was `fresh` (m) from the axis, m^3, summed over elements.
double displaced(const FaceGrid& face, double fresh);

}  // namespace onggi::lab
