#pragma once

#include <span>

#include "engine/surface/surface.h"

namespace onggi::surface {

/// Something flat that lay on the wall when it was soft: the face of a paddle or an anvil, or a
/// hand that smoothed it.
struct Impression {
  enum Face { even, cord, grid, rings };

  int face = even;      ///< Of Face.
  bool hand = false;    ///< A field of the wall that is smoothed up to its ends; else a round face,
                        ///< which gives way round its edge.
  bool inside = false;  ///< On the wall's inside.
  double low = 0.0, high = 0.0;  ///< m: heights between which it lies,
  double from = -1.0, to = 1.0;  ///< and what of the face they are: -1 its lower end, 1 its upper.
  double angle = 0.0, half = 0.0;  ///< rad: its middle, and half its width, at most pi.
  double wide = 0.0, tall = 0.0;   ///< m: half the face round the pot and upwards, before the clay
                                   ///< under it stretched.
  double deep = 0.0;               ///< m: how far it went in where that is nearest to its middle.
  double tilt = 0.0;  ///< rad: by which the face was turned on the wall, from the sectors' way up.
};

/// Sizes of the faces' relief, m, all > 0.
struct ImprintDef {
  double pitch = 0.003;  ///< From cord to cord, or from bar to bar.
  double rings = 0.004;  ///< From ring to ring.
  double depth = 4e-4;   ///< Of a whole print. Never more than Surface::deepest().
};

/// Prints all of `left` on a bare `surface`, which then was born so: it is no step of the undo. The
/// last of `left` lies over the others: where it went in by `depth`, it wiped out what was there.
/// An impression with a number that is not finite or beyond 1000 is left out. True if it changed a
/// cell. The same bits on every machine. Allocates. O(cells + cells under each impression): 1.1 s
/// were measured for 2048 whole prints.
bool imprint(Surface& surface, std::span<const Impression> left, const ImprintDef& def);

}  // namespace onggi::surface
