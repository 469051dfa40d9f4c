#pragma once

#include <vector>

#include "kiosk/collection/decoration/decoration.h"

namespace onggi::decoration {

/// Where the makers of a vessel began a band or a figure, and which way they went: a hint for who
/// decorates a pot like it. It is no line to trace.
struct Start {
  bool ring = false;    ///< Once round; else a figure that comes back.
  bool inside = false;  ///< On the inner wall.
  double at = 0.5;      ///< As Step::at: share of the side's outline.
  double reach = 0.01;  ///< Half the height of its zone, the same share.
  int repeats = 1;      ///< Round the pot,
  double turn = 0.0;    ///< the first at this share of a turn.
  /// Of a figure: its first place and a short way from there, up and to the right, in lengths of
  /// the side's outline from its middle.
  Vec2 from, to;
};

/// The starts of a decoration on a vessel whose outside is `outside` long, m, > 0. One for each
/// zone. Figures that stand alone, and nails' marks, are left out: the first are scenes.
std::vector<Start> starts_of(const Decoration& decoration, double outside);

}  // namespace onggi::decoration
