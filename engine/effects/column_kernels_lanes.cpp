#include "engine/effects/column_kernels.h"
#include "engine/effects/moving_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

using namespace column_kernels;

// e^-3 is taken off, so that the pull ends without a step: propagation.h.
constexpr float kOff = 0.049787068367863944f;
constexpr float kScale = 1.0f / (1.0f - kOff);

ONGGI_INLINE float* in_row(float* column, const Columns& at, int k) {
  return column + static_cast<long>(at.stride) * at.stored[k];
}

// Thomas' algorithm for the changes x of the squares of radii, which are q now:
// (w_k + f_k + f_k-1) x_k - f_k x_k+1 - f_k-1 x_k-1 = f_k (q_k+1 - q_k) - f_k-1 (q_k - q_k-1).
// Of differences floats keep their digits, and a column that is even stays so to the bit.
ONGGI_INLINE void solve_column(const Even& c) {
  Float8 radius = load(in_row(c.at.face, c.at, 0));
  Float8 below = all(0.0f);  // what flowed in from the row below, before
  Float8 change = all(0.0f);
  float flow = 0.0f;
  for (int k = 0; k < c.at.rows; ++k) {
    const Float8 next = k + 1 < c.at.rows ? load(in_row(c.at.face, c.at, k + 1)) : radius;
    const Float8 above = all(c.flow[k]) * ((next - radius) * (next + radius));
    change = ((above - below) + all(flow) * change) * all(c.inverse[k]);
    store(change, c.change + kLanes * k);
    flow = c.flow[k];
    below = above;
    radius = next;
  }
}

// Back down; what rounding left over is then taken from all of them, so that no clay is made of it.
ONGGI_INLINE void end_column(const Even& c) {
  Float8 change = all(0.0f);
  Float8 over = all(0.0f);
  for (int k = c.at.rows - 1; k >= 0; --k) {
    change = load(c.change + kLanes * k) + all(c.up[k]) * change;
    over = over + all(c.weight[k]) * change;
    store(change, c.change + kLanes * k);
  }
  over = over * all(c.per_weight);
  for (int k = 0; k < c.at.rows; ++k)
    store(load(c.change + kLanes * k) - over, c.change + kLanes * k);
}

// A column where the wall would get too thin goes only as far as it may, all of it alike: then it
// has lost nothing, and is still between what it was and what it would be.
template <bool outside>
ONGGI_INLINE Float8 share_of_column(const Even& c) {
  const Float8 zero = all(0.0f);
  const Float8 one = all(1.0f);
  const Float8 wall = all(c.at.wall_min);
  Float8 share = one;
  for (int k = 0; k < c.at.rows; ++k) {
    const Float8 change = load(c.change + kLanes * k);
    const Float8 radius = load(in_row(c.at.face, c.at, k));
    const Float8 back = load(in_row(c.at.other, c.at, k));
    const Float8 limit = outside ? back + wall : larger(back - wall, zero);
    const Float8 room = (limit - radius) * (limit + radius);
    const Mask8 beyond = (outside ? change < room : change > room) & real(radius);
    if (none(beyond)) continue;
    const Float8 part = select(abs(change) > zero, room / change, zero);
    share = smaller(share, select(beyond, larger(part, zero), one));
  }
  return share;
}

template <bool outside>
ONGGI_INLINE bool even_column_as(const Even& c) {
  solve_column(c);
  end_column(c);
  const Float8 share = share_of_column<outside>(c);
  const Float8 none_yet = all(outside ? 0.0f : 1e9f);
  bool changed = false;
  for (int k = 0; k < c.at.rows; ++k) {
    float* const face = in_row(c.at.face, c.at, k);
    const Float8 before = load(face);
    const Float8 change = share * load(c.change + kLanes * k);
    const Float8 root = sqrt(larger(before * before + change, all(0.0f)));
    const Mask8 there = real(before);
    const Float8 then = select(there, before + change / (before + root), before);
    if (none((then < before) | (then > before))) continue;
    changed = true;
    store(then, face);
    c.gained[k] += static_cast<double>(sum(only(there, (then - before) * (then + before))));
    const Float8 reach = select(there, then, none_yet);
    const float farthest = outside ? largest(reach) : smallest(reach);
    if (outside ? farthest > c.extent[k] : farthest < c.extent[k]) c.extent[k] = farthest;
  }
  return changed;
}

bool even_column(const Even& work) {
  return work.at.outside ? even_column_as<true>(work) : even_column_as<false>(work);
}

// The strongest pull of the rows behind, each element's for itself: as it was there, and faded by e
// to the distance over the reach.
struct Pull {
  Float8 source = all(0.0f), carried = all(0.0f);

  // What a row follows beyond what it moved by itself.
  ONGGI_INLINE Float8 on(Float8 moved, float faded, Mask8& follows, Float8& now) {
    const Float8 weaker = carried * all(faded);
    const Float8 pulled = (weaker - all(kOff) * source) * all(kScale);
    follows = pulled > moved;
    carried = select(follows, weaker, moved);
    source = select(follows, source, moved);
    now = select(follows, pulled, moved);
    return only(follows, pulled - moved);
  }
};

// Up, from the lowest pressed row. Above them nothing moved by itself, and a pull only fades: where
// it drags nothing, it will drag nothing farther up. Gives the row after the last that it looked
// at.
ONGGI_INLINE int drag_up(const Drag& d) {
  Pull pull;
  int k = d.first;
  for (; k < d.at.rows; ++k) {
    float* const own = in_row(d.moved, d.at, k);
    Mask8 follows;
    Float8 now;
    const Float8 extra = pull.on(load(own), k > d.first ? d.fading[k] : 0.0f, follows, now);
    store(extra, d.more + kLanes * k);
    if (!none(follows)) {
      store(now, own);
    } else if (k >= d.end) {
      return k + 1;
    }
  }
  return k;
}

// And down. Gives the last row that it looked at.
ONGGI_INLINE int drag_down(const Drag& d) {
  Pull pull;
  for (int k = d.end - 1; k >= 0; --k) {
    float* const own = in_row(d.moved, d.at, k);
    float* const more = d.more + kLanes * k;
    Mask8 follows;
    Float8 now;
    const Float8 extra = pull.on(load(own), k + 1 < d.end ? d.fading[k + 1] : 0.0f, follows, now);
    if (k < d.first) store(extra, more);
    if (none(follows)) {
      if (k < d.first) return k;
      continue;
    }
    store(now, own);
    if (k >= d.first) store(load(more) + extra, more);
  }
  return 0;
}

template <bool outside, bool hollow>
ONGGI_INLINE void move_in_row(const Drag& d, int k, Float8 way) {
  const bool firm = d.give != nullptr && d.give[k] == Give::firm;
  const row_kernels::FaceMove how{outside,     hollow,        d.near,
                                  d.far,       d.at.wall_min, firm ? 1.0f : d.along,
                                  d.back_near, d.back_far};
  MovedLanes sums;
  move_lanes<outside, hollow>(how, way, in_row(d.at.face, d.at, k), in_row(d.at.other, d.at, k),
                              sums);
  const row_kernels::FaceMoved moved = sums.all_of_them();
  d.lost[k] += static_cast<double>(moved.lost);
  if (moved.outermost > d.outermost[k]) d.outermost[k] = moved.outermost;
  if (moved.innermost < d.innermost[k]) d.innermost[k] = moved.innermost;
}

template <bool outside>
ONGGI_INLINE Dragged drag_column_as(const Drag& d) {
  const int to = drag_up(d);
  const int from = drag_down(d);
  for (int k = from; k < to; ++k) {
    const Float8 way = load(d.more + kLanes * k);
    if (none(way > all(0.0f)) || (d.give != nullptr && d.give[k] == Give::rigid)) continue;
    // Solid rows have no other face, and from inside none at all.
    if (!outside || k >= d.hollow_from)
      move_in_row<outside, true>(d, k, way);
    else
      move_in_row<true, false>(d, k, way);
  }
  return {from, to};
}

Dragged drag_column(const Drag& work) {
  return work.at.outside ? drag_column_as<true>(work) : drag_column_as<false>(work);
}

}  // namespace

extern const column_kernels::Table kColumnKernels{even_column, drag_column};

}  // namespace onggi::ONGGI_LANES
