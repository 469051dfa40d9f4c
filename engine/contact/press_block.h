// How a tool presses eight elements of a row (press_rows.h), and what the sums of it are. Compiled
// once for each kind of vector: include it only from files that hwy/foreach_target.h compiles
// again.
#if defined(ONGGI_CONTACT_PRESS_BLOCK_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_CONTACT_PRESS_BLOCK_H
#undef ONGGI_CONTACT_PRESS_BLOCK_H
#else
#define ONGGI_CONTACT_PRESS_BLOCK_H
#endif

#include <type_traits>

#include "engine/clay/wall_side.h"
#include "engine/contact/window.h"
#include "engine/math/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {

// A press below 80 nm is none: a float's step at 12 cm is 7 nm, a tenth of it is what 1 ms of the
// stiffest clay takes away, and rest must be rest.
inline constexpr float kSnap = 8e-8f;

/// How eight rays meet a tool's section: where the tool's near end (pressing from outside) or far
/// end (from inside) lies along each, in metres from the axis, negative beyond it. `covered`, 0..1,
/// is how much of each element the section covers; it counts only where the meeting is `careful`.
struct Meeting {
  Float8 end;
  Float8 covered;
  Mask8 hit;
};

/// Sums over rows of one thickness, of weight = press times radius. What x, y and z are is the
/// tool's to say.
struct RowSum {
  Float8 weight, x, y, z;
};

/// Sums over all rows: force on the tool and its normal part, N.
struct Reaction {
  Float8 normal, x, y, z;
};

// Positive is a press: S - E1 from outside, E2 - S from inside.
template <WallSide side>
HWY_INLINE Float8 press_of(Float8 face, Float8 target) {
  return side == WallSide::outside ? face - target : target - face;
}

/// What holds for all elements of a step.
struct StepFigures {
  float limit;  // how far the face may be pressed: the clay keeps radius_min, wall_min, radius_max
  float wall_min;
  float gone;             // 1 - e^(-dt/tau): how much of a press the clay gives way by in the step
  float along = 0.0f;     // Yielding::along
  float farthest = 0.0f;  // that the other face may go: radius_min outside, radius_max inside
};

// Most rows are plain. Some need care: near the axis, and near the clay's limits, a tool may ask
// for more than the clay allows; a tool outside works the half of the clay that it stands over, not
// what lies beyond the axis; and where the press is deep at the section's very edges, an element
// counts for the share that is covered, or the force would step as elements come and go.
template <WallSide side, bool careful>
HWY_INLINE Float8 target_of(Float8 end, const StepFigures& figures) {
  if constexpr (!careful) return end;
  return side == WallSide::outside ? larger(end, all(figures.limit))
                                   : smaller(end, all(figures.limit));
}

struct Pressed {
  RowSum sum;
  Float8 depth;   // deepest of each lane
  Float8 behind;  // the farthest that the other face was carried
  int touched;
};

/// Where a clay keeps its rows' areas (Clay::areas()), beside it what the row lost, as a sum of
/// squares of radii. Only then is it computed at all, and only then may the other face go along.
struct PressedAndKept : Pressed {
  Float8 lost;
  float* shift;  // of the row: grows by what each element was moved
};

// The other face as it goes along: with the share `along` of the area that the pressed face lost.
template <WallSide side>
HWY_INLINE Float8 gone_along(const StepFigures& figures, Float8 back, Float8 lost) {
  const Float8 share = lost * all(figures.along);
  const Float8 most = all(figures.farthest * figures.farthest);
  return side == WallSide::outside ? sqrt(larger(back * back - share, most))
                                   : sqrt(smaller(back * back + share, most));
}

// One block of eight elements, with the target held where it is in the middle of the step: exact
// exponential relaxation, second order in the step for a target that moves.
template <WallSide side, bool careful, bool hollow, class Row, class Sum>
HWY_INLINE void press_block(const Row& row, const StepFigures& figures, const float* ray_cos,
                            const float* ray_sin, float* face, float* behind, Sum& pressed,
                            [[maybe_unused]] int at) {
  constexpr bool kept = std::is_same_v<Sum, PressedAndKept>;
  const Float8 c = load(ray_cos);
  const Float8 s = load(ray_sin);
  const Float8 radius = load(face);
  const auto m = row.template meet<side, careful>(c, s, radius);
  const Float8 press = press_of<side>(radius, target_of<side, careful>(m.end, figures));
  const Mask8 touch = m.hit & (press > all(kSnap));
  if (none(touch)) return;

  const Float8 felt = only(touch, careful ? press * m.covered : press);
  const Float8 given = felt * all(figures.gone);
  const Float8 now = side == WallSide::outside ? radius - given : radius + given;
  store(now, face);
  [[maybe_unused]] Float8 lost = all(0.0f);
  if constexpr (kept)
    lost = side == WallSide::outside ? (radius - now) * (radius + now)
                                     : (now - radius) * (now + radius);
  if constexpr (hollow) {
    // The other face is carried along where the wall would be too thin.
    const Float8 back = load(behind);
    const Float8 thin = all(figures.wall_min);
    Float8 least = side == WallSide::outside ? now - thin : now + thin;
    if constexpr (kept) {
      const Float8 along = gone_along<side>(figures, back, lost);
      least = side == WallSide::outside ? smaller(along, least) : larger(along, least);
    }
    const Mask8 pushed = touch & (side == WallSide::outside ? least < back : least > back);
    if (!none(pushed)) {
      const Float8 carried = select(pushed, least, back);
      store(carried, behind);
      pressed.behind = side == WallSide::outside ? smaller(pressed.behind, carried)
                                                 : larger(pressed.behind, carried);
      if constexpr (kept)
        lost = lost - (side == WallSide::outside ? (back - carried) * (back + carried)
                                                 : (carried - back) * (carried + back));
    }
  }
  if constexpr (kept) {
    pressed.lost = pressed.lost + lost;
    store(load(pressed.shift + at) + given, pressed.shift + at);
  }
  row.react(pressed.sum, felt * radius, m, c, s);
  pressed.depth = larger(pressed.depth, felt);
  pressed.touched += count(touch);
}

template <WallSide side, bool careful, bool hollow, class Row, class Sum>
HWY_INLINE void press_ranges(const Row& row, const StepFigures& figures, const float* ray_cos,
                             const float* ray_sin, float* face, float* behind,
                             const RowReach& reach, Sum& pressed) {
  for (int n = 0; n < reach.used; ++n)
    for (int i = reach.ranges[n].begin * kLanes; i < reach.ranges[n].end * kLanes; i += kLanes)
      press_block<side, careful, hollow>(row, figures, ray_cos + i, ray_sin + i, face + i,
                                         behind + i, pressed, i);
}

}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
