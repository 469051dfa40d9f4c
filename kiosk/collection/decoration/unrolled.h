#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/profile/mesh.h"
#include "engine/surface/surface.h"
#include "kiosk/collection/decoration/decoration.h"

namespace onggi::decoration {

/// A pot's colours, unrolled. From the left once round the pot, from the top the outline from the
/// foot over the lip to the middle of the floor, a row and a sector of the surface a pixel.
struct Unrolled {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< sRGB, opaque, rows from the top.
};

/// The colours of a decorated surface after the fire. Each stratum hides what is below by
/// 1 - exp(-t / hides); carbon lies over that, glaze over all, thicker where clay was cut away,
/// because it melts level. Stand-ins: the melt is no flow, and no fire is computed. Allocates.
Unrolled unrolled(const surface::Surface& surface, const Decoration& decoration);

/// A mesh and where each of its positions lies in a picture, 0..1 from the left and from the top.
struct Skin {
  TriangleMesh mesh;
  std::vector<std::array<float, 2>> places;
};

/// Doubles the positions where `skin` closes round the pot, so that no triangle goes back over the
/// whole picture. Of each new position: the one that it doubles. Allocates.
std::vector<std::uint32_t> close_round(Skin& skin);

/// Places for `mesh`, which is `section` turned about its axis, in the picture of `surface`, which
/// was decorated for it at any scale. Positions where it closes round the pot are doubled, so that
/// no triangle goes back over the whole picture. What lies under the foot has the foot's place.
/// Allocates.
Skin placed(const TriangleMesh& mesh, const Section& section, const surface::Surface& surface);

}  // namespace onggi::decoration
