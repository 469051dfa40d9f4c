#pragma once

// Correction to the force at the edges of a body's print. Elements come under a tool one after
// another. A sum over their middles is right only on average: without this correction the force
// would rise and fall as elements pass. The clay's motion does not use it. For *_lanes.cpp only.

#include "engine/clay/wall_side.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {

/// Eight elements as a body meets them, before any is pressed. `open`: the press. Negative: the
/// body ends that far short of the clay. 0: not met.
struct Edged {
  Float8 open, radius;
  unsigned touched;  ///< Bit k: lane k is pressed.
};

/// What a sum over elements lacks at the edge between a pressed element and its neighbour, where
/// the body ends `out` (< 0) short of the clay. `in` is the other neighbour's press. The press is
/// taken as a parabola through the three, up to its zero. The correction is the area beyond the
/// middle of the last element, less half that element, plus a twelfth of the slope there (the first
/// terms of Euler-Maclaurin; a straight line gives the same).
ONGGI_INLINE Float8 edge_of(Float8 press, Float8 out, Float8 in) {
  const Float8 zero = all(0.0f);
  const Float8 half = all(0.5f);
  const Float8 slope = half * (in - out);
  const Float8 bend = half * (in + out) - press;
  const Float8 root = sqrt(larger(slope * slope - all(4.0f) * bend * press, zero));
  const Float8 way = (press + press) / larger(slope + root, all(1e-12f));
  const Float8 edge = press * (way - half) + all(1.0f / 12.0f) * slope +
                      way * way * (all(1.0f / 3.0f) * bend * way - half * slope);
  // Leave the sum unchanged where no parabola fits: a print of one or two elements, and clay that
  // rests against the body, where the slope is not that of a press.
  const Float8 resolved = all(4.0f) - all(6.5f) * abs(bend) / larger(slope, all(1e-12f));
  return edge * smaller(larger(resolved, zero), all(1.0f));
}

/// Where a block of eight lies in the row. The row's last block ends in padding.
struct Seam {
  int padding;
  bool begins, ends;
};
struct Neighbours {
  Float8 left, right;
};
/// For each lane, the element before and the element after.
ONGGI_INLINE Neighbours neighbours(Float8 before, Float8 here, Float8 after, Seam seam) {
  if (seam.padding == 0 || !(seam.begins || seam.ends))
    return {one_back(before, here), one_on(here, after)};
  float line[3 * kLanes];
  store(before, line);
  store(here, line + kLanes);
  store(after, line + 2 * kLanes);
  if (seam.begins) line[kLanes - 1] = line[kLanes - 1 - seam.padding];
  if (seam.ends) line[2 * kLanes - seam.padding] = line[2 * kLanes];
  return {load(line + kLanes - 1), load(line + kLanes + 1)};
}

/// The force on the elements `here` in addition to their covered press, expressed as a press at the
/// start of the step. `before` and `after` are the blocks beside `here`. `mean`: the mean of a
/// fading press over the step, as a share. Gaps, where the body ends short of the clay, do not
/// fade.
template <WallSide side, class Met>
ONGGI_INLINE Float8 felt_beside(const Edged& before, const Edged& here, const Edged& after,
                                const Met& met, Seam seam, Float8 mean) {
  const Float8 zero = all(0.0f);
  const Neighbours open = neighbours(before.open, here.open, after.open, seam);
  const auto in_step = [&](Float8 press) { return select(press < zero, press, press * mean); };
  const Float8 left = in_step(open.left), press = in_step(here.open), right = in_step(open.right);
  // An element with edges on both sides is a print of one, which edge_of() leaves to the sum.
  const Mask8 ends_left = left < zero;
  const Float8 edges =
      only(ends_left | (right < zero),
           edge_of(press, select(ends_left, left, right), select(ends_left, right, left)));
  // The uncovered part stands as high as the neighbour on that side, because only the covered part
  // has yielded.
  const Neighbours face = neighbours(before.radius, here.radius, after.radius, seam);
  const auto given = [&](Float8 neighbour) {
    return larger(side == WallSide::outside ? neighbour - here.radius : here.radius - neighbour,
                  zero);
  };
  return (edges * met.covered - met.left * given(face.left) - met.right * given(face.right)) / mean;
}

}  // namespace onggi::ONGGI_LANES
