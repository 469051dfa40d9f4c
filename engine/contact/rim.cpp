#include "engine/contact/rim.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/clay/lip.h"
#include "engine/contact/crown.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kSnap = 2e-8;         // m: a smaller press counts as none; heights are doubles
constexpr double kThinnestRow = 0.25;  // of its first thickness: a row this compressed is firm

// Gauss-Legendre nodes and weights on -1..1: exact up to the seventh power.
constexpr std::array<double, 4> kNode{-0.861136311594053, -0.339981043584856, 0.339981043584856,
                                      0.861136311594053};
constexpr std::array<double, 4> kWeight{0.347854845137454, 0.652145154862546, 0.652145154862546,
                                        0.347854845137454};

// The sectors whose rays a ball can meet: `count` sectors from `first`, round the axis.
struct Sectors {
  int first, count;
};
Sectors sectors_under(const Clay& clay, Vec3 at, double radius) {
  const int all = clay.sectors();
  const double d = axis_distance(at);
  if (d <= radius) return {0, all};
  const double per_radian = all / (2.0 * portable::kPi);
  const double half = portable::asin(radius / d) * per_radian;
  const double middle = portable::atan2(at.z, at.x) * per_radian - 0.5;
  const int first = static_cast<int>(std::floor(middle - half));
  const int count = static_cast<int>(std::ceil(middle + half)) - first + 1;
  if (count >= all) return {0, all};
  return {(first + all) % all, count};
}

// The press on one sector of the rim, integrated over its area: m^3 per radian of the sector.
struct SectorPress {
  // What moves the clay: press times the ball's normal.
  double along = 0.0, up = 0.0;
  // What is felt: a pressure times the normal, integrated over the ball's own surface. A level area
  // A corresponds to A / n_y of that surface (crown.h). This force is the gradient of an energy.
  double felt_along = 0.0, felt_off = 0.0, felt_up = 0.0;
  double felt = 0.0;     // magnitude, without direction
  double deepest = 0.0;  // m
};

// Upright rays pass the ball's centre at `off`. The centre is `along` from the axis and `above` the
// crown. `crown` is the crown's height over the wheel head.
SectorPress press_sector(double inner, double outer, double along, double off, double above,
                         double crown, double radius) {
  SectorPress sum;
  const double square = (radius - off) * (radius + off);
  // Only rays that meet the ball below the crown.
  const double reach = above > 0.0 ? square - above * above : square;
  if (reach <= 0.0) return sum;
  const double half = std::sqrt(reach);
  const double begin = std::max(inner, along - half);
  const double end = std::min(outer, along + half);
  if (end <= begin) return sum;
  const auto depth_at = [&](double rho) {
    const double rise = std::sqrt(std::max(square - (along - rho) * (along - rho), 0.0));
    const double drop = lip_drop(inner, outer, rho);
    // A fully sunk ball covers no more of the ray than its own chord. A ball that reaches below the
    // wheel head covers no more than the clay there.
    return std::min({rise - above - drop, 2.0 * rise, crown});
  };
  const double edge = std::min(0.5 * (outer - inner), kLipRadius);
  const double crown_begin = inner > 0.0 ? inner + edge : 0.0;
  sum.deepest = std::max(depth_at(std::clamp(along, crown_begin, outer - edge)), 0.0);
  // Integrate the flat top and the round edges separately. The press has a bend at a lip's edge,
  // and one set of nodes across it did not give the gradient of an energy.
  const double bounds[] = {begin, std::clamp(crown_begin, begin, end),
                           std::clamp(outer - edge, begin, end), end};
  for (std::size_t part = 0; part < 3; ++part) {
    const double half_way = 0.5 * (bounds[part + 1] - bounds[part]);
    if (half_way <= 0.0) continue;
    const double middle = 0.5 * (bounds[part + 1] + bounds[part]);
    for (std::size_t n = 0; n < kNode.size(); ++n) {
      const double rho = middle + half_way * kNode[n];
      const double press = depth_at(rho);
      if (press <= 0.0) continue;
      const double area = half_way * kWeight[n] * rho;
      const double x = along - rho;
      const double rise = std::sqrt(std::max(square - x * x, 0.0));
      sum.along += press * area * x / radius;
      sum.up += press * area * rise / radius;
      if (rise > 0.0) {  // a press is at most twice the rise, so these stay finite
        const double borne = contact::pressure_at(press, radius) * area / rise;
        sum.felt_along += borne * x;
        sum.felt_off += borne * off;
        sum.felt_up += borne * rise;
        sum.felt += borne * radius;
      }
      sum.deepest = std::max(sum.deepest, press);
    }
  }
  return sum;
}

double area_of(const Clay& clay, int j) {
  return clay.areas()->known(j) ? clay.areas()->of(j) : clay.measured_area(j);
}

// 1 at the rim, 0 with zero slope at `reach` below it.
double fall_off(double below, double reach) {
  const double t = std::clamp(1.0 - below / reach, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Compresses the top rows by `sink` in all, or as far as they can go; metres. Each row gives up a
// share of its spare thickness. `reach` is measured in spare thickness, so the press goes deeper
// once the top rows are firm. `cut`: the removed clay is gone.
double lower_rim(Clay& clay, double sink, double reach, bool cut) {
  const double thinnest = kThinnestRow * clay.first_thickness();
  const auto spare = [&](int j) { return std::max(clay.row_thickness(j) - thinnest, 0.0); };
  // The lowest row above the floor carries the floor's top.
  const bool solid = clay.floor_rows() == clay.rows();
  const int lowest = solid ? clay.first_row_above(clay.def().floor_min) : clay.floor_rows() + 1;
  double above = 0.0;
  double room = 0.0;
  int end = clay.rows();
  while (end > lowest && above < reach) {
    const double free = spare(end - 1);
    room += free * (1.0 - above / reach);
    above += free;
    --end;
  }
  if (!(room > 0.0)) return 0.0;
  const double part = std::min(sink / room, 0.5);
  above = 0.0;
  for (int j = clay.rows() - 1; j >= end; --j) {
    const double free = spare(j);
    const double lower = part * free * (1.0 - above / reach);
    const double left = clay.row_thickness(j) - lower;
    clay.set_row_thickness(j, left);
    if (cut && clay.areas() != nullptr) clay.areas()->cut_off(j, area_of(clay, j) * lower / left);
    above += free;
  }
  clay.restack(end);
  return part * room;
}

// How far a face was pushed.
struct Extent {
  std::array<float, 8> outer, inner;  // eight at a time: farthest outer, nearest inner
  std::array<float, 8> lost;          // from the squares of radii
};

// Pushes both faces of `count` neighbours by their share of `push`. Compilers turn these loops of
// eight into vector code; the bits are the same as one at a time.
void shift(float* outer, float* inner, const float* push, int count, float share,
           const ClayDef& def, Extent& extent) {
  const auto wall_min = static_cast<float>(def.wall_min);
  const auto nearest = static_cast<float>(def.radius_min);
  const auto farthest = static_cast<float>(def.radius_max);
  const auto one = [&](int n, std::size_t k) {
    const float room_out = farthest - outer[n];
    const float room_in = nearest - inner[n];
    const float wanted = share * push[n];
    const float most = room_out > 0.0f ? room_out : 0.0f;
    const float least = room_in < 0.0f ? room_in : 0.0f;
    const float below = wanted < most ? wanted : most;
    const float by = below > least ? below : least;
    const float out = outer[n] + by;
    const float in = inner[n] + by < out - wall_min ? inner[n] + by : out - wall_min;
    const float now = by == 0.0f ? inner[n] : in;
    extent.lost[k] += (inner[n] - now) * -(inner[n] + now) - by * (outer[n] + out);
    inner[n] = now;
    outer[n] = out;
    extent.outer[k] = out > extent.outer[k] ? out : extent.outer[k];
    extent.inner[k] = inner[n] < extent.inner[k] ? inner[n] : extent.inner[k];
  };
  int n = 0;
  for (; n + 8 <= count; n += 8)
    for (int k = 0; k < 8; ++k) one(n + k, static_cast<std::size_t>(k));
  for (; n < count; ++n) one(n, 0);
}

// Pushes the top rows of the sectors under the ball outwards (positive) or inwards, both faces.
void flare(Clay& clay, Sectors under, const float* push, double reach) {
  const double rim = clay.rim_height();
  const int before_end = std::min(under.count, clay.sectors() - under.first);
  for (int j = clay.rows() - 1; j >= clay.floor_rows(); --j) {
    const double below = rim - clay.row_height(j);
    if (below >= reach) return;
    const auto share = static_cast<float>(fall_off(below, reach));
    float* outer = clay.pressable_outer(j).data();
    float* inner = clay.pressable_inner(j).data();
    Extent extent;
    extent.outer.fill(0.0f);
    extent.inner.fill(1e9f);
    extent.lost.fill(0.0f);
    shift(outer + under.first, inner + under.first, push, before_end, share, clay.def(), extent);
    shift(outer, inner, push + before_end, under.count - before_end, share, clay.def(), extent);
    clay.widen_extent(j, *std::ranges::max_element(extent.outer),
                      *std::ranges::min_element(extent.inner));
    if (RowAreas* areas = clay.areas()) {
      double lost = 0.0;
      for (const float part : extent.lost) lost += double{part};
      areas->lose(j, portable::kPi / clay.sectors() * lost);
    }
    clay.mark_dirty(j);
  }
}

}  // namespace

double rim_reach(double radius, double thickness, double tool_radius) noexcept {
  return std::clamp(2.0 * std::sqrt(radius * thickness), tool_radius, 4.0 * tool_radius);
}

namespace {

Press press_once(Clay& clay, const BallStep& step, const Yielding& yielding) {
  Press out;
  const Vec3 at = 0.5 * (step.from + step.to);
  const double above = at.y - clay.rim_height();
  if (above >= step.radius) return out;
  const Sectors under = sectors_under(clay, at, step.radius);
  const int top = clay.rows() - 1;
  const double sector = 2.0 * portable::kPi / clay.sectors();
  const double gone = -portable::expm1(-step.seconds / yielding.relaxation_time);
  out.visited = under.count;

  // The press on every sector under the ball, and how far it pushes the sector aside.
  std::array<float, clay::kMostSectors> push;  // not cleared: only the first `under.count` are used
  SectorPress sum;
  Vec3 force;
  double area = 0.0;
  double girth = 0.0;
  double most = 0.0;
  for (int n = 0; n < under.count; ++n) {
    const auto i = static_cast<std::size_t>((under.first + n) % clay.sectors());
    const double c = double{clay.ray_cos()[i]};
    const double s = double{clay.ray_sin()[i]};
    const double outer = double{clay.outer(top)[i]};
    const double inner = double{clay.inner(top)[i]};
    const double own_area = 0.5 * (outer - inner) * (outer + inner);
    const SectorPress press = press_sector(inner, outer, at.x * c + at.z * s, at.z * c - at.x * s,
                                           above, clay.rim_height(), step.radius);
    area += own_area;
    girth += 0.5 * (outer + inner);
    const double aside = -press.along / own_area;
    push[static_cast<std::size_t>(n)] =
        std::fabs(aside) > kSnap ? static_cast<float>(aside * gone) : 0.0f;
    most = std::max(most, std::fabs(aside));
    if (press.deepest <= kSnap) continue;
    force += Vec3{press.felt_along * c - press.felt_off * s, press.felt_up,
                  press.felt_along * s + press.felt_off * c};
    sum.up += press.up;
    sum.felt += press.felt;
    sum.deepest = std::max(sum.deepest, press.deepest);
    ++out.touched;
  }
  if (out.touched == 0) return out;

  // The whole ring sinks together, by the share of its area that yields.
  const double ring = area / under.count * clay.sectors();
  const double thickness = area / girth;
  const double reach = rim_reach(girth / under.count, thickness, step.radius);
  const double rate = sum.up / (ring * sum.deepest);
  const double wanted =
      -sum.deepest * portable::expm1(-rate * step.seconds / yielding.relaxation_time);
  const double sunk = lower_rim(clay, wanted, reach, yielding.cut);
  if (most > kSnap) flare(clay, under, push.data(), reach);

  // Mean over the step.
  const double felt = yielding.stiffness * sector * (1.0 - 0.5 * sunk / sum.deepest);
  out.force = felt * force;
  out.normal = felt * sum.felt;
  out.depth = sum.deepest;
  return out;
}

}  // namespace

Press press_rim(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept {
  // The sideways push and the downward press depend on each other. So no part is long enough for
  // the clay to yield by more than an eighth.
  const int parts = static_cast<int>(
      std::clamp(std::ceil(8.0 * step.seconds / yielding.relaxation_time), 1.0, 8.0));
  const Vec3 way = step.to - step.from;
  Press out;
  for (int n = 0; n < parts; ++n) {
    const BallStep part{step.from + (1.0 * n / parts) * way, step.from + (n + 1.0) / parts * way,
                        step.radius, step.seconds / parts};
    const Press press = press_once(clay, part, yielding);
    out.force += 1.0 / parts * press.force;
    out.normal += press.normal / parts;
    out.depth = std::max(out.depth, press.depth);
    out.visited += press.visited;
    out.touched += press.touched;
  }
  return out;
}

}  // namespace onggi
