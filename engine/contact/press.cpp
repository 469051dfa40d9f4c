#include "engine/contact/press.h"

#include <algorithm>

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

// How the rows that a body may touch are found: which there are, and what of each.
template <class Body>
class Plan {
 public:
  Plan(const Clay& clay, WallSide side, const Body& body, Vec3 at)
      : clay_(clay), side_(side), body_(body), window_(clay, body.heights(), body.hull(), at) {}

  int first_row() const { return window_.first_row; }
  int end_row() const { return window_.end_row; }
  static BodyFigures<Body> figures(const Body&) { return {}; }
  void find(int first, int count) {
    for (int n = 0; n < count; n += kFew) {
      const int few = std::min(count - n, kFew);
      bool covered[kFew];
      for (int k = 0; k < few; ++k) {
        contact::SolidReach& row = rows_[n + k];
        covered[k] = contact::cover_row(clay_, window_, side_, first + n + k, row);
        if (covered[k]) row.outline = body_.outline(row.y);
      }
      contact::plan_rows(clay_, window_, side_, first + n, few, covered, rows_ + n);
    }
  }
  const contact::SolidReach& found(int k) const { return rows_[k]; }
  void drop(int k) { rows_[k].used = 0; }
  void fill(const contact::SolidReach& found, float /*limit*/, BodyRow<Body>& row) const {
    row.section = body_.section(found.y);
    row.outline = &found.outline;
    row.sector = static_cast<float>(2.0 * portable::kPi / clay_.sectors());
    row.share = found.share;
    row.careful = true;
  }

 private:
  static constexpr int kFew = 8;
  const Clay& clay_;
  WallSide side_;
  const Body& body_;
  contact::SolidWindow window_;
  contact::SolidReach rows_[kPlannedRows];
};

template <>
class Plan<Ball> {
 public:
  Plan(const Clay& clay, WallSide side, const Ball& ball, Vec3)
      : clay_(clay),
        side_(side),
        per_radius_(static_cast<float>(1.0 / ball.radius)),
        window_(clay, ball.middle, ball.radius) {}

  int first_row() const { return window_.first_row; }
  int end_row() const { return window_.end_row; }
  static BodyFigures<Ball> figures(const Ball& ball) { return {ball.figures()}; }

  void find(int first, int count) { plan_rows(clay_, window_, side_, first, count, rows_); }
  const contact::RowReach& found(int k) const { return rows_[k]; }
  void drop(int k) { rows_[k].used = 0; }
  void fill(const contact::RowReach& found, float limit, BodyRow<Ball>& row) const {
    const float covered = 2.0f * found.section * found.per_width;
    row.section = {found.section, found.section + 0.5f * found.width, found.per_width,
                   covered < 1.0f ? covered : 1.0f, found.above * per_radius_};
    const double section = double{found.section};
    row.careful =
        found.edged || (side_ == WallSide::outside ? window_.distance - section < double{limit}
                                                   : window_.distance + section > double{limit});
  }

 private:
  const Clay& clay_;
  WallSide side_;
  float per_radius_;
  contact::BallWindow window_;
  contact::RowReach rows_[kPlannedRows];
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

// The rows that a body presses in one step: made ready for its kernel, and what came of them told
// to the clay.
template <class Body>
class Pressing {
 public:
  Pressing(Clay& clay, WallSide side, const Yielding& yielding, double weight)
      : clay_(clay), side_(side), yielding_(yielding), weight_(weight) {
    if (clay.areas() != nullptr && !yielding.cut)
      shifts_ = clay.shifts(side == WallSide::inside);  // what is cut off drags nothing along
  }

  // Gives how many of the planned rows there is work on.
  int prepare(Plan<Body>& plan, int first, int count, float limit) {
    if (const RowAreas* areas = clay_.areas(); areas != nullptr && areas->any_torn())
      for (int k = 0; k < count; ++k)
        if (areas->torn(first + k)) plan.drop(k);  // hands pass through it
    int used = 0;
    for (int k = 0; k < count; ++k) {
      const auto& found = plan.found(k);
      if (found.used == 0) continue;
      row_[used] = first + k;
      BodyRow<Body>& row = rows_[used++];
      plan.fill(found, limit, row);
      take(first + k, row);
      row.used = found.used;
      for (int n = 0; n < found.used; ++n) row.ranges[n] = found.ranges[n];
    }
    return used;
  }
  BodyRow<Body>* rows() { return rows_; }

  void account(int first, int used, Press& out) {
    std::uint64_t changed = 0;
    for (int n = 0; n < used; ++n) {
      const contact::RowTask& row = rows_[n];
      const int j = row_[n];
      out.visited += contact::elements_in(row.ranges, row.used);
      if (row.touched == 0) continue;
      out.touched += row.touched;
      if (side_ == WallSide::outside) {
        if (row.behind_most < row.behind_start) clay_.widen_extent(j, 0.0f, row.behind_most);
      } else if (row.behind_most > row.behind_start) {
        clay_.widen_extent(j, row.behind_most, 1e9f);
      }
      if (RowAreas* areas = clay_.areas()) {
        areas->lose(j, portable::kPi / clay_.sectors() * double{row.lost}, yielding_.cut);
        if (shifts_ != nullptr)
          for (int r = 0; r < row.used; ++r) shifts_->mark(j, row.ranges[r]);
      }
      changed |= std::uint64_t{1} << (j - first);
    }
    clay_.mark_dirty(first, changed);
  }

 private:
  void take(int j, contact::RowTask& row) {
    float* outer = clay_.pressable_outer(j).data();
    float* inner = clay_.pressable_inner(j).data();
    const bool outside = side_ == WallSide::outside;
    row.face = outside ? outer : inner;
    row.behind = outside ? inner : outer;
    row.behind_start = outside ? clay_.inner_least(j) : clay_.outer_most(j);
    row.hollow = j >= clay_.floor_rows();
    row.regroups = clay_.row_thickness(j) != thickness_;
    thickness_ = clay_.row_thickness(j);
    row.area = static_cast<float>(weight_ * thickness_);
    if (RowAreas* areas = clay_.areas())
      row.shift = shifts_ != nullptr ? shifts_->row(j) : areas->spare_row();
  }

  Clay& clay_;
  WallSide side_;
  const Yielding& yielding_;
  double weight_;
  Shifts* shifts_ = nullptr;
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
  const BodyFigures<Body> figures = Plan<Body>::figures(body);
  contact::PressSums sums;
  Press out;
  const int end_row = plan.end_row();
  const int first_row = first_pressed_row(clay, side, plan.first_row());
  for (int first = first_row; first < end_row; first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    plan.find(first, count);
    const int used = pressing.prepare(plan, first, count, step.limit);
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
  const BodyFigures<Body> figures = Plan<Body>::figures(body);
  BodyRow<Body> rows[kPlannedRows];
  float deepest = 0.0f;
  const int end_row = plan.end_row();
  for (int first = first_pressed_row(clay, side, plan.first_row()); first < end_row;
       first += kPlannedRows) {
    const int count = std::min(kPlannedRows, end_row - first);
    plan.find(first, count);
    int used = 0;
    for (int k = 0; k < count; ++k) {
      const auto& found = plan.found(k);
      if (found.used == 0) continue;
      const int j = first + k;
      BodyRow<Body>& row = rows[used++];
      plan.fill(found, step.limit, row);
      const float* face = side == WallSide::outside ? clay.outer(j).data() : clay.inner(j).data();
      row.face = const_cast<float*>(face);  // depth only reads
      row.used = found.used;
      for (int n = 0; n < found.used; ++n) row.ranges[n] = found.ranges[n];
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
