#include "engine/contact/press.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/window.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr int kLanes = 8;
constexpr float kSnap =
    1e-9f;  // presses below a nanometre are none: no denormals, and rest is rest

// The sphere's section with one row's plane, from above.
struct Section {
  float x, z;    // centre
  float radius;  // of the section; -1 where the sphere does not reach the row
  float dy;      // sphere's centre above the row

  Section(Vec3 centre, double sphere_radius, double height)
      : x(static_cast<float>(centre.x)),
        z(static_cast<float>(centre.z)),
        radius(static_cast<float>(cross_section(sphere_radius, centre.y - height))),
        dy(static_cast<float>(centre.y - height)) {}
};

// Where the sphere wants the face of one element, and how the ray meets it.
struct Target {
  float radius;  // R_t, clipped to what the clay allows
  float u, t;    // section's centre along the ray, and off it (signed)
  bool hit;
};

// The two faces, as the sign of the press and the bounds of the target.
template <WallSide side>
inline Target target_of(const Section& at, float c, float s, float limit) {
  Target out;
  out.u = at.x * c + at.z * s;
  out.t = at.z * c - at.x * s;
  const float off = std::fabs(out.t);
  // (r - s)(r + s) instead of r^2 - s^2: at a tangent ray the squares would cancel.
  const float square = (at.radius - off) * (at.radius + off);
  const float q = std::sqrt(square > 0.0f ? square : 0.0f);
  if constexpr (side == WallSide::outside) {
    // A tool outside works the half of the clay that it stands over; beyond the axis is not it.
    const float e1 = out.u - q;
    out.hit = (off < at.radius) & (out.u > 0.0f);
    out.radius = e1 > limit ? e1 : limit;
  } else {
    const float e2 = out.u + q;
    out.hit = (off < at.radius) & (e2 > 0.0f);
    out.radius = e2 < limit ? e2 : limit;
  }
  return out;
}

// How far the face may be pressed: the clay keeps its thinnest wall about radius_min, and within
// radius_max.
template <WallSide side>
float limit_of(const ClayDef& def) {
  return static_cast<float>(side == WallSide::outside ? def.radius_min + def.wall_min
                                                      : def.radius_max - def.wall_min);
}

// What is the same for every element of a row.
struct RowStep {
  Section from, to;
  float limit;     // of the target: innermost for a press from outside, outermost from inside
  float wall_min;  // hugely negative on floor rows: there is no inner face to carry along
  float decay;     // a = e^(-dt/tau)
  float rate;      // tau/dt
  float mean;      // (tau/dt)(1 - a): mean of a decaying press over the step
  int sectors;
};

struct RowSum {
  float x[kLanes]{}, z[kLanes]{}, y[kLanes]{}, normal[kLanes]{}, depth[kLanes]{};
  int touched[kLanes]{};
  int moved[kLanes]{};
};

// One block of eight elements. The law, with S the face and R(t) = R0 + v t the target, seen from
// the tool's side so that a press is positive (l = S - R outside, R - S inside):
//   pressed all through: l1 = (l0 + v tau) a - v tau            (Maxwell element under a ramp)
//   the tool arrives or leaves within the step: the same for the share of the step it touched.
// A ray that the sphere misses at one end of the step counts as just touched there.
template <WallSide side>
inline void press_block(const RowStep& row, int first, const float* ray_cos, const float* ray_sin,
                        float* face, float* behind, RowSum& sum) {
  constexpr float sign = side == WallSide::outside ? 1.0f : -1.0f;
  for (int k = 0; k < kLanes; ++k) {
    const float c = ray_cos[k];
    const float s = ray_sin[k];
    const float radius = face[k];
    const Target start = target_of<side>(row.from, c, s, row.limit);
    const Target end = target_of<side>(row.to, c, s, row.limit);
    const bool live = first + k < row.sectors;
    const float r0 = start.hit ? start.radius : radius;
    const float r1 = end.hit ? end.radius : radius;

    const float l0 = sign * (radius - r0);
    const float gap = sign * (radius - r1);  // l at the end, had the clay not given way
    const float ramp = sign * (r1 - r0) * row.rate;
    const float l_full = (l0 + ramp) * row.decay - ramp;
    const bool arrives = l0 < 0.0f;
    const bool leaves = !arrives & (l_full < 0.0f);
    const bool touch = live & (arrives ? gap > kSnap : (l0 > kSnap) | (l_full > kSnap));
    // Share of the step in touch, where it is not the whole.
    const float part = arrives ? gap : l0;
    const float whole = arrives ? gap - l0 : l0 - l_full;
    const float share = part / (whole > kSnap ? whole : kSnap);
    const float l_arrived = (row.decay - 1.0f) * ramp * share;
    float l1 = arrives ? l_arrived : l_full;
    l1 = l1 > kSnap ? l1 : 0.0f;
    const float l_mean =
        arrives ? 0.5f * l1 * share : (leaves ? 0.5f * l0 * share : (l0 + ramp) * row.mean - ramp);
    // The face follows the tool and never springs back.
    float moved = leaves ? r0 + (r1 - r0) * share : r1 + sign * l1;
    moved = sign * (radius - moved) > 0.0f ? moved : radius;
    const float now = touch ? moved : radius;
    face[k] = now;
    const float back = behind[k];
    const float carried = now - sign * row.wall_min;
    behind[k] = live & (sign * (back - carried) > 0.0f) ? carried : back;

    // Reaction along the sphere's own normal, (H - E) / H_r: E lies on the sphere. Where the target
    // was clipped it does not; then the normal's radial part is what is left of it.
    const float nu = end.hit ? end.u - end.radius : start.u - start.radius;
    const float nt = end.hit ? end.t : start.t;
    const float ny = end.hit ? row.to.dy : row.from.dy;
    const float nr = sign * nu > 0.0f ? nu : 0.0f;
    const float square = nr * nr + nt * nt + ny * ny;
    const float length = std::sqrt(square > 1e-20f ? square : 1e-20f);
    const float press = touch ? l_mean * radius : 0.0f;  // times k_A dtheta dh later
    const float along = press / length;
    sum.x[k] += along * (nr * c - nt * s);
    sum.z[k] += along * (nr * s + nt * c);
    sum.y[k] += along * ny;
    sum.normal[k] += press;
    const float l_most = l0 > l1 ? l0 : l1;
    sum.depth[k] = touch & (l_most > sum.depth[k]) ? l_most : sum.depth[k];
    sum.touched[k] += touch ? 1 : 0;
    sum.moved[k] |= now != radius ? 1 : 0;
  }
}

// Lanes added in pairs, always the same ones: the same bits from any vector width.
template <class T>
T lane_sum(const T (&v)[kLanes]) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

template <WallSide side>
Press press_side(Clay& clay, const SphereStep& step, const Yielding& yielding) {
  const ClayDef& def = clay.def();
  const double tau = yielding.relaxation_time;
  const double gone = -portable::expm1(-step.seconds / tau);  // 1 - a, exact for short steps
  const Window window(clay, step.from, step.to, step.radius);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();
  const double sector = 2.0 * portable::kPi / def.sectors;

  Press out;
  float depth = 0.0f;
  // A tool inside never reaches the solid floor rows: the floor is a stop (stops.h).
  const int first_row = side == WallSide::inside ? std::max(window.first_row(), clay.floor_rows())
                                                 : window.first_row();
  for (int j = first_row; j < window.end_row(); ++j) {
    const double height = clay.row_height(j);
    const bool floor_row = j < clay.floor_rows();
    const RowStep row{Section(step.from, step.radius, height),
                      Section(step.to, step.radius, height),
                      limit_of<side>(def),
                      floor_row ? -1e9f : static_cast<float>(def.wall_min),
                      static_cast<float>(1.0 - gone),
                      static_cast<float>(tau / step.seconds),
                      static_cast<float>(tau / step.seconds * gone),
                      def.sectors};
    float* face = side == WallSide::outside ? clay.outer_mut(j).data() : clay.inner_mut(j).data();
    float* behind = side == WallSide::outside ? clay.inner_mut(j).data() : clay.outer_mut(j).data();

    RowSum sum;
    BlockRange ranges[2];
    const double section = std::max(row.from.radius, row.to.radius);
    const int count = window.blocks(section, ranges);
    for (int n = 0; n < count; ++n) {
      for (int block = ranges[n].begin; block < ranges[n].end; ++block) {
        const int i = block * kLanes;
        press_block<side>(row, i, ray_cos + i, ray_sin + i, face + i, behind + i, sum);
      }
      out.visited += (ranges[n].end - ranges[n].begin) * kLanes;
    }
    const int touched = lane_sum(sum.touched);
    if (touched == 0) continue;
    const double area = yielding.stiffness * sector * clay.row_thickness(j);
    out.touched += touched;
    out.force +=
        area * Vec3{double{lane_sum(sum.x)}, double{lane_sum(sum.y)}, double{lane_sum(sum.z)}};
    out.normal += area * double{lane_sum(sum.normal)};
    for (float lane : sum.depth) depth = std::max(depth, lane);
    if (lane_sum(sum.moved) != 0) clay.mark_dirty(j);
  }
  out.depth = depth;
  return out;
}

template <WallSide side>
double depth_side(const Clay& clay, Vec3 at, double radius, std::int64_t* visited) {
  constexpr float sign = side == WallSide::outside ? 1.0f : -1.0f;
  const Window window(clay, at, at, radius);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();
  const float limit = limit_of<side>(clay.def());
  const int first_row = side == WallSide::inside ? std::max(window.first_row(), clay.floor_rows())
                                                 : window.first_row();
  float deepest = 0.0f;
  for (int j = first_row; j < window.end_row(); ++j) {
    const Section section(at, radius, clay.row_height(j));
    const float* face = side == WallSide::outside ? clay.outer(j).data() : clay.inner(j).data();
    BlockRange ranges[2];
    const int count = window.blocks(section.radius, ranges);
    for (int n = 0; n < count; ++n) {
      const int end = std::min(ranges[n].end * kLanes, clay.sectors());
      for (int i = ranges[n].begin * kLanes; i < end; ++i) {
        const Target target = target_of<side>(section, ray_cos[i], ray_sin[i], limit);
        const float depth = sign * (face[i] - target.radius);
        deepest = target.hit & (depth > deepest) ? depth : deepest;
      }
      if (visited != nullptr) *visited += end - ranges[n].begin * kLanes;
    }
  }
  return deepest > kSnap ? double{deepest} : 0.0;
}

}  // namespace

Press press(Clay& clay, WallSide side, const SphereStep& step, const Yielding& yielding) noexcept {
  return side == WallSide::outside ? press_side<WallSide::outside>(clay, step, yielding)
                                   : press_side<WallSide::inside>(clay, step, yielding);
}

double depth_at(const Clay& clay, WallSide side, Vec3 at, double radius,
                std::int64_t* visited) noexcept {
  return side == WallSide::outside ? depth_side<WallSide::outside>(clay, at, radius, visited)
                                   : depth_side<WallSide::inside>(clay, at, radius, visited);
}

}  // namespace onggi
