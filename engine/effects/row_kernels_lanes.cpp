#include "engine/effects/moving_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

using namespace row_kernels;

// How far eight elements come back; updates `left`.
ONGGI_INLINE Float8 springs(const Spring& how, float* left) {
  const Float8 was = load(left);
  const Float8 back = select(was < all(how.least), was, was * all(how.gone));
  store(was - back, left);
  return back;
}

template <bool outside, bool hollow>
ONGGI_INLINE Sprung spring_as(const Spring& how, int stride, float* left, float* face,
                              float* behind) {
  const Float8 zero = all(0.0f);
  Float8 most = zero;
  MovedLanes sums;
  for (int i = 0; i < stride; i += kLanes) {
    if (none(load(left + i) > zero)) continue;
    const Float8 back = springs(how, left + i);
    most = larger(load(left + i), most);
    move_lanes<outside, hollow>(how.face, zero - back, face + i, behind + i, sums);
  }
  return {sums.all_of_them(), largest(most)};
}

Sprung spring_elements(const Spring& how, int stride, float* left, float* face, float* behind) {
  if (!how.face.outside) return spring_as<false, true>(how, stride, left, face, behind);
  return how.face.hollow ? spring_as<true, true>(how, stride, left, face, behind)
                         : spring_as<true, false>(how, stride, left, face, behind);
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
    const Float8 hole = how.hollow ? in_now : all(how.least);  // that a solid row may get later
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

}  // namespace

extern const row_kernels::Table kRowKernels{spring_elements, sum_harmonic, push_elements,
                                            bounds_of,       mix_faces,    measure_elements};

}  // namespace onggi::ONGGI_LANES
