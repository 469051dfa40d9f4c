#include "engine/contact/press.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/window.h"
#include "engine/math/lanes.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

// A press below 20 nm is none. Floats at 5 cm are 4 nm apart, so a smaller one would never settle:
// rest must be rest, and there must be no denormals.
constexpr float kSnap = 2e-8f;

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

// How far the face may be pressed: the clay keeps its thinnest wall about radius_min, and within
// radius_max.
template <WallSide side>
float limit_of(const ClayDef& def) {
  return static_cast<float>(side == WallSide::outside ? def.radius_min + def.wall_min
                                                      : def.radius_max - def.wall_min);
}

// Positive is a press: S - R from outside, R - S from inside.
template <WallSide side>
Float8 press_of(Float8 face, Float8 target) {
  return side == WallSide::outside ? face - target : target - face;
}
// The same the other way: `face` moved from `target` towards where it came from by `press`.
template <WallSide side>
Float8 face_at(Float8 target, Float8 press) {
  return side == WallSide::outside ? target + press : target - press;
}

// How eight rays meet a section of the sphere.
struct Meeting {
  Float8 along, off;  // the section's centre along the ray, and to its side
  Float8 target;      // where the sphere wants the face, clipped to what the clay allows
  Mask8 hit;
};

template <WallSide side>
Meeting meet(const Section& at, Float8 c, Float8 s, float limit) {
  Meeting m;
  m.along = Float8(at.x) * c + Float8(at.z) * s;
  m.off = Float8(at.z) * c - Float8(at.x) * s;
  // (r - s)(r + s) instead of r^2 - s^2: at a tangent ray the squares would cancel.
  const Float8 off = abs(m.off);
  const Float8 square = (Float8(at.radius) - off) * (Float8(at.radius) + off);
  const Float8 half_chord = sqrt(larger(square, 0.0f));
  const Mask8 crossed = off < Float8(at.radius);
  if (side == WallSide::outside) {
    // A tool outside works the half of the clay that it stands over, not what lies beyond the axis.
    m.hit = crossed & (m.along > Float8(0.0f));
    m.target = larger(m.along - half_chord, limit);
  } else {
    const Float8 far_end = m.along + half_chord;
    m.hit = crossed & (far_end > Float8(0.0f));
    m.target = smaller(far_end, limit);
  }
  return m;
}

// What is the same for every element of a row.
struct RowStep {
  Section from, to;
  float limit;     // of the target
  float wall_min;  // hugely negative on floor rows: there is no inner face to carry along
  float decay;     // a = e^(-dt/tau)
  float gone;      // 1 - a
  float bow;       // how much more than its share of `gone` goes in half the step, times 4
  float rate;      // tau/dt
  float mean;      // (tau/dt)(1 - a): mean over the step of a press that decays from 1
};

struct RowSum {
  Float8 x, y, z, normal, depth;
  int touched = 0;
  bool moved = false;
};

// One block of eight elements. With S the face and the target R going evenly from R0 to R1 during
// the step, the press l = S - R follows
//   all through:      l1 = (l0 + v tau) a - v tau         (a Maxwell element under a ramp)
//   arrives, leaves:  the same for the share of the step in which the tool touched.
// A ray that the sphere misses at one end of the step counts as just touched there.
template <WallSide side>
void press_block(const RowStep& row, Mask8 live, const float* ray_cos, const float* ray_sin,
                 float* face, float* behind, RowSum& sum) {
  const Float8 zero(0.0f);
  const Float8 snap(kSnap);
  const Float8 c = Float8::load(ray_cos);
  const Float8 s = Float8::load(ray_sin);
  const Float8 radius = Float8::load(face);
  const Meeting start = meet<side>(row.from, c, s, row.limit);
  const Meeting end = meet<side>(row.to, c, s, row.limit);
  const Float8 r0 = select(start.hit, start.target, radius);
  const Float8 r1 = select(end.hit, end.target, radius);
  const Float8 l0 = press_of<side>(radius, r0);
  const Float8 gap = press_of<side>(radius, r1);  // l at the end, had the clay not given way
  if (!any(live & ((l0 > snap) | (gap > snap)))) return;

  const Float8 ramp = (l0 - gap) * row.rate;  // v tau
  const Float8 l_full = (l0 + ramp) * row.decay - ramp;
  const Mask8 arrives = l0 < zero;
  const Mask8 leaves = ~arrives & (l_full < zero);
  const Mask8 touch = live & select_mask(arrives, gap > snap, (l0 > snap) | (l_full > snap));

  // Share of the step in touch, where it is not the whole. A tool that leaves is let go after
  // tau ln(1 + x), x = l0 / (v tau); ln(1 + x) is nearly x (6 + x) / (6 + 4 x).
  const Float8 part = select(arrives, gap, Float8(row.rate) * l0 * (Float8(6.0f) * ramp + l0));
  const Float8 whole = select(arrives, gap - l0, ramp * (Float8(6.0f) * ramp + Float8(4.0f) * l0));
  const Float8 share = smaller(part / larger(whole, 1e-30f), 1.0f);
  // 1 - e^(-share dt / tau), exact at no, half and the whole of the step.
  const Float8 settled = share * (Float8(row.gone) + (Float8(1.0f) - share) * row.bow);
  const Float8 l_arrived = zero - ramp * settled;
  const Float8 l_end = select(arrives, l_arrived, l_full);
  const Float8 l1 = select(l_end > snap, l_end, zero);
  const Float8 l_mean =
      select(arrives, Float8(0.5f) * l1 * share,
             select(leaves, Float8(0.5f) * l0 * share, (l0 + ramp) * row.mean - ramp));

  // The face follows the tool, never springs back, and carries the other face along at wall_min.
  const Float8 followed = select(leaves, r0 + (r1 - r0) * share, face_at<side>(r1, l1));
  const Mask8 moves = touch & (press_of<side>(radius, followed) > zero);
  const Float8 now = select(moves, followed, radius);
  now.store(face);
  const Float8 back = Float8::load(behind);
  const Float8 carried = face_at<side>(now, Float8(0.0f) - row.wall_min);
  select(moves & (press_of<side>(back, carried) > zero), carried, back).store(behind);

  // Reaction along the sphere's own normal H - E. Where the target was clipped E is not on the
  // sphere, and the part that would draw the tool in is left out.
  const Float8 along = select(end.hit, end.along - end.target, start.along - start.target);
  const Float8 radial = side == WallSide::outside ? larger(along, zero) : smaller(along, zero);
  const Float8 off = select(end.hit, end.off, start.off);
  const Float8 dy = select(end.hit, row.to.dy, row.from.dy);
  const Float8 length = sqrt(larger(radial * radial + off * off + dy * dy, 1e-20f));
  const Float8 press = select(touch, l_mean * radius, zero);  // times k_A dtheta dh, in the row
  const Float8 unit = press / length;
  sum.x = sum.x + unit * (radial * c - off * s);
  sum.z = sum.z + unit * (radial * s + off * c);
  sum.y = sum.y + unit * dy;
  sum.normal = sum.normal + press;
  sum.depth = larger(sum.depth, select(touch, larger(l0, l1), zero));
  sum.touched += count(touch);
  sum.moved = sum.moved || any(moves);
}

// Rows that a tool can press. Inside, the solid floor rows are a stop instead (stops.h).
template <WallSide side>
int first_pressed_row(const Clay& clay, const Window& window) {
  return side == WallSide::inside ? std::max(window.first_row(), clay.floor_rows())
                                  : window.first_row();
}

template <WallSide side>
Press press_side(Clay& clay, const SphereStep& step, const Yielding& yielding) {
  const ClayDef& def = clay.def();
  const double rate = yielding.relaxation_time / step.seconds;
  const double gone = -portable::expm1(-1.0 / rate);
  const double gone_in_half = -portable::expm1(-0.5 / rate);
  const double sector = 2.0 * portable::kPi / def.sectors;
  const Window window(clay, step.from, step.to, step.radius);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();

  Press out;
  for (int j = first_pressed_row<side>(clay, window); j < window.end_row(); ++j) {
    const double height = clay.row_height(j);
    const RowStep row{Section(step.from, step.radius, height),
                      Section(step.to, step.radius, height),
                      limit_of<side>(def),
                      j < clay.floor_rows() ? -1e9f : static_cast<float>(def.wall_min),
                      static_cast<float>(1.0 - gone),
                      static_cast<float>(gone),
                      static_cast<float>(4.0 * gone_in_half - 2.0 * gone),
                      static_cast<float>(rate),
                      static_cast<float>(rate * gone)};
    float* face = side == WallSide::outside ? clay.outer_mut(j).data() : clay.inner_mut(j).data();
    float* behind = side == WallSide::outside ? clay.inner_mut(j).data() : clay.outer_mut(j).data();

    RowSum sum;
    BlockRange ranges[2];
    const double section = std::max(row.from.radius, row.to.radius);
    const int used = window.blocks(section, ranges);
    for (int n = 0; n < used; ++n) {
      for (int i = ranges[n].begin * kLanes; i < ranges[n].end * kLanes; i += kLanes)
        press_block<side>(row, lanes_below(def.sectors - i), ray_cos + i, ray_sin + i, face + i,
                          behind + i, sum);
      out.visited += (ranges[n].end - ranges[n].begin) * kLanes;
    }
    if (sum.touched == 0) continue;
    const double area = yielding.stiffness * sector * clay.row_thickness(j);
    out.touched += sum.touched;
    out.force += area * Vec3{double{onggi::sum(sum.x)}, double{onggi::sum(sum.y)},
                             double{onggi::sum(sum.z)}};
    out.normal += area * double{onggi::sum(sum.normal)};
    out.depth = std::max(out.depth, double{largest(sum.depth)});
    if (sum.moved) clay.mark_dirty(j);
  }
  return out;
}

template <WallSide side>
double depth_side(const Clay& clay, Vec3 at, double radius, std::int64_t* visited) {
  const Window window(clay, at, at, radius);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();
  const float limit = limit_of<side>(clay.def());
  Float8 deepest;
  for (int j = first_pressed_row<side>(clay, window); j < window.end_row(); ++j) {
    const Section section(at, radius, clay.row_height(j));
    const float* face = side == WallSide::outside ? clay.outer(j).data() : clay.inner(j).data();
    BlockRange ranges[2];
    const int used = window.blocks(section.radius, ranges);
    for (int n = 0; n < used; ++n) {
      for (int i = ranges[n].begin * kLanes; i < ranges[n].end * kLanes; i += kLanes) {
        const Meeting m =
            meet<side>(section, Float8::load(ray_cos + i), Float8::load(ray_sin + i), limit);
        const Float8 depth = press_of<side>(Float8::load(face + i), m.target);
        const Mask8 live = m.hit & lanes_below(clay.sectors() - i);
        deepest = larger(deepest, select(live, depth, 0.0f));
      }
      if (visited != nullptr) *visited += (ranges[n].end - ranges[n].begin) * kLanes;
    }
  }
  const float most = largest(deepest);
  return most > kSnap ? double{most} : 0.0;
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
