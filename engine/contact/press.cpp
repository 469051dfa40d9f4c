#include "engine/contact/press.h"

#include <algorithm>
#include <bit>

#include "engine/contact/ball_window.h"
#include "engine/contact/kernels.h"
#include "engine/contact/solid_window.h"
#include "engine/math/portable.h"

namespace onggi::body {
namespace {

using contact::BodyFigures;
using contact::BodyKernel;
using contact::BodyRow;
using contact::kPlannedRows;

// Finds the rows that a body may touch, and the blocks of each.
template <class Body>
class Plan {
 public:
  Plan(const Clay& clay, WallSide side, const Body& body, Vec3 at)
      : clay_(clay),
        side_(side),
        body_(body),
        sector_(static_cast<float>(2.0 * portable::kPi / clay.sectors())),
        window_(clay, body.heights(), body.hull(), body.approach(), at) {
    if constexpr (kMayStand) {
      stands_ = body.upright();
      if (!stands_) return;
      const double y = 0.5 * (window_.heights.low + window_.heights.high);
      alike_ = contact::AlikeRows(body.outline(y));
      section_ = body.section(y);
    }
  }

  int first_row() const { return window_.first_row; }
  int end_row() const { return window_.end_row; }
  BodyFigures<Body> figures() const { return {}; }
  void find_lean() const {}
  std::uint32_t careful() const { return ~0u; }

  // Bit k: row first + k has something to touch.
  std::uint32_t find(int first, int count) {
    std::uint32_t reached = 0;
    for (int n = 0; n < count; n += kFew) {
      const int few = std::min(count - n, kFew);
      bool covered[kFew];
      for (int k = 0; k < few; ++k) {
        contact::SolidReach& row = rows_[n + k];
        covered[k] = contact::cover_row(clay_, window_, side_, first + n + k, row);
        if (covered[k] && !stands_) row.outline = body_.outline(row.y);
      }
      if (stands_)
        contact::plan_alike_rows(clay_, window_, side_, alike_, first + n, few, covered, rows_ + n);
      else
        contact::plan_rows(clay_, window_, side_, first + n, few, covered, rows_ + n);
      for (int k = 0; k < few; ++k) reached |= std::uint32_t{rows_[n + k].used > 0} << (n + k);
    }
    return reached;
  }
  void fill(int k, BodyRow<Body>& row) const {
    const contact::SolidReach& found = rows_[k];
    if constexpr (kMayStand)
      row.section = stands_ ? body_.section_like(section_, found.y) : body_.section(found.y);
    else
      row.section = body_.section(found.y);
    row.outline = stands_ ? &alike_.outline : &found.outline;
    row.sector = sector_;
    row.share = found.share;
    row.used = found.used;
    row.ranges[0] = found.ranges[0];
    row.ranges[1] = found.ranges[1];
  }

 private:
  static constexpr int kFew = 8;
  // An upright body has the same cut in all rows: a flat rib, as potters hold it.
  static constexpr bool kMayStand = requires(const Body& b) { b.upright(); };
  const Clay& clay_;
  WallSide side_;
  const Body& body_;
  float sector_;
  contact::SolidWindow window_;
  bool stands_ = false;
  contact::AlikeRows alike_;
  typename Body::Section section_;
  contact::SolidReach rows_[kPlannedRows];
};

// A block of elements that begins beside a ball may end behind the axis, where rays meet the ball
// from the wrong end. It happens on coarse grids with balls that look wide from the axis. `sine`:
// of half that angle. Uses cos x >= 1 - x^2 / 2.
bool reaches_far_half(int sectors, double sine) {
  const double half_block = portable::kPi * (Displacements::kBlock + 1) / sectors;
  return sine >= 1.0 - 0.5 * half_block * half_block;
}

template <>
class Plan<Ball> {
 public:
  Plan(const Clay& clay, WallSide side, const Ball& ball, Vec3)
      : clay_(clay),
        shape_(clay),
        side_(side),
        window_(clay, ball.middle, ball.radius),
        far_half_(side == WallSide::outside &&
                  reaches_far_half(clay.sectors(), ball.radius / window_.distance)),
        figures_{static_cast<float>(ball.middle.x),
                 static_cast<float>(ball.middle.z),
                 static_cast<float>(1.0 / ball.radius),
                 static_cast<float>(ball.middle.x / ball.radius),
                 static_cast<float>(ball.middle.z / ball.radius),
                 1.0f,
                 0.0f,
                 static_cast<float>(contact::kLeastFacing * ball.radius),
                 &rows_} {}

  int first_row() const { return window_.first_row; }
  int end_row() const { return window_.end_row; }
  const BodyFigures<Ball>& figures() const { return figures_; }

  std::uint32_t careful() const { return far_half_ ? ~0u : rows_.careful; }

  std::uint32_t find(int first, int count) {
    plan_rows(clay_, window_, side_, first, count, rows_);
    return rows_.reached;
  }
  // How the face leans beside the ball, for what is felt of it.
  void find_lean() {
    if (lean_known_) return;
    lean_known_ = true;
    const double slope = slope_beside(clay_, window_, side_);
    const double squareness = 1.0 / (1.0 + slope * slope);
    const double slant = squareness * slope * window_.radius;
    figures_.squareness = static_cast<float>(squareness);
    figures_.slant = static_cast<float>(side_ == WallSide::outside ? slant : -slant);
  }
  void fill(int k, BodyRow<Ball>& row) const { row.used = blocks_of(shape_, rows_, k, row.ranges); }

 private:
  const Clay& clay_;
  contact::RowShape shape_;
  WallSide side_;
  contact::BallWindow window_;
  bool far_half_;
  bool lean_known_ = false;
  BodyFigures<Ball> figures_;
  contact::BallWindows rows_;
};

const BodyKernel<Ball>& kernel_of(const contact::Kernels& all, const Ball&) { return *all.ball; }
const BodyKernel<Capsule>& kernel_of(const contact::Kernels& all, const Capsule&) {
  return *all.capsule;
}
const BodyKernel<Box>& kernel_of(const contact::Kernels& all, const Box&) { return *all.box; }
const BodyKernel<Cylinder>& kernel_of(const contact::Kernels& all, const Cylinder&) {
  return *all.cylinder;
}

// Inside, the solid floor rows act as a stop instead (stops.h).
int first_pressed_row(const Clay& clay, WallSide side, int first) {
  return side == WallSide::inside ? std::max(first, clay.floor_rows()) : first;
}

contact::StepFigures figures_of(const Clay& clay, WallSide side) {
  const ClayDef& def = clay.def();
  contact::StepFigures step{};
  step.ray_cos = clay.ray_cos().data();
  step.ray_sin = clay.ray_sin().data();
  step.limit = static_cast<float>(side == WallSide::outside ? def.radius_min + def.wall_min
                                                            : def.radius_max - def.wall_min);
  step.wall_min = static_cast<float>(def.wall_min);
  step.farthest = static_cast<float>(side == WallSide::outside ? def.radius_min : def.radius_max);
  return step;
}

// Bits k >= from.
std::uint32_t rows_from(int from) {
  return from <= 0 ? ~std::uint32_t{0} : from >= kPlannedRows ? 0 : ~std::uint32_t{0} << from;
}

// The rows planned together, starting at `first`.
contact::RowPlaces places_of(Clay& clay, WallSide side, int first, double weight,
                             std::uint32_t careful) {
  const bool outside = side == WallSide::outside;
  const auto n = static_cast<std::size_t>(first);
  float* const outer = clay.stored_outer(0);
  float* const inner = clay.stored_inner(0);
  return {outside ? outer : inner,
          outside ? inner : outer,
          clay.stride(),
          clay.sectors(),
          clay.stored().data() + n,
          (outside ? clay.inner_least() : clay.outer_most()).data() + n,
          clay.row_thicknesses().data() + n,
          weight,
          clay.floor_rows() - first,
          careful};
}

// A group of rows that a body presses in one step. Prepares them for the kernel and writes the
// results back to the clay.
template <class Body>
class Pressing {
 public:
  Pressing(Clay& clay, WallSide side, const Yielding& yielding)
      : clay_(clay), side_(side), cut_(yielding.cut) {
    if (clay.areas() != nullptr && !cut_)
      displacements_ =
          clay.displacements(side == WallSide::inside);  // clay that is cut off drags nothing along
  }

  // Prepares the rows of `reached`, counted from row `first`. Returns how many rows have work.
  int prepare(const Plan<Body>& plan, int first, std::uint32_t reached) {
    RowAreas* const areas = clay_.areas();
    int used = 0;
    for (; reached != 0; reached &= reached - 1) {
      BodyRow<Body>& row = rows_[used];
      row.k = std::countr_zero(reached);
      if (areas != nullptr) {
        const int j = first + row.k;
        if (areas->any_torn() && areas->torn(j)) continue;  // hands pass through torn rows
        row.displacement =
            displacements_ != nullptr ? displacements_->row(clay_.stored(j)) : areas->spare_row();
      }
      plan.fill(row.k, row);
      ++used;
    }
    return used;
  }
  BodyRow<Body>* rows() { return rows_; }

  // Rows of `reached` that may lose no area, and the rows among them that do not yield at all. Cut
  // clay raises nothing.
  struct Held {
    std::uint32_t firm = 0, rigid = 0;
  };
  Held held(int first, std::uint32_t reached) const {
    const RowAreas* const areas = clay_.areas();
    Held rows;
    if (areas == nullptr || !areas->any_firm() || cut_) return rows;
    for (; reached != 0; reached &= reached - 1) {
      const int k = std::countr_zero(reached);
      rows.firm |= std::uint32_t{areas->firm(first + k)} << k;
      rows.rigid |= std::uint32_t{areas->rigid(first + k)} << k;
    }
    rows.rigid &= rows.firm;
    return rows;
  }

  void account(int first, int used, const contact::RowsPressed& pressed, Press& out) {
    out.visited += std::int64_t{8} * pressed.blocks;
    out.touched += pressed.touched;
    clay_.mark_dirty(first, pressed.changed);
    RowAreas* const areas = clay_.areas();
    if (pressed.carried == 0 && areas == nullptr) return;
    for (int n = 0; n < used; ++n) {
      const contact::RowTask& row = rows_[n];
      const int j = first + row.k;
      if ((pressed.carried >> row.k & 1u) != 0) {
        if (side_ == WallSide::outside)
          clay_.widen_extent(j, 0.0f, row.behind_most);
        else
          clay_.widen_extent(j, row.behind_most, 1e9f);
      }
      if (areas == nullptr || (pressed.changed >> row.k & 1u) == 0) continue;
      // A wall at its thinnest grows where an edge pushes it aside. None of that growth was cut
      // off.
      areas->lose(j, portable::kPi / clay_.sectors() * double{row.lost}, cut_ && row.lost > 0.0f);
      if (displacements_ != nullptr)
        for (int r = 0; r < row.used; ++r) displacements_->mark(j, row.ranges[r]);
    }
  }

 private:
  Clay& clay_;
  WallSide side_;
  bool cut_;
  Displacements* displacements_ = nullptr;
  BodyRow<Body> rows_[kPlannedRows];
};

}  // namespace

template <class Body>
Press press(Clay& clay, WallSide side, const Body& body, Vec3 at, double seconds,
            const Yielding& yielding) noexcept {
  const contact::Kernels& all = contact::kernels(clay.vectors());
  const BodyKernel<Body>& kernel = kernel_of(all, body);
  const double rate = yielding.relaxation_time / seconds;
  const double gone = -portable::expm1(-1.0 / rate);
  contact::StepFigures step = figures_of(clay, side);
  step.gone = static_cast<float>(gone);
  step.mean = static_cast<float>(rate * gone);
  step.along = static_cast<float>(yielding.along);
  step.keeps = clay.areas() != nullptr;
  // The mean press over the step is (tau/dt)(1 - e^(-dt/tau)) of the first press.
  const double weight = yielding.stiffness * 2.0 * portable::kPi / clay.sectors() * rate * gone;

  Plan<Body> plan(clay, side, body, at);
  Pressing<Body> pressing(clay, side, yielding);
  const BodyFigures<Body>& figures = plan.figures();
  contact::PressSums sums;
  contact::PressTotal total;
  Press out;
  const int end_row = plan.end_row();
  const int first_row = first_pressed_row(clay, side, plan.first_row());
  for (int first = first_row; first < end_row; first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    const bool last = first + count == end_row;
    const std::uint32_t reached = plan.find(first, count);
    if (reached != 0) plan.find_lean();
    const auto [firm, rigid] = pressing.held(first, reached);
    const contact::RowPlaces places = places_of(clay, side, first, weight, plan.careful());
    const auto some = [&](std::uint32_t which, const contact::StepFigures& how, bool closing) {
      const int used = pressing.prepare(plan, first, which);
      if (used == 0 && !(closing && sums.begun)) return;
      const contact::RowsPressed pressed = kernel.press(side, how, figures, places, pressing.rows(),
                                                        used, sums, closing ? &total : nullptr);
      pressing.account(first, used, pressed, out);
    };
    some(reached & ~firm, step, last && firm == 0);
    if (firm == 0) continue;
    // A wall that may lose no area moves as a whole. Clay without a second face does not yield.
    const std::uint32_t walls = rows_from(places.hollow_from) & ~rigid;
    contact::StepFigures held = step;
    held.along = 1.0f;
    some(firm & walls, held, false);
    held.gone = 0.0f;
    some(firm & ~walls, held, last);
  }
  if (out.touched == 0) return out;
  // Pressing leaves a row's stored extent wider than its face, so too many elements are examined.
  // Measure one of the window's rows again, in turn.
  const int j = first_row + clay.next_measured(end_row - first_row);
  if (side == WallSide::outside)
    clay.set_extent(j, all.extent(side, clay.stride(), clay.outer(j).data()), clay.inner_least(j));
  else
    clay.set_extent(j, clay.outer_most(j), all.extent(side, clay.stride(), clay.inner(j).data()));

  out.force = {double{total.x}, double{total.y}, double{total.z}};
  out.normal = double{total.normal};
  // Partly covered elements reach a little beyond the body's surface, so their normals may be
  // longer than 1. The force is at most the sum of the normal forces.
  const double strength = length(out.force);
  if (strength > out.normal) out.force = (out.normal / strength) * out.force;
  out.depth = double{total.depth};
  return out;
}

template <class Body>
double depth(const Clay& clay, WallSide side, const Body& body, Vec3 at,
             std::int64_t& visited) noexcept {
  const BodyKernel<Body>& kernel = kernel_of(contact::kernels(clay.vectors()), body);
  const contact::StepFigures step = figures_of(clay, side);
  Plan<Body> plan(clay, side, body, at);
  const BodyFigures<Body> figures = plan.figures();
  BodyRow<Body> rows[kPlannedRows];
  float deepest = 0.0f;
  const int end_row = plan.end_row();
  for (int first = first_pressed_row(clay, side, plan.first_row()); first < end_row;
       first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    int used = 0;
    for (std::uint32_t reached = plan.find(first, count); reached != 0; reached &= reached - 1) {
      const int k = std::countr_zero(reached);
      BodyRow<Body>& row = rows[used++];
      row.k = k;
      plan.fill(k, row);
      visited += contact::elements_in(row.ranges, row.used);
    }
    if (used == 0) continue;
    // The depth kernel only reads.
    const contact::RowPlaces places =
        places_of(const_cast<Clay&>(clay), side, first, 0.0, plan.careful());
    deepest = std::max(deepest, kernel.depth(side, step, figures, places, rows, used));
  }
  return double{deepest};
}

template Press press(Clay&, WallSide, const Ball&, Vec3, double, const Yielding&) noexcept;
template double depth(const Clay&, WallSide, const Ball&, Vec3, std::int64_t&) noexcept;
template Press press(Clay&, WallSide, const Capsule&, Vec3, double, const Yielding&) noexcept;
template double depth(const Clay&, WallSide, const Capsule&, Vec3, std::int64_t&) noexcept;
template Press press(Clay&, WallSide, const Box&, Vec3, double, const Yielding&) noexcept;
template double depth(const Clay&, WallSide, const Box&, Vec3, std::int64_t&) noexcept;
template Press press(Clay&, WallSide, const Cylinder&, Vec3, double, const Yielding&) noexcept;
template double depth(const Clay&, WallSide, const Cylinder&, Vec3, std::int64_t&) noexcept;

}  // namespace onggi::body
