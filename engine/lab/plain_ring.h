#pragma once

#include <functional>
#include <vector>

#include "engine/clay/wall_side.h"
#include "engine/lab/face_grid.h"
#include "engine/scene/hands.h"

namespace onggi::lab {

/// A ring of coil in closed form, from the part on building of engine/docs/effects.md: no rows, no
/// ticks. A hand goes once round on a standing wheel, from angle 0 towards z; its coil lies where
/// the hand went. The last gap closes evenly.
class PlainRing {
 public:
  /// `coil`: its diameter, m. `hands`: what the first hand does at a time, s, until `seconds`;
  /// it gets round by then. Allocates.
  PlainRing(double coil, const std::function<Hands(double)>& hands, double seconds);

  /// Distance of the coil's middle from the axis at `angle` (0..2 pi), m.
  double centre(double angle) const;
  /// Height of the closed ring, m: its section by the mean width of what is left of it.
  double height() const;
  /// Width of the ring `up` above the rim it lies on (0..height()), m.
  double width(double up) const;
  /// Its clay, m^3 (Pappus).
  double volume() const;
  /// `heights` even rows of one of its faces, from `low` to `high` above the rim on which it lies,
  /// which is `rim` high, m. Allocates.
  FaceGrid face(WallSide side, double rim, double low, double high, int heights, int sectors) const;

 private:
  double on_path(double angle) const;

  double coil_;
  double gap_ = 0.0;  // angle at which the gap was narrow enough
  std::vector<double> angles_, centres_;
};

}  // namespace onggi::lab
