#pragma once

// How any body presses the rows it reaches, eight elements at a time. A body's file in bodies/
// gives a Law, which defines how the body meets one row:
//
//   struct Law {
//     using Body = ...;                          // what press.cpp plans: rows are BodyRow<Body>
//     static constexpr bool kPlain = ...;        // it has rows that need no care
//     static constexpr bool kEdges = ...;        // the force at its edges is computed
//     struct Row {
//       Row(const BodyFigures<Body>&, const BodyRow<Body>&);
//       template <WallSide side, bool careful> Meeting meet(Float8 cos, Float8 sin, Float8 face)
//       const; void react(RowSum&, Float8 weight, Float8 press, const Meeting&, Float8 cos, Float8
//       sin) const;
//     };
//     static void collect(const BodyFigures<Body>&, const RowSum&, float area, Reaction&);
//   };
//
// A row may define its own Meeting with more members, for its react(). With kEdges it also has
// `left` and `right`: the uncovered shares of an element. For *_lanes.cpp only.

#include "engine/clay/wall_side.h"
#include "engine/contact/edge_lanes.h"
#include "engine/contact/kernels.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {

using contact::BodyFigures;
using contact::BodyRow;
using contact::PressSums;
using contact::PressTotal;
using contact::RowPlaces;
using contact::RowsPressed;
using contact::RowTask;
using contact::StepFigures;

// A press below 80 nm counts as none, so that resting clay rests. A float's step at 12 cm is 7 nm,
// which is a tenth of what 1 ms of the stiffest clay takes away.
inline constexpr float kSnap = 8e-8f;

/// How eight rays meet a body's section. `end`: the body's near end (pressing from outside) or far
/// end (from inside) along each ray, metres from the axis, negative beyond it. `covered`, 0..1: the
/// share of each element that the section covers; used only if the meeting is `careful`.
struct Meeting {
  Float8 end;
  Float8 covered;
  Mask8 hit;
};

/// Sums over rows of one thickness, with weight = press times radius. The body defines x, y and z.
struct RowSum {
  Float8 weight, x, y, z;
};

/// Sums over all rows: force on the tool and its normal part, N.
struct Reaction {
  Float8 normal, x, y, z;
};

// Positive means pressed: S - E1 from outside, E2 - S from inside.
template <WallSide side>
ONGGI_INLINE Float8 press_of(Float8 face, Float8 target) {
  return side == WallSide::outside ? face - target : target - face;
}

// Most rows are plain. Three cases need care. Near the axis and near the clay's limits, a body may
// ask for more than the clay allows. A body outside works only the half of the clay on its own side
// of the axis. Where the press is deep at the section's edges, an element counts by its covered
// share, or the force would step as elements come and go.
template <WallSide side, bool careful>
ONGGI_INLINE Float8 target_of(Float8 end, const StepFigures& step) {
  if constexpr (!careful) return end;
  return side == WallSide::outside ? larger(end, all(step.limit)) : smaller(end, all(step.limit));
}

struct Pressed {
  RowSum sum;
  Float8 depth;         // deepest in each lane
  Float8 behind;        // farthest that the other face was moved
  Float8 lost;          // lost by the row, as a sum of squares of radii; only if areas are kept
  float* displacement;  // of the row: adds each element's displacement; only if areas are kept
  int touched;
};

// The other face after it follows: it moves by the share `along` of the area that the pressed face
// lost.
template <WallSide side>
ONGGI_INLINE Float8 gone_along(const StepFigures& step, Float8 back, Float8 lost) {
  const Float8 share = lost * all(step.along);
  const Float8 most = all(step.farthest * step.farthest);
  return side == WallSide::outside ? sqrt(larger(back * back - share, most))
                                   : sqrt(smaller(back * back + share, most));
}

// Presses one block of eight elements, some of which are touched. The target is held at its place
// in the middle of the step: exact exponential relaxation, second order in the step for a moving
// target. The force that edges add, `beside`, does not move the clay.
template <WallSide side, bool careful, bool hollow, bool keeps, bool edges, class Row, class Met>
ONGGI_INLINE void press_met(const Row& row, const StepFigures& step, float* face, float* behind,
                            int i, Float8 radius, const Met& m, Float8 press, Mask8 touch,
                            Float8 beside, Pressed& pressed) {
  const Float8 felt = only(touch, careful ? press * m.covered : press);
  const Float8 given = felt * all(step.gone);
  const Float8 now = side == WallSide::outside ? radius - given : radius + given;
  store(now, face + i);
  [[maybe_unused]] Float8 lost = all(0.0f);
  if constexpr (keeps)
    lost = side == WallSide::outside ? (radius - now) * (radius + now)
                                     : (now - radius) * (now + radius);
  if constexpr (hollow) {
    // Move the other face along where the wall would become too thin.
    const Float8 back = load(behind + i);
    const Float8 thin = all(step.wall_min);
    Float8 least = side == WallSide::outside ? now - thin : now + thin;
    if constexpr (keeps) {
      const Float8 along = gone_along<side>(step, back, lost);
      least = side == WallSide::outside ? smaller(along, least) : larger(along, least);
    }
    const Mask8 pushed = touch & (side == WallSide::outside ? least < back : least > back);
    if (!none(pushed)) {
      const Float8 carried = select(pushed, least, back);
      store(carried, behind + i);
      pressed.behind = side == WallSide::outside ? smaller(pressed.behind, carried)
                                                 : larger(pressed.behind, carried);
      if constexpr (keeps)
        lost = lost - (side == WallSide::outside ? (back - carried) * (back + carried)
                                                 : (carried - back) * (carried + back));
    }
  }
  if constexpr (keeps) {
    pressed.lost = pressed.lost + lost;
    store(load(pressed.displacement + i) + given, pressed.displacement + i);
  }
  // As a press fades, the face moves by as much. So the mean of press times radius over the step is
  // the press's mean times the mean of the first and last radius.
  const Float8 whole = edges ? only(touch, larger(felt + beside, all(0.0f))) : felt;
  row.react(pressed.sum, whole * (all(0.5f) * (radius + now)), press, m, load(step.ray_cos + i),
            load(step.ray_sin + i));
  pressed.depth = larger(pressed.depth, felt);
  pressed.touched += count(touch);
}

template <WallSide side, bool careful, bool hollow, bool keeps, class Row>
ONGGI_INLINE void press_block(const Row& row, const StepFigures& step, float* face, float* behind,
                              int i, Pressed& pressed) {
  const Float8 radius = load(face + i);
  typename Row::Met m;
  row.template meet<side, careful>(load(step.ray_cos + i), load(step.ray_sin + i), radius, m);
  const Float8 press = press_of<side>(radius, target_of<side, careful>(m.end, step));
  const Mask8 touch = m.hit & (press > all(kSnap));
  if (none(touch)) return;
  press_met<side, careful, hollow, keeps, false>(row, step, face, behind, i, radius, m, press,
                                                 touch, press, pressed);
}

template <WallSide side, bool careful, bool hollow, bool keeps, class Row>
ONGGI_INLINE void press_row(const Row& row, const StepFigures& step, const RowTask& task,
                            float* face, float* behind, Pressed& pressed) {
  const int used = task.used;
  for (int n = 0; n < used; ++n) {
    const int end = task.ranges[n].end * kLanes;
    for (int i = task.ranges[n].begin * kLanes; i < end; i += kLanes)
      press_block<side, careful, hollow, keeps>(row, step, face, behind, i, pressed);
  }
}

// The same with edges: presses a block once both its neighbours have been met. The second range
// begins where the first ends, at the first ray. Outside the ranges nothing is met.
template <WallSide side, bool hollow, bool keeps, class Row>
ONGGI_INLINE void press_edged_row(const Row& row, const StepFigures& step, const RowTask& task,
                                  int stride, int sectors, float* face, float* behind,
                                  Pressed& pressed) {
  if (task.used == 0) return;
  int blocks = task.ranges[0].end - task.ranges[0].begin;
  if (task.used > 1) blocks += task.ranges[1].end - task.ranges[1].begin;
  const bool circle = blocks * kLanes == stride;

  struct Block {
    typename Row::Met met;
    Edged edged;
  };
  Block three[3];  // reused in turn: copying them would cost more than the rest
  Block *before = three, *here = three + 1, *after = three + 2;
  Edged first{};
  int at = 0, next = (task.ranges[0].begin > 0 ? task.ranges[0].begin * kLanes : stride) - kLanes;
  for (int n = -1; n <= blocks; ++n) {
    const Float8 radius = load(face + next);
    if (n < blocks && (n >= 0 || circle)) {
      row.template meet<side, true>(load(step.ray_cos + next), load(step.ray_sin + next), radius,
                                    after->met);
      const Float8 press = press_of<side>(radius, target_of<side, true>(after->met.end, step));
      const Mask8 hit = after->met.hit;
      after->edged = {only(hit, press), radius, bits(hit & (press > all(kSnap)))};
      if (n == 0) first = after->edged;
    } else {
      after->edged = circle ? first : Edged{all(0.0f), radius, 0};
    }
    if (n > 0 && here->edged.touched != 0) {
      const bool amid = here->edged.touched == 0xff && (before->edged.touched & 0x80) != 0 &&
                        (after->edged.touched & 1) != 0;
      Float8 beside = all(0.0f);
      if (!amid)
        beside = felt_beside<side>(before->edged, here->edged, after->edged, here->met,
                                   {stride - sectors, at == 0, next == 0}, all(step.mean));
      press_met<side, true, hollow, keeps, true>(row, step, face, behind, at, here->edged.radius,
                                                 here->met, here->edged.open,
                                                 here->edged.open > all(kSnap), beside, pressed);
    }
    Block* const free = before;
    before = here;
    here = after;
    after = free;
    at = next;
    next = next + kLanes < stride ? next + kLanes : 0;
  }
}

template <class Law>
struct Kernel {
  using Body = typename Law::Body;
  using Row = typename Law::Row;

  // Force per weight (press times radius).
  ONGGI_INLINE static float area_of(const RowPlaces& places, double thickness) {
    return static_cast<float>(places.weight * thickness);
  }

  // Copy first what every block reads. Compilers assume that storing a vector may change anything,
  // and would read referenced values again after each store.
  template <WallSide side, bool keeps>
  static RowsPressed press_rows(const StepFigures& given, const BodyFigures<Body>& body,
                                const RowPlaces& places, BodyRow<Body>* rows, int count,
                                PressSums& sums, PressTotal* total) {
    const StepFigures step = given;
    const Float8 zero = all(0.0f);
    Reaction reaction{zero, zero, zero, zero};
    Pressed pressed;
    pressed.sum = {zero, zero, zero, zero};
    pressed.depth = zero;
    double thickness = 0.0;
    if (sums.begun) {
      reaction = {load(sums.normal), load(sums.force_x), load(sums.force_y), load(sums.force_z)};
      pressed.sum = {load(sums.weight), load(sums.x), load(sums.y), load(sums.z)};
      pressed.depth = load(sums.depth);
      thickness = sums.thickness;
    }
    RowsPressed out;
    for (BodyRow<Body>* task = rows; task != rows + count; ++task) {
      const int k = task->k;
      if (places.thickness[k] != thickness) {
        Law::collect(body, pressed.sum, area_of(places, thickness), reaction);
        pressed.sum = {zero, zero, zero, zero};
        thickness = places.thickness[k];
      }
      out.blocks += task->ranges[0].end - task->ranges[0].begin;
      if (task->used > 1) out.blocks += task->ranges[1].end - task->ranges[1].begin;
      const Row row(body, *task);
      const float start = places.behind_start[k];
      pressed.behind = all(start);
      pressed.touched = 0;
      if constexpr (keeps) {
        pressed.displacement = task->displacement;
        pressed.lost = zero;
      }
      const long from = static_cast<long>(places.stride) * places.stored[k];
      float* const face = places.face + from;
      float* const behind = places.behind + from;
      const std::uint32_t bit = std::uint32_t{1} << k;
      const bool solid = k < places.hollow_from;
      if constexpr (Law::kEdges) {
        if (solid)
          press_edged_row<side, false, keeps>(row, step, *task, places.stride, places.sectors, face,
                                              behind, pressed);
        else
          press_edged_row<side, true, keeps>(row, step, *task, places.stride, places.sectors, face,
                                             behind, pressed);
      } else if (solid) {
        press_row<side, true, false, keeps>(row, step, *task, face, behind, pressed);
      } else if (!Law::kPlain || (places.careful & bit) != 0) {
        press_row<side, true, true, keeps>(row, step, *task, face, behind, pressed);
      } else if constexpr (Law::kPlain) {
        press_row<side, false, true, keeps>(row, step, *task, face, behind, pressed);
      }
      if (pressed.touched == 0) continue;
      out.touched += pressed.touched;
      out.changed |= bit;
      if (!none(side == WallSide::outside ? pressed.behind < all(start)
                                          : pressed.behind > all(start))) {
        out.carried |= bit;
        task->behind_most =
            side == WallSide::outside ? smallest(pressed.behind) : largest(pressed.behind);
      }
      if constexpr (keeps) task->lost = sum(pressed.lost);
    }
    if (total != nullptr) {
      Law::collect(body, pressed.sum, area_of(places, thickness), reaction);
      *total = {sum(reaction.x), sum(reaction.y), sum(reaction.z), sum(reaction.normal),
                largest(pressed.depth)};
      return out;
    }
    sums.begun = true;
    store(reaction.normal, sums.normal);
    store(reaction.x, sums.force_x);
    store(reaction.y, sums.force_y);
    store(reaction.z, sums.force_z);
    store(pressed.sum.weight, sums.weight);
    store(pressed.sum.x, sums.x);
    store(pressed.sum.y, sums.y);
    store(pressed.sum.z, sums.z);
    store(pressed.depth, sums.depth);
    sums.thickness = thickness;
    return out;
  }

  static RowsPressed press(WallSide side, const StepFigures& step, const BodyFigures<Body>& body,
                           const RowPlaces& at, BodyRow<Body>* rows, int count, PressSums& sums,
                           PressTotal* total) {
    constexpr WallSide out = WallSide::outside;
    constexpr WallSide in = WallSide::inside;
    if (side == out)
      return step.keeps ? press_rows<out, true>(step, body, at, rows, count, sums, total)
                        : press_rows<out, false>(step, body, at, rows, count, sums, total);
    return step.keeps ? press_rows<in, true>(step, body, at, rows, count, sums, total)
                      : press_rows<in, false>(step, body, at, rows, count, sums, total);
  }

  template <WallSide side>
  static float depth_in_rows(const StepFigures& step, const BodyFigures<Body>& body,
                             const RowPlaces& places, const BodyRow<Body>* rows, int count) {
    Float8 deepest = all(0.0f);
    for (const BodyRow<Body>* task = rows; task != rows + count; ++task) {
      const Row row(body, *task);
      const float* const face =
          places.face + static_cast<long>(places.stride) * places.stored[task->k];
      for (int n = 0; n < task->used; ++n)
        for (int i = task->ranges[n].begin * kLanes; i < task->ranges[n].end * kLanes;
             i += kLanes) {
          const Float8 radius = load(face + i);
          typename Row::Met m;
          row.template meet<side, true>(load(step.ray_cos + i), load(step.ray_sin + i), radius, m);
          const Float8 press = press_of<side>(radius, target_of<side, true>(m.end, step));
          deepest = larger(deepest, only(m.hit & (press > all(kSnap)), press));
        }
    }
    return largest(deepest);
  }

  static float depth(WallSide side, const StepFigures& step, const BodyFigures<Body>& body,
                     const RowPlaces& at, const BodyRow<Body>* rows, int count) {
    return side == WallSide::outside ? depth_in_rows<WallSide::outside>(step, body, at, rows, count)
                                     : depth_in_rows<WallSide::inside>(step, body, at, rows, count);
  }

  static constexpr contact::BodyKernel<Body> kAll{press, depth};
};

}  // namespace onggi::ONGGI_LANES
