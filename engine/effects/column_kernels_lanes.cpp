#include "engine/effects/column_kernels.h"
#include "engine/effects/moving_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

using namespace column_kernels;

// e^-3, subtracted so that the pull ends without a step: propagation.h.
constexpr float kOff = 0.049787068367863944f;
constexpr float kScale = 1.0f / (1.0f - kOff);

template <class F>  // float or const float
ONGGI_INLINE F* in_row(F* column, const Columns& at, int k) {
  return column + static_cast<long>(at.stride) * at.stored[k];
}

ONGGI_INLINE float* of_row(float* eights, const Columns& at, int k) {
  return eights + kLanes * at.blocks * k;
}

// Marks the columns that moved with a share of 1, the others with 0. False if none did.
ONGGI_INLINE bool moved_columns(const Even& c, Float8* share) {
  const Float8 zero = all(0.0f);
  Float8 most[kMostBlocks];
  for (int b = 0; b < c.at.blocks; ++b) most[b] = zero;
  for (int k = 0; k < c.at.rows; ++k) {
    const float* const moved = in_row(c.moved, c.at, k);
    for (int b = 0; b < c.at.blocks; ++b) most[b] = larger(load(moved + kLanes * b), most[b]);
  }
  bool any = false;
  for (int b = 0; b < c.at.blocks; ++b) {
    const Mask8 moves = most[b] > zero;
    share[b] = only(moves, all(1.0f));
    any |= !none(moves);
  }
  return any;
}

// Thomas' algorithm. x are the changes of the squares of radii q: (w_k + f_k + f_k-1) x_k - f_k
// x_k+1 - f_k-1 x_k-1 = f_k (q_k+1 - q_k) - f_k-1 (q_k - q_k-1). Solving for differences keeps a
// float's digits, and an even column stays even to the bit.
ONGGI_INLINE void solve_columns(const Even& c) {
  Float8 radius[kMostBlocks];
  Float8 below[kMostBlocks];  // inflow from the row below, before
  Float8 change[kMostBlocks];
  for (int b = 0; b < c.at.blocks; ++b) {
    radius[b] = load(in_row(c.at.face, c.at, 0) + kLanes * b);
    below[b] = change[b] = all(0.0f);
  }
  float flow = 0.0f;
  for (int k = 0; k < c.at.rows; ++k) {
    const float* const next_row = in_row(c.at.face, c.at, k + 1 < c.at.rows ? k + 1 : k);
    float* const changes = of_row(c.change, c.at, k);
    const Float8 on = all(c.flow[k]);
    const Float8 inverse = all(c.inverse[k]);
    const Float8 in = all(flow);
    for (int b = 0; b < c.at.blocks; ++b) {
      const Float8 next = load(next_row + kLanes * b);
      const Float8 above = on * ((next - radius[b]) * (next + radius[b]));
      change[b] = ((above - below[b]) + in * change[b]) * inverse;
      store(change[b], changes + kLanes * b);
      below[b] = above;
      radius[b] = next;
    }
    flow = c.flow[k];
  }
}

// Substitutes back down. What rounding added is averaged, to be subtracted from all rows, so that
// no clay is created.
ONGGI_INLINE void end_columns(const Even& c, Float8* over) {
  Float8 change[kMostBlocks];
  for (int b = 0; b < c.at.blocks; ++b) change[b] = over[b] = all(0.0f);
  for (int k = c.at.rows - 1; k >= 0; --k) {
    float* const changes = of_row(c.change, c.at, k);
    const Float8 up = all(c.up[k]);
    const Float8 weight = all(c.weight[k]);
    for (int b = 0; b < c.at.blocks; ++b) {
      change[b] = load(changes + kLanes * b) + up * change[b];
      over[b] = over[b] + weight * change[b];
      store(change[b], changes + kLanes * b);
    }
  }
  for (int b = 0; b < c.at.blocks; ++b) over[b] = over[b] * all(c.per_weight);
}

// Where the wall would get too thin, scales down the whole column's change. So the column loses no
// clay, and stays between its old and its full change.
template <bool outside>
ONGGI_INLINE void share_columns(const Even& c, const Float8* over, Float8* share) {
  const Float8 zero = all(0.0f);
  const Float8 one = all(1.0f);
  const Float8 wall = all(c.at.wall_min);
  for (int k = 0; k < c.at.rows; ++k) {
    const float* const changes = of_row(c.change, c.at, k);
    const float* const face = in_row(c.at.face, c.at, k);
    const float* const other = in_row(c.at.other, c.at, k);
    for (int b = 0; b < c.at.blocks; ++b) {
      const Float8 change = load(changes + kLanes * b) - over[b];
      const Float8 radius = load(face + kLanes * b);
      const Float8 back = load(other + kLanes * b);
      const Float8 limit = outside ? back + wall : larger(back - wall, zero);
      const Float8 room = (limit - radius) * (limit + radius);
      const Mask8 beyond = (outside ? change < room : change > room) & real(radius);
      if (none(beyond)) continue;
      const Float8 part = select(abs(change) > zero, room / change, zero);
      share[b] = smaller(share[b], select(beyond, larger(part, zero), one));
    }
  }
}

// Adds `by` to the radius `before`, as a float. The remainder stays owed: otherwise a change below
// a float's last digit would be lost in every tick.
ONGGI_INLINE Float8 moved_by(Float8 before, Float8 by, Mask8 there, float* owed) {
  const Float8 owed_before = load(owed);
  const Float8 all_of_it = by + owed_before;
  const Float8 then = before + all_of_it;
  store(select(there, all_of_it - (then - before), owed_before), owed);
  return then;
}

template <bool outside>
ONGGI_INLINE bool even_columns_as(const Even& c) {
  Float8 over[kMostBlocks];
  Float8 share[kMostBlocks];
  if (!moved_columns(c, share)) return false;
  solve_columns(c);
  end_columns(c, over);
  share_columns<outside>(c, over, share);
  const Float8 hole = all(c.hole_min);
  bool changed = false;
  for (int k = 0; k < c.at.rows; ++k) {
    const float* const changes = of_row(c.change, c.at, k);
    float* const face = in_row(c.at.face, c.at, k);
    float* const owed = c.rounded != nullptr ? in_row(c.rounded, c.at, k) : nullptr;
    Float8 gained = all(0.0f);
    Float8 most = all(0.0f);
    Float8 reach = all(outside ? 0.0f : 1e9f);
    for (int b = 0; b < c.at.blocks; ++b) {
      const Float8 before = load(face + kLanes * b);
      const Float8 change = share[b] * (load(changes + kLanes * b) - over[b]);
      const Float8 root = sqrt(larger(before * before + change, all(0.0f)));
      const Mask8 there = real(before) & (share[b] > all(0.0f));
      const Float8 by = change / (before + root);
      Float8 moved = owed == nullptr ? before + by : moved_by(before, by, there, owed + kLanes * b);
      // In a wide row, rounding of the squares can be larger than the smallest hole's square.
      if constexpr (!outside) moved = larger(moved, hole);
      const Float8 then = select(there, moved, before);
      store(then, face + kLanes * b);
      most = larger(abs(then - before), most);
      gained = gained + only(there, (then - before) * (then + before));
      reach =
          outside ? larger(only(there, then), reach) : smaller(select(there, then, reach), reach);
    }
    if (none(most > all(0.0f))) continue;
    changed = true;
    c.gained[k] += static_cast<double>(sum(gained));
    const float farthest = outside ? largest(reach) : smallest(reach);
    if (outside ? farthest > c.extent[k] : farthest < c.extent[k]) c.extent[k] = farthest;
  }
  return changed;
}

bool even_columns(const Even& work) {
  return work.at.outside ? even_columns_as<true>(work) : even_columns_as<false>(work);
}

// The strongest pull of the rows behind, for each element: the pull at its source, fading with
// e^-(distance / reach).
struct Pull {
  Float8 source[kMostBlocks], carried[kMostBlocks];

  ONGGI_INLINE explicit Pull(int blocks) {
    for (int b = 0; b < blocks; ++b) source[b] = carried[b] = all(0.0f);
  }
  // What eight elements follow beyond their own motion; adds it to `own`.
  ONGGI_INLINE Float8 on(int b, Float8 faded, float* own) {
    const Float8 moved = load(own);
    const Float8 weaker = carried[b] * faded;
    const Float8 pulled = (weaker - all(kOff) * source[b]) * all(kScale);
    const Mask8 follows = pulled > moved;
    carried[b] = select(follows, weaker, moved);
    source[b] = select(follows, source[b], moved);
    store(select(follows, pulled, moved), own);
    return only(follows, pulled - moved);
  }
};

template <bool outside, bool hollow>
ONGGI_INLINE void move_row_as(const Drag& d, int k, const float* ways) {
  const bool firm = d.give != nullptr && d.give[k] == Give::firm;
  const row_kernels::FaceMove how{outside,     hollow,        d.near,
                                  d.far,       d.at.wall_min, firm ? 1.0f : d.along,
                                  d.back_near, d.back_far};
  float* const face = in_row(d.at.face, d.at, k);
  float* const other = in_row(d.at.other, d.at, k);
  MovedLanes sums;
  for (int i = 0; i < kLanes * d.at.blocks; i += kLanes)
    move_lanes<outside, hollow>(how, load(ways + i), face + i, other + i, sums);
  const row_kernels::FaceMoved moved = sums.all_of_them();
  d.lost[k] += static_cast<double>(moved.lost);
  if (moved.outermost > d.outermost[k]) d.outermost[k] = moved.outermost;
  if (moved.innermost < d.innermost[k]) d.innermost[k] = moved.innermost;
}

template <bool outside>
ONGGI_INLINE void move_row(const Drag& d, int k, const float* ways) {
  if (d.give != nullptr && d.give[k] == Give::rigid) return;
  // Solid rows have no other face. From inside they have none to move.
  if (!outside || k >= d.hollow_from)
    move_row_as<outside, true>(d, k, ways);
  else
    move_row_as<true, false>(d, k, ways);
}

// Drags upwards, from the lowest pressed row. Above the pressed rows nothing moved by itself, and a
// pull only fades: once it drags nothing, it drags nothing farther up. Returns the row after the
// last that moved.
template <bool outside>
ONGGI_INLINE int drag_up(const Drag& d) {
  Pull pull(d.at.blocks);
  for (int k = d.first; k < d.at.rows; ++k) {
    float* const own = in_row(d.moved, d.at, k);
    float* const more = of_row(d.more, d.at, k < d.end ? k : d.end);
    const Float8 faded = all(k > d.first ? d.fading[k] : 0.0f);
    Float8 most = all(0.0f);
    for (int i = 0, b = 0; b < d.at.blocks; ++b, i += kLanes) {
      const Float8 extra = pull.on(b, faded, own + i);
      store(extra, more + i);
      most = larger(extra, most);
    }
    if (k < d.end) continue;
    if (none(most > all(0.0f))) return k;
    move_row<outside>(d, k, more);
  }
  return d.at.rows;
}

// Drags downwards, and moves rows by what both directions came to. Returns the last row that moved.
template <bool outside>
ONGGI_INLINE int drag_down(const Drag& d) {
  Pull pull(d.at.blocks);
  for (int k = d.end - 1; k >= 0; --k) {
    float* const own = in_row(d.moved, d.at, k);
    float* const more = of_row(d.more, d.at, k);
    const Float8 faded = all(k + 1 < d.end ? d.fading[k + 1] : 0.0f);
    const bool pressed = k >= d.first;
    Float8 most = all(0.0f);
    for (int i = 0, b = 0; b < d.at.blocks; ++b, i += kLanes) {
      const Float8 extra = pull.on(b, faded, own + i);
      const Float8 both = pressed ? load(more + i) + extra : extra;
      store(both, more + i);
      most = larger(both, most);
    }
    if (!none(most > all(0.0f)))
      move_row<outside>(d, k, more);
    else if (!pressed)
      return k + 1;
  }
  return 0;
}

Dragged drag_columns(const Drag& work) {
  const bool outside = work.at.outside;
  const int to = outside ? drag_up<true>(work) : drag_up<false>(work);
  return {outside ? drag_down<true>(work) : drag_down<false>(work), to};
}

}  // namespace

extern const column_kernels::Table kColumnKernels{even_columns, drag_columns};

}  // namespace onggi::ONGGI_LANES
