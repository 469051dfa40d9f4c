#include "engine/effects/row_kernels.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

using namespace row_kernels;

constexpr float kBeyondClay = 2.0f;  // m: no radius, but padding
// e^-3 is taken off, so that the pull ends without a step: propagation.h.
constexpr float kOff = 0.049787068367863944f;
constexpr float kScale = 1.0f / (1.0f - kOff);

ONGGI_INLINE Mask8 real(Float8 radius) { return abs(radius) < all(kBeyondClay); }
ONGGI_INLINE Float8 within(Float8 v, Float8 low, Float8 high) {
  return smaller(larger(v, low), high);
}

template <bool outside, bool hollow>
ONGGI_INLINE FaceMoved move_as(const FaceMove& how, BlockRun run, const float* by, float* face,
                               float* behind) {
  const Float8 zero = all(0.0f);
  Float8 lost = zero;
  Float8 outermost = zero;
  Float8 innermost = all(1e9f);
  for (int i = run.begin * kLanes; i < run.end * kLanes; i += kLanes) {
    const Float8 way = load(by + i);
    const Float8 radius = load(face + i);
    const Mask8 moves = (abs(way) > zero) & real(radius);
    if (none(moves)) continue;
    // A face that is beyond a limit already goes no further.
    const Float8 asked = outside ? radius - way : radius + way;
    const Float8 held = within(asked, smaller(all(how.near), radius), larger(all(how.far), radius));
    const Float8 now = select(moves, held, radius);
    const Float8 gone = (radius - now) * (radius + now);
    store(now, face + i);
    Float8 area = only(moves, outside ? gone : zero - gone);
    outermost = larger(only(moves, now), outermost);
    if constexpr (hollow) {
      const Float8 back = load(behind + i);
      const Float8 square = larger(back * back - all(how.along) * gone, zero);
      Float8 then =
          within(sqrt(square), smaller(all(how.back_near), back), larger(all(how.back_far), back));
      then =
          outside ? smaller(then, now - all(how.wall_min)) : larger(then, now + all(how.wall_min));
      then = select(moves, then, back);
      store(then, behind + i);
      const Float8 moved = only(moves, (back - then) * (back + then));
      area = outside ? area - moved : area + moved;
      innermost = smaller(select(moves, outside ? then : now, all(1e9f)), innermost);
      outermost = larger(only(moves, outside ? now : then), outermost);
    }
    lost = lost + area;
  }
  return {sum(lost), largest(outermost), smallest(innermost)};
}

FaceMoved move_elements(const FaceMove& how, BlockRun run, const float* by, float* face,
                        float* behind) {
  if (!how.outside) return move_as<false, true>(how, run, by, face, behind);
  return how.hollow ? move_as<true, true>(how, run, by, face, behind)
                    : move_as<true, false>(how, run, by, face, behind);
}

float pull_elements(BlockRun run, float faded, float* own, float* source, float* carried,
                    float* more) {
  const Float8 fading = all(faded);
  const Float8 zero = all(0.0f);
  Float8 most = zero;
  for (int i = run.begin * kLanes; i < run.end * kLanes; i += kLanes) {
    const Float8 moved = load(own + i);
    const Float8 strong = load(source + i);
    const Float8 weaker = load(carried + i) * fading;
    const Float8 pulled = (weaker - all(kOff) * strong) * all(kScale);
    const Mask8 follows = pulled > moved;
    const Float8 extra = only(follows, pulled - moved);
    store(select(follows, weaker, moved), carried + i);
    store(select(follows, strong, moved), source + i);
    store(select(follows, pulled, moved), own + i);
    store(extra, more + i);
    most = larger(extra, most);
  }
  return largest(most);
}

float spring_elements(int stride, float gone, float least, float* left, float* move) {
  const Float8 zero = all(0.0f);
  Float8 most = zero;
  for (int i = 0; i < stride; i += kLanes) {
    const Float8 was = load(left + i);
    const Float8 back = select(was < all(least), was, was * all(gone));
    const Float8 now = was - back;
    store(now, left + i);
    store(zero - back, move + i);
    most = larger(now, most);
  }
  return largest(most);
}

Harmonic sum_harmonic(int stride, const float* radius, const float* ray_cos, const float* ray_sin) {
  Float8 x = all(0.0f);
  Float8 z = all(0.0f);
  for (int i = 0; i < stride; i += kLanes) {
    const Float8 r = load(radius + i);  // padding's rays are 0
    x = x + r * load(ray_cos + i);
    z = z + r * load(ray_sin + i);
  }
  return {sum(x), sum(z)};
}

FaceMoved push_elements(const RowPush& how, int stride, const float* ray_cos, const float* ray_sin,
                        float* outer, float* inner) {
  const Float8 wall = all(how.wall_min);
  const Float8 most = all(how.most);
  Float8 outermost = all(0.0f);
  Float8 innermost = all(1e9f);
  for (int i = 0; i < stride; i += kLanes) {
    const Float8 way = all(how.x) * load(ray_cos + i) + all(how.z) * load(ray_sin + i);
    const Float8 out = load(outer + i);
    const Float8 in = load(inner + i);
    const Mask8 there = real(out);
    const Float8 in_now =
        how.hollow ? select(there, within(in + way, all(how.least), most - wall), in) : in;
    const Float8 hole = how.hollow ? in_now : all(how.least);  // that a solid row may get
    const Float8 out_now = select(there, within(out + way, hole + wall, most), out);
    store(in_now, inner + i);
    store(out_now, outer + i);
    outermost = larger(out_now, outermost);
    innermost = smaller(in_now, innermost);
  }
  return {0.0f, largest(outermost), smallest(innermost)};
}

WallBounds bounds_of(int stride, const float* outer, const float* inner) {
  Float8 farthest = all(0.0f);
  Float8 thinnest = all(kBeyondClay);
  for (int i = 0; i < stride; i += kLanes) {
    const Float8 out = load(outer + i);
    farthest = larger(out, farthest);  // padding is far below
    thinnest = smaller(select(real(out), out - load(inner + i), thinnest), thinnest);
  }
  return {largest(farthest), smallest(thinnest)};
}

FaceMoved mix_faces(int stride, float same, float cross, float wall_min, float* outer,
                    float* inner) {
  Float8 outermost = all(0.0f);
  Float8 innermost = all(1e9f);
  for (int i = 0; i < stride; i += kLanes) {
    const Float8 out = load(outer + i);
    const Float8 in = load(inner + i);
    const Mask8 there = real(out);
    const Float8 in_now = select(there, in * all(same) + out * all(cross), in);
    const Float8 out_now =
        select(there, larger(out * all(same) + in * all(cross), in_now + all(wall_min)), out);
    store(out_now, outer + i);
    store(in_now, inner + i);
    outermost = larger(out_now, outermost);
    innermost = smaller(in_now, innermost);
  }
  return {0.0f, largest(outermost), smallest(innermost)};
}

Ring measure_elements(int stride, const float* outer, const float* inner) {
  Float8 squares = all(0.0f);
  Float8 thinnest = all(kBeyondClay);
  for (int i = 0; i < stride; i += kLanes) {
    const Float8 out = load(outer + i);
    const Float8 in = load(inner + i);
    const Mask8 there = real(out);
    squares = squares + only(there, out * out + in * in);
    thinnest = smaller(select(there, out - in, thinnest), thinnest);
  }
  return {sum(squares), smallest(thinnest)};
}

// Thomas' algorithm on (w_j + f_j + f_j-1) q_j - f_j q_j+1 - f_j-1 q_j-1 = w_j q_j before, for
// eight columns: plain loops over eight doubles, which compilers make vectors of.
template <bool outside>
ONGGI_INLINE void solve_columns(const Columns& c) {
  double below[kLanes] = {};
  double* squares = c.squares;
  for (int k = 0; k < c.rows; ++k, squares += kLanes) {
    const float* const face = c.face + static_cast<long>(c.stride) * c.stored[k];
    const double weight = c.weight[k];
    const double flow = k > 0 ? c.flow[k - 1] : 0.0;
    const double pivot = c.pivot[k];
    for (int i = 0; i < kLanes; ++i) {
      const double radius = static_cast<double>(face[i]);
      below[i] = (weight * (radius * radius) + flow * below[i]) / pivot;
    }
    for (int i = 0; i < kLanes; ++i) squares[i] = below[i];
  }
  squares -= kLanes;
  for (int k = c.rows - 2; k >= 0; --k) {
    squares -= kLanes;
    const double up = c.up[k];
    for (int i = 0; i < kLanes; ++i) squares[i] = below[i] = squares[i] + up * below[i];
  }
}

// A column where the wall would get too thin goes only as far as it may, all of it alike: then it
// has lost nothing, and is still between what it was and what it would be.
template <bool outside>
ONGGI_INLINE void share_columns(const Columns& c, double* share) {
  for (int i = 0; i < kLanes; ++i) share[i] = 1.0;
  for (int k = 0; k < c.rows; ++k) {
    const float* const face = c.face + static_cast<long>(c.stride) * c.stored[k];
    const float* const other = c.other + static_cast<long>(c.stride) * c.stored[k];
    const double* const squares = c.squares + kLanes * k;
    double room[kLanes];
    double way[kLanes];
    int beyond = 0;
    for (int i = 0; i < kLanes; ++i) {
      const double radius = static_cast<double>(face[i]);
      const double was = radius * radius;
      const double back = static_cast<double>(other[i]);
      const double in = back - c.wall_min;
      const double limit = outside ? back + c.wall_min : in < 0.0 ? 0.0 : in;
      room[i] = limit * limit - was;
      way[i] = squares[i] - was;
      beyond += outside ? way[i] < room[i] : way[i] > room[i];
    }
    if (beyond == 0) continue;
    for (int i = 0; i < kLanes; ++i) {
      if (outside ? !(way[i] < room[i]) : !(way[i] > room[i])) continue;
      const double part = way[i] != 0.0 ? room[i] / way[i] : 0.0;
      const double most = part < 0.0 ? 0.0 : 1.0 < part ? 1.0 : part;
      share[i] = most < share[i] ? most : share[i];
    }
  }
}

template <bool outside>
ONGGI_INLINE bool even_columns_as(const Columns& c) {
  solve_columns<outside>(c);
  double share[kLanes];
  share_columns<outside>(c, share);
  const Float8 none_yet = all(outside ? 0.0f : 1e9f);
  bool changed = false;
  for (int k = 0; k < c.rows; ++k) {
    float* const face = c.face + static_cast<long>(c.stride) * c.stored[k];
    const double* const squares = c.squares + kLanes * k;
    float asked[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      const double radius = static_cast<double>(face[i]);
      const double was = radius * radius;
      asked[i] = static_cast<float>(__builtin_sqrt(was + share[i] * (squares[i] - was)));
    }
    const Float8 before = load(face);
    const Float8 then = select(real(before), load(asked), before);
    if (none((then < before) | (then > before))) continue;
    changed = true;
    double gained[kLanes];
    float now[kLanes];
    store(then, now);
    for (int i = 0; i < kLanes; ++i) {
      const double radius = static_cast<double>(face[i]);
      const double new_radius = static_cast<double>(now[i]);
      gained[i] = new_radius * new_radius - radius * radius;
    }
    store(then, face);
    // One after the other, as in any order of columns that goes up.
    double sum_of = c.gained[k];
    for (int i = 0; i < kLanes; ++i) sum_of += gained[i];
    c.gained[k] = sum_of;
    const Float8 reach = select(real(before), then, none_yet);
    const float farthest = outside ? largest(reach) : smallest(reach);
    if (outside ? farthest > c.extent[k] : farthest < c.extent[k]) c.extent[k] = farthest;
  }
  return changed;
}

bool even_columns(const Columns& columns) {
  return columns.outside ? even_columns_as<true>(columns) : even_columns_as<false>(columns);
}

}  // namespace

extern const row_kernels::Table kRowKernels{move_elements, pull_elements,    spring_elements,
                                            sum_harmonic,  push_elements,    bounds_of,
                                            mix_faces,     measure_elements, even_columns};

}  // namespace onggi::ONGGI_LANES
