// How any tool presses the rows it reaches, eight elements at a time. A tool's file in
// engine/contact/tools gives a class that tells how it meets one row:
//
//   struct Shape {
//     Shape(const ToolPlace&, const ToolSize&);
//     double reach() const;                   // of the ball round `at` that holds the tool, m
//     Row row(double height, const RowReach&) const;  // its closed-form section with that plane
//     void collect(const RowSum&, float area, Reaction&) const;  // rows of one thickness together
//   };
//   struct Row {
//     template <WallSide side, bool careful> Meeting meet(Float8 cos, Float8 sin, Float8 face)
//     const; void react(RowSum&, Float8 weight, const Meeting&, Float8 cos, Float8 sin) const;
//   };
//
// A row may have a Meeting of its own with more in it, for its react(). A tool that is no ball is a
// Shape made by solid_rows.h, which plans its rows itself.
//
// Compiled once for each kind of vector: include it only from such a file.
#if defined(ONGGI_CONTACT_PRESS_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_CONTACT_PRESS_ROWS_H
#undef ONGGI_CONTACT_PRESS_ROWS_H
#else
#define ONGGI_CONTACT_PRESS_ROWS_H
#endif

#include <algorithm>
#include <type_traits>

#include "engine/contact/plan_rows.h"
#include "engine/contact/press_block.h"
#include "engine/contact/tool.h"
#include "engine/math/lanes.h"
#include "engine/math/portable.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {

// Rows that a tool can press. Inside, the solid floor rows are a stop instead (stops.h).
template <WallSide side, class AnyWindow>
int first_pressed_row(const Clay& clay, const AnyWindow& window) {
  return side == WallSide::inside ? std::max(window.first_row, clay.floor_rows())
                                  : window.first_row;
}

template <WallSide side>
float limit_of(const ClayDef& def) {
  return static_cast<float>(side == WallSide::outside ? def.radius_min + def.wall_min
                                                      : def.radius_max - def.wall_min);
}

template <WallSide side>
bool needs_care(float limit, const Window& window, const RowReach& reach) {
  const double section = double{reach.section};
  return reach.edged || (side == WallSide::outside ? window.distance - section < double{limit}
                                                   : window.distance + section > double{limit});
}

// How the rows of a Shape are planned: a ball's all by one window, or by the Shape itself.
template <class Shape>
concept PlansItself = requires {
  typename Shape::Reach;
};

template <class Shape>
struct Planning {
  using Reach = RowReach;
  static Window window(const Clay& clay, const Shape& shape, Vec3 at) {
    return {clay, at, shape.reach()};
  }
  template <WallSide side>
  HWY_INLINE static void plan_some(const Clay& clay, const Shape&, const Window& window, int first,
                                   int count, Reach* rows) {
    plan<side>(clay, window, first, count, rows);
  }
  template <WallSide side>
  static bool careful(float limit, const Window& window, const Reach& reach) {
    return needs_care<side>(limit, window, reach);
  }
};

template <PlansItself Shape>
struct Planning<Shape> {
  using Reach = typename Shape::Reach;
  static auto window(const Clay& clay, const Shape& shape, Vec3 at) {
    return shape.window(clay, at);
  }
  template <WallSide side, class AnyWindow>
  static void plan_some(const Clay& clay, const Shape& shape, const AnyWindow& window, int first,
                        int count, Reach* rows) {
    shape.template plan<side>(clay, window, first, count, rows);
  }
  template <WallSide side, class AnyWindow>
  static std::true_type careful(float, const AnyWindow&, const Reach&) {
    return {};
  }
};

// Pressing leaves a row's extent wider than the row, so that more is looked at than need be: whose
// turn it is of the window's rows is measured anew.
inline void measure_extent(Clay& clay, int j) {
  const float* outer = clay.outer(j).data();
  const float* inner = clay.inner(j).data();
  Float8 most = all(0.0f);
  Float8 least = all(1e9f);
  for (int i = 0; i < clay.stride(); i += kLanes) {
    most = larger(load(outer + i), most);
    least = smaller(load(inner + i), least);
  }
  clay.set_extent(j, largest(most), smallest(least));
}

// What is torn is not pressed. Called, not inlined: the kernel of a clay without areas is to the
// instruction as it was, and the other one's registers are disturbed least.
template <class Reach>
HWY_NOINLINE void leave_torn(const RowAreas& areas, int first, int count, Reach* rows) {
  if (!areas.any_torn()) return;
  for (int k = 0; k < count; ++k)
    if (areas.torn(first + k)) rows[k].used = 0;
}

template <WallSide side, class Shape, class Sum>
Press press_rows_into(Clay& clay, const ToolPlace& place, const ToolSize& size, double seconds,
                      const Yielding& yielding) {
  constexpr bool kept = std::is_same_v<Sum, PressedAndKept>;
  const ClayDef& def = clay.def();
  const double rate = yielding.relaxation_time / seconds;
  const double gone = -portable::expm1(-1.0 / rate);
  StepFigures figures{limit_of<side>(def), static_cast<float>(def.wall_min),
                      static_cast<float>(gone)};
  if constexpr (kept) {
    figures.along = static_cast<float>(yielding.along);
    figures.farthest =
        static_cast<float>(side == WallSide::outside ? def.radius_min : def.radius_max);
  }
  // The mean press over the step is (tau/dt)(1 - e^(-dt/tau)) of the first.
  const double weight = yielding.stiffness * 2.0 * portable::kPi / def.sectors * rate * gone;
  const Shape shape(place, size);
  using Plan = Planning<Shape>;
  const auto window = Plan::window(clay, shape, place.at);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();

  Press out;
  const Float8 zero = all(0.0f);
  Reaction reaction{zero, zero, zero, zero};
  Sum pressed{};
  pressed.sum = {zero, zero, zero, zero};
  pressed.depth = zero;
  double thickness = 0.0;  // of the rows in pressed.sum
  typename Plan::Reach planned[kPlannedRows];
  const int end_row = window.end_row;
  const int first_row = first_pressed_row<side>(clay, window);
  for (int first = first_row; first < end_row; first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    Plan::template plan_some<side>(clay, shape, window, first, count, planned);
    if constexpr (kept) leave_torn(*clay.areas(), first, count, planned);
    std::uint64_t changed = 0;
    for (int k = 0; k < count; ++k) {
      const auto& reach = planned[k];
      if (reach.used == 0) continue;
      const int j = first + k;
      const auto row = shape.row(clay.row_height(j), reach);
      if (clay.row_thickness(j) != thickness) {
        shape.collect(pressed.sum, static_cast<float>(weight * thickness), reaction);
        pressed.sum = {zero, zero, zero, zero};
        thickness = clay.row_thickness(j);
      }
      float* outer = clay.pressable_outer(j).data();
      float* inner = clay.pressable_inner(j).data();
      float* face = side == WallSide::outside ? outer : inner;
      float* behind = side == WallSide::outside ? inner : outer;
      const Float8 start =
          all(side == WallSide::outside ? clay.inner_least(j) : clay.outer_most(j));
      pressed.behind = start;
      pressed.touched = 0;
      [[maybe_unused]] Shifts* shifts = nullptr;
      if constexpr (kept) {
        // What is cut off drags nothing along, and never comes back.
        shifts = yielding.cut ? nullptr : clay.shifts(side == WallSide::inside);
        pressed.shift = shifts != nullptr ? shifts->row(j) : clay.areas()->spare_row();
        pressed.lost = zero;
      }
      if (j < clay.floor_rows())
        press_ranges<side, true, false>(row, figures, ray_cos, ray_sin, face, behind, reach,
                                        pressed);
      else if (Plan::template careful<side>(figures.limit, window, reach))
        press_ranges<side, true, true>(row, figures, ray_cos, ray_sin, face, behind, reach,
                                       pressed);
      else
        press_ranges<side, false, true>(row, figures, ray_cos, ray_sin, face, behind, reach,
                                        pressed);
      out.visited += reach.elements();
      if (pressed.touched == 0) continue;
      out.touched += pressed.touched;
      if constexpr (side == WallSide::outside) {
        if (!none(pressed.behind < start)) clay.widen_extent(j, 0.0f, smallest(pressed.behind));
      } else {
        if (!none(pressed.behind > start)) clay.widen_extent(j, largest(pressed.behind), 1e9f);
      }
      if constexpr (kept) {
        clay.areas()->lose(j, portable::kPi / def.sectors * double{sum(pressed.lost)},
                           yielding.cut);
        if (shifts != nullptr)
          for (int n = 0; n < reach.used; ++n)
            shifts->mark(j, {reach.ranges[n].begin, reach.ranges[n].end});
      }
      changed |= std::uint64_t{1} << k;
    }
    clay.mark_dirty(first, changed);
  }
  shape.collect(pressed.sum, static_cast<float>(weight * thickness), reaction);
  if (out.touched > 0) measure_extent(clay, first_row + clay.next_measured(end_row - first_row));
  out.force = {double{sum(reaction.x)}, double{sum(reaction.y)}, double{sum(reaction.z)}};
  out.normal = double{sum(reaction.normal)};
  // Elements in part covered reach a little beyond the tool's surface, and so does their normal.
  const double strength = length(out.force);
  if (strength > out.normal) out.force = (out.normal / strength) * out.force;
  out.depth = double{largest(pressed.depth)};
  return out;
}

template <WallSide side, class Shape>
Press press_rows(Clay& clay, const ToolPlace& place, const ToolSize& size, double seconds,
                 const Yielding& yielding) {
  return clay.areas() == nullptr
             ? press_rows_into<side, Shape, Pressed>(clay, place, size, seconds, yielding)
             : press_rows_into<side, Shape, PressedAndKept>(clay, place, size, seconds, yielding);
}

template <WallSide side, class Shape>
double depth_in_rows(const Clay& clay, const ToolPlace& place, const ToolSize& size,
                     std::int64_t& visited) {
  const StepFigures figures{limit_of<side>(clay.def()), 0.0f, 0.0f};
  const Shape shape(place, size);
  using Plan = Planning<Shape>;
  const auto window = Plan::window(clay, shape, place.at);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();
  const Float8 snap = all(kSnap);
  Float8 deepest = all(0.0f);
  typename Plan::Reach planned[kPlannedRows];
  const int end_row = window.end_row;
  const int first_row = first_pressed_row<side>(clay, window);
  for (int first = first_row; first < end_row; first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    Plan::template plan_some<side>(clay, shape, window, first, count, planned);
    for (int k = 0; k < count; ++k) {
      const auto& reach = planned[k];
      const int j = first + k;
      if (reach.used == 0) continue;
      const auto row = shape.row(clay.row_height(j), reach);
      const float* face = side == WallSide::outside ? clay.outer(j).data() : clay.inner(j).data();
      for (int n = 0; n < reach.used; ++n) {
        for (int i = reach.ranges[n].begin * kLanes; i < reach.ranges[n].end * kLanes;
             i += kLanes) {
          const Float8 radius = load(face + i);
          const auto m =
              row.template meet<side, true>(load(ray_cos + i), load(ray_sin + i), radius);
          const Float8 press = press_of<side>(radius, target_of<side, true>(m.end, figures));
          deepest = larger(deepest, only(m.hit & (press > snap), press));
        }
      }
      visited += reach.elements();
    }
  }
  return double{largest(deepest)};
}

}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

/// After the Shape, in its namespace: the functions that a ToolShape points to, for this vector.
#define ONGGI_PRESS_WITH(Shape)                                                             \
  Press press_tool(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size, \
                   double seconds, const Yielding& yielding) {                              \
    return side == WallSide::outside                                                        \
               ? press_rows<WallSide::outside, Shape>(clay, place, size, seconds, yielding) \
               : press_rows<WallSide::inside, Shape>(clay, place, size, seconds, yielding); \
  }                                                                                         \
  double depth_of_tool(const Clay& clay, WallSide side, const ToolPlace& place,             \
                       const ToolSize& size, std::int64_t& visited) {                       \
    return side == WallSide::outside                                                        \
               ? depth_in_rows<WallSide::outside, Shape>(clay, place, size, visited)        \
               : depth_in_rows<WallSide::inside, Shape>(clay, place, size, visited);        \
  }

/// At the file's end, once (HWY_ONCE), in namespace onggi: `press` and `depth` below choose the
/// machine's best vectors when first called.
#define ONGGI_CHOOSE_VECTORS()                                                                \
  HWY_EXPORT(press_tool);                                                                     \
  HWY_EXPORT(depth_of_tool);                                                                  \
  static Press press(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size, \
                     double seconds, const Yielding& yielding) {                              \
    return HWY_DYNAMIC_DISPATCH(press_tool)(clay, side, place, size, seconds, yielding);      \
  }                                                                                           \
  static double depth(const Clay& clay, WallSide side, const ToolPlace& place,                \
                      const ToolSize& size, std::int64_t& visited) {                          \
    return HWY_DYNAMIC_DISPATCH(depth_of_tool)(clay, side, place, size, visited);             \
  }
#endif
