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

// How the rows that a body may touch are found: which of some rows there are, and what of each.
template <class Body>
class Plan {
 public:
  Plan(const Clay& clay, WallSide side, const Body& body, Vec3 at)
      : clay_(clay),
        side_(side),
        body_(body),
        sector_(static_cast<float>(2.0 * portable::kPi / clay.sectors())),
        window_(clay, body.heights(), body.hull(), at) {}

  int first_row() const { return window_.first_row; }
  int end_row() const { return window_.end_row; }
  BodyFigures<Body> figures() const { return {}; }

  // Bit k: row first + k has something to touch.
  std::uint32_t find(int first, int count) {
    std::uint32_t reached = 0;
    for (int n = 0; n < count; n += kFew) {
      const int few = std::min(count - n, kFew);
      bool covered[kFew];
      for (int k = 0; k < few; ++k) {
        contact::SolidReach& row = rows_[n + k];
        covered[k] = contact::cover_row(clay_, window_, side_, first + n + k, row);
        if (covered[k]) row.outline = body_.outline(row.y);
      }
      contact::plan_rows(clay_, window_, side_, first + n, few, covered, rows_ + n);
      for (int k = 0; k < few; ++k) reached |= std::uint32_t{rows_[n + k].used > 0} << (n + k);
    }
    return reached;
  }
  void fill(int k, float /*limit*/, BodyRow<Body>& row) const {
    const contact::SolidReach& found = rows_[k];
    row.section = body_.section(found.y);
    row.outline = &found.outline;
    row.sector = sector_;
    row.share = found.share;
    row.careful = true;
    row.used = found.used;
    row.ranges[0] = found.ranges[0];
    row.ranges[1] = found.ranges[1];
  }

 private:
  static constexpr int kFew = 8;
  const Clay& clay_;
  WallSide side_;
  const Body& body_;
  float sector_;
  contact::SolidWindow window_;
  contact::SolidReach rows_[kPlannedRows];
};

// A block of elements that begins beside a ball may end behind the axis, where rays meet the ball
// too, from the wrong end: on coarse grids, of balls that are wide as seen from the axis. `sine`:
// of half that angle. By cos x >= 1 - x^2 / 2.
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
        ball_(ball),
        window_(clay, ball.middle, ball.radius),
        far_half_(reaches_far_half(clay.sectors(), ball.radius / window_.distance)) {}

  int first_row() const { return window_.first_row; }
  int end_row() const { return window_.end_row; }
  BodyFigures<Ball> figures() const {
    return {static_cast<float>(ball_.middle.x),
            static_cast<float>(ball_.middle.z),
            static_cast<float>(1.0 / ball_.radius),
            static_cast<float>(ball_.middle.x / ball_.radius),
            static_cast<float>(ball_.middle.z / ball_.radius),
            &rows_};
  }

  std::uint32_t find(int first, int count) {
    plan_rows(clay_, window_, side_, first, count, rows_);
    return rows_.reached;
  }
  void fill(int k, float limit, BodyRow<Ball>& row) const {
    row.k = k;
    const double section = double{rows_.section[k]};
    row.careful = far_half_ || (rows_.edged >> k & 1u) != 0 ||
                  (side_ == WallSide::outside ? window_.distance - section < double{limit}
                                              : window_.distance + section > double{limit});
    row.used = blocks_of(shape_, rows_, k, row.ranges);
  }

 private:
  const Clay& clay_;
  contact::RowShape shape_;
  WallSide side_;
  const Ball& ball_;
  contact::BallWindow window_;
  bool far_half_;
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

// Inside, the solid floor rows are a stop instead (stops.h).
int first_pressed_row(const Clay& clay, WallSide side, int first) {
  return side == WallSide::inside ? std::max(first, clay.floor_rows()) : first;
}

contact::StepFigures figures_of(const Clay& clay, WallSide side) {
  const ClayDef& def = clay.def();
  contact::StepFigures step;
  step.ray_cos = clay.ray_cos().data();
  step.ray_sin = clay.ray_sin().data();
  step.limit = static_cast<float>(side == WallSide::outside ? def.radius_min + def.wall_min
                                                            : def.radius_max - def.wall_min);
  step.wall_min = static_cast<float>(def.wall_min);
  step.farthest = static_cast<float>(side == WallSide::outside ? def.radius_min : def.radius_max);
  return step;
}

// Some rows that a body presses in one step: made ready for its kernel, and what came of them told
// to the clay.
template <class Body>
class Pressing {
 public:
  Pressing(Clay& clay, WallSide side, const Yielding& yielding, double weight)
      : clay_(clay), side_(side), cut_(yielding.cut), weight_(weight) {
    if (clay.areas() != nullptr && !cut_)
      displacements_ =
          clay.displacements(side == WallSide::inside);  // what is cut off drags nothing along
  }

  // Those of `reached` from row `first` on. Gives how many there is work on.
  int prepare(const Plan<Body>& plan, int first, std::uint32_t reached, float limit) {
    RowAreas* areas = clay_.areas();
    const bool torn = areas != nullptr && areas->any_torn();
    const bool outside = side_ == WallSide::outside;
    float* const face = (outside ? clay_.pressable_outer(0) : clay_.pressable_inner(0)).data();
    float* const behind = (outside ? clay_.pressable_inner(0) : clay_.pressable_outer(0)).data();
    const float* const bounds = (outside ? clay_.inner_least() : clay_.outer_most()).data();
    const double* const thicknesses = clay_.row_thicknesses().data();
    const auto stride = static_cast<std::size_t>(clay_.stride());
    const int floor_rows = clay_.floor_rows();
    double thickness = thickness_;
    int used = 0;
    for (; reached != 0; reached &= reached - 1) {
      const int k = std::countr_zero(reached);
      const int j = first + k;
      if (torn && areas->torn(j)) continue;  // hands pass through it
      const auto n = static_cast<std::size_t>(j);
      row_[used] = j;
      BodyRow<Body>& row = rows_[used++];
      plan.fill(k, limit, row);
      row.face = face + n * stride;
      row.behind = behind + n * stride;
      row.behind_start = bounds[n];
      row.hollow = j >= floor_rows;
      row.regroups = thicknesses[n] != thickness;
      thickness = thicknesses[n];
      if (row.regroups) row.area = static_cast<float>(weight_ * thickness);
      if (areas != nullptr)
        row.displacement = displacements_ != nullptr ? displacements_->row(j) : areas->spare_row();
    }
    thickness_ = thickness;
    return used;
  }
  BodyRow<Body>* rows() { return rows_; }

  void account(int first, int used, Press& out) {
    RowAreas* areas = clay_.areas();
    std::uint64_t changed = 0;
    std::int64_t visited = 0;
    std::int64_t touched = 0;
    for (int n = 0; n < used; ++n) {
      const contact::RowTask& row = rows_[n];
      visited += contact::elements_in(row.ranges, row.used);
      if (row.touched == 0) continue;
      const int j = row_[n];
      touched += row.touched;
      changed |= std::uint64_t{1} << (j - first);
      if (row.behind_most != row.behind_start) {
        if (side_ == WallSide::outside)
          clay_.widen_extent(j, 0.0f, row.behind_most);
        else
          clay_.widen_extent(j, row.behind_most, 1e9f);
      }
      if (areas == nullptr) continue;
      areas->lose(j, portable::kPi / clay_.sectors() * double{row.lost}, cut_);
      if (displacements_ != nullptr)
        for (int r = 0; r < row.used; ++r) displacements_->mark(j, row.ranges[r]);
    }
    out.visited += visited;
    out.touched += touched;
    clay_.mark_dirty(first, changed);
  }

 private:
  Clay& clay_;
  WallSide side_;
  bool cut_;
  double weight_;  // force per press, radius and height
  Displacements* displacements_ = nullptr;
  double thickness_ = 0.0;  // of the row before
  int row_[kPlannedRows];
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
  step.along = static_cast<float>(yielding.along);
  step.keeps = clay.areas() != nullptr;
  // The mean press over the step is (tau/dt)(1 - e^(-dt/tau)) of the first.
  const double weight = yielding.stiffness * 2.0 * portable::kPi / clay.sectors() * rate * gone;

  Plan<Body> plan(clay, side, body, at);
  Pressing<Body> pressing(clay, side, yielding, weight);
  const BodyFigures<Body> figures = plan.figures();
  contact::PressSums sums;
  Press out;
  const int end_row = plan.end_row();
  const int first_row = first_pressed_row(clay, side, plan.first_row());
  for (int first = first_row; first < end_row; first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    const int used = pressing.prepare(plan, first, plan.find(first, count), step.limit);
    if (used == 0) continue;
    kernel.press(side, step, figures, pressing.rows(), used, sums);
    pressing.account(first, used, out);
  }
  if (out.touched == 0) return out;
  // Pressing leaves a row's extent wider than the row, so that more is looked at than need be:
  // whose turn it is of the window's rows is measured anew.
  const int j = first_row + clay.next_measured(end_row - first_row);
  float most = 0.0f;
  float least = 0.0f;
  all.extent(clay.stride(), clay.outer(j).data(), clay.inner(j).data(), &most, &least);
  clay.set_extent(j, most, least);

  const contact::PressTotal total = kernel.total(figures, sums);
  out.force = {double{total.x}, double{total.y}, double{total.z}};
  out.normal = double{total.normal};
  // Elements in part covered reach a little beyond the body's surface, and so does their normal.
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
      plan.fill(k, step.limit, row);
      const float* face =
          (side == WallSide::outside ? clay.outer(first + k) : clay.inner(first + k)).data();
      row.face = const_cast<float*>(face);  // depth only reads
      visited += contact::elements_in(row.ranges, row.used);
    }
    if (used > 0) deepest = std::max(deepest, kernel.depth(side, step, figures, rows, used));
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
