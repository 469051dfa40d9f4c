#include "engine/contact/floor.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/crown.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kSnap = 2e-8;  // m: a smaller press counts as none; heights are doubles

// (1 - e^-x) / x and (1 - that) / x, also where x is nearly 0.
double mean_decay(double x) { return x > 0.0 ? -portable::expm1(-x) / x : 1.0; }
double mean_lag(double x) { return x > 1e-4 ? (1.0 - mean_decay(x)) / x : 0.5 - x / 6.0; }

// A press l on clay that yields at x = dt / tau, while the tool goes `deeper` at a constant speed.
// Exact solution of dl/dt = -l/tau + deeper/dt.
struct Given {
  double end, mean;
};
Given give_way(double l, double deeper, double x) {
  const double decay = mean_decay(x);
  return {l * (1.0 - x * decay) + deeper * decay, l * decay + deeper * mean_lag(x)};
}

// The share of the floor, from the axis to the tool's far edge, that a ball covers: the ball is
// `depth` deep and `off` from the axis. The turning wheel spreads what yields there over all of
// that floor.
double covered_share(double radius, double depth, double off) {
  const double deep = std::min(depth, radius);
  const double print = std::sqrt(deep * (2.0 * radius - deep));
  const double share = print / (print + off);
  return share * share;
}

}  // namespace

Press press_floor(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept {
  Press out;
  const double top = clay.floor_top();
  const double l0 = top - (step.from.y - step.radius);
  const double gap = top - (step.to.y - step.radius);  // l at the end if the floor did not yield
  if (clay.floor_rows() == 0 || std::max(l0, gap) <= kSnap) return out;

  // The share of the step in which the ball touches.
  const double way = gap - l0;
  const double begin = l0 < 0.0 ? -l0 / way : 0.0;
  const double end = gap < 0.0 ? -l0 / way : 1.0;
  const double share = end - begin;
  const double first = std::max(l0, 0.0);

  // The floor is firm at its thinnest. It is also firm if a tool starts deep inside it, because
  // that tool did not press its way there.
  const double lowest = std::min(clay.def().floor_min, top);
  const double off = 0.5 * (axis_distance(step.from) + axis_distance(step.to));
  const bool firm = top <= lowest || first > step.radius;
  const double rate =
      firm ? 0.0
           : covered_share(step.radius, std::max(0.5 * (first + std::max(gap, 0.0)), kSnap), off);
  const double x = rate * share * step.seconds / yielding.relaxation_time;
  const Given given = give_way(first, share * way, x);
  // The floor sinks by the tool's travel minus the press that is left.
  const double sunk = std::clamp(first + share * way - given.end, 0.0, top - lowest);
  const double mean = std::max(given.mean, 0.0);
  out.force.y = share * yielding.stiffness * contact::push_on_flat(mean, step.radius);
  out.normal = out.force.y;
  // A hand below the wheel head presses only the clay that stands on the wheel head.
  out.depth = std::min(std::max(first, gap - sunk), top);
  out.touched = 1;
  if (sunk <= 0.0) return out;

  const double level = top - sunk;
  const double reach = axis_distance(step.to);
  while (clay.floor_rows() > 0 && clay.row_height(clay.floor_rows() - 1) >= level) {
    const double dy = step.to.y - clay.row_height(clay.floor_rows() - 1);
    const double square = (step.radius - dy) * (step.radius + dy);
    const int j = clay.floor_rows() - 1;
    const bool cut = yielding.cut && clay.areas() != nullptr;
    const double whole = cut ? clay.measured_area(j) : 0.0;
    clay.open_floor_row(reach + std::sqrt(std::max(square, 0.0)));
    if (cut) clay.areas()->cut_off(j, whole - clay.measured_area(j));
    ++out.visited;
  }
  clay.lower_floor(level);
  return out;
}

}  // namespace onggi
