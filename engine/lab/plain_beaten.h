#pragma once

#include <span>
#include <vector>

#include "engine/clay/clay_def.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/beating.h"
#include "engine/lab/face_grid.h"

namespace onggi::lab {

/// A blow from outside.
struct PlainBlow {
  double height = 0.0, angle = 0.0;  ///< Its middle, m; in the clay, rad.
  double swing = 1.0, anvil = 0.0;   ///< Shares of the energy.
};

/// A wall that is beaten, written a second time from the part on beating of engine/docs/effects.md,
/// in doubles: all elements under the face, the depth by halving, and the plane by all its sums at
/// once. Dry clay, no torn rows; blows keep off floor and rim, and leave more than wall_min and
/// three quarters of the wall.
class PlainBeaten {
 public:
  /// `clay`: its wall and its grid. Allocates.
  PlainBeaten(const ClayDef& clay, const BeatingDef& law);

  void strike(const PlainBlow& blow);
  double volume() const;  ///< m^3
  double height() const;  ///< Of the rim, m.
  /// `heights` even heights of a face from `low` to `high`, m. Allocates.
  FaceGrid face(WallSide side, double low, double high, int heights) const;

 private:
  struct Under {  // an element under the face
    std::size_t at;
    int row;
    double weight, round, up, area;
  };
  double radius_at(const PlainBlow& blow) const;  // outer, in its middle
  std::vector<Under> under(const PlainBlow& blow) const;
  double depth(std::span<const Under> all, double work, std::span<const double> proud) const;
  void stack();

  BeatingDef law_;
  int rows_, sectors_;
  std::vector<double> outer_, inner_;            // rows x sectors, m
  std::vector<double> volume_, thick_, height_;  // by row: m^3 per radian of a sector, m, m
};

/// How far each of `all` stands out of the plane that lies best under it, least squares by weight:
/// places (round, up) and values, m. Allocates.
struct PlainPlace {
  double weight, round, up, value;
};
std::vector<double> out_of_plane(std::span<const PlainPlace> all);

}  // namespace onggi::lab
