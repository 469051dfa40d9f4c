#include "kiosk/visit/decorating/beaten_wall.h"

#include <algorithm>
#include <vector>

#include "engine/math/portable.h"
#include "engine/surface/imprint.h"

namespace onggi::decorating {

namespace {

using surface::Impression;

// An arm and a paddle's handle at a third of their size; an estimate.
constexpr double kElbow = 0.08;  // m over the wheel
constexpr double kArm = 0.2;     // m from the elbow to the paddle

int face_of(const Print& print, const PrintsDef& faces) {
  if (print.kind == Print::anvil) return faces.rings > 0.0 ? Impression::rings : Impression::even;
  if (print.kind == Print::smoothed) return Impression::even;
  return faces.paddle == PrintsDef::cord   ? Impression::cord
         : faces.paddle == PrintsDef::grid ? Impression::grid
                                           : Impression::even;
}

}  // namespace

bool print(surface::Surface& surface, std::span<const Print> prints, const PrintsDef& faces) {
  std::vector<Impression> left;
  left.reserve(prints.size());
  for (const Print& each : prints) {
    Impression& on = left.emplace_back();
    on.face = face_of(each, faces);
    on.hand = each.kind == Print::smoothed;
    on.inside = each.side == WallSide::inside;
    on.low = each.low, on.high = each.high;
    on.from = each.from, on.to = each.to;
    on.angle = each.angle, on.half = each.half;
    on.wide = each.wide, on.tall = each.tall;
    on.deep = each.deep;
    // A cord lies across the handle, which goes down to the visitor from above the elbow: so it
    // goes up towards the visitor. On the right of the wheel that is the sectors' way round.
    const double lean = portable::atan2(0.5 * (each.low + each.high) - kElbow, kArm);
    on.tilt = each.left ? lean : -lean;
  }
  return surface::imprint(surface, left, {faces.pitch, faces.rings, faces.depth});
}

}  // namespace onggi::decorating
