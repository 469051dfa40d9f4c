#include "engine/lab/plain_wall.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr double kTurn = 2.0 * portable::kPi;

// Of one step: the share of a press that is gone at its end, the share that is felt, and the moment
// at which the tool is met.
struct StepOf {
  double gone, felt, at;
};

StepOf step_of(const PlainLaw& law, double seconds) {
  if (law.rule == TimeRule::printed) return {1.0 / law.c_eta, 1.0, 1.0};
  const double gone = -portable::expm1(-seconds / law.relaxation_time);
  if (law.rule == TimeRule::exact) return {gone, 1.0, 1.0};
  return {gone, law.relaxation_time / seconds * gone, 0.5};
}

// The elements whose rays can meet the ball's section with a row: `count` from `first` on, wrapped.
struct Rays {
  int first, count;
};
Rays rays_of(double angle, double d, double r, double more, int sectors) {
  if (r >= d) return {0, sectors};
  const double half = portable::asin(r / d) + more;
  const double per_radian = sectors / kTurn;
  const int first = static_cast<int>(std::ceil((angle - half) * per_radian - 0.5));
  const int last = static_cast<int>(std::floor((angle + half) * per_radian - 0.5));
  return {((first % sectors) + sectors) % sectors, std::clamp(last - first + 1, 0, sectors)};
}

constexpr double kGrazes = 0.25881904510252074;  // cos 75 degrees: a print reaches no farther round

}  // namespace

template <class Real>
PlainWall<Real>::PlainWall(const ClayDef& def, double low, double high)
    : sectors_(def.sectors),
      thickness_(def.height / def.rows),
      nearest_(static_cast<Real>(def.radius_min + def.wall_min)),
      farthest_(static_cast<Real>(def.radius_max - def.wall_min)) {
  const int first = std::max(0, static_cast<int>(std::ceil(low / thickness_ - 0.5)));
  const int end = std::min(def.rows, static_cast<int>(std::floor(high / thickness_ + 0.5)));
  rows_ = std::max(end - first, 0);
  bottom_ = (first + 0.5) * thickness_;
  const auto n = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(sectors_);
  outer_.assign(n, static_cast<Real>(def.outer_radius));
  inner_.assign(n, static_cast<Real>(def.inner_radius));
  for (int i = 0; i < sectors_; ++i) {
    const double angle = (i + 0.5) * kTurn / sectors_;
    cos_.push_back(static_cast<Real>(portable::cos(angle)));
    sin_.push_back(static_cast<Real>(portable::sin(angle)));
  }
}

// dr/dy of a face at `angle` (rad, clay frame), between half a `radius` above and below `height`:
// straight between the middles of its elements, and only as far as it has rows.
template <class Real>
double PlainWall<Real>::slope(WallSide side, double height, double angle, double radius) const {
  const std::vector<Real>& of = face(side);
  const double rays = angle / kTurn * sectors_ - 0.5;
  const double whole = std::floor(rays);
  const auto at = [&](double n) {
    return static_cast<std::size_t>(n - sectors_ * std::floor(n / sectors_));
  };
  const auto out_at = [&](double up) {
    const double low = std::min(std::floor(up), rows_ - 2.0);
    const std::size_t row = static_cast<std::size_t>(low) * static_cast<std::size_t>(sectors_);
    const auto on = [&](std::size_t first) {
      const auto here = double{of[first + at(whole)]}, there = double{of[first + at(whole + 1.0)]};
      return here + (rays - whole) * (there - here);
    };
    const double below = on(row), above = on(row + static_cast<std::size_t>(sectors_));
    return below + (up - low) * (above - below);
  };
  const auto place = [&](double y) {
    return std::clamp((y - bottom_) / thickness_, 0.0, rows_ - 1.0);
  };
  const double low = place(height - 0.5 * radius), high = place(height + 0.5 * radius);
  return (out_at(high) - out_at(low)) / ((high - low) * thickness_);
}

template <class Real>
Vec3 PlainWall<Real>::step(const PlainLaw& law, const BallWay& way) noexcept {
  const StepOf time = step_of(law, way.seconds);
  const double angle = way.angle_from + time.at * (way.angle_to - way.angle_from);
  const double c = portable::cos(angle), s = portable::sin(angle);
  const Vec3 at = way.from + time.at * (way.to - way.from);
  // Into the clay's frame, once.
  const Vec3 h{at.x * c + at.z * s, at.y, at.z * c - at.x * s};
  const double d = axis_distance(h);
  const bool outside = way.side == WallSide::outside;
  const bool edges = law.quadrature == Quadrature::edges;
  const double sector = kTurn / sectors_;
  const double weight = law.quadrature == Quadrature::none
                            ? law.c_v
                            : law.stiffness * sector * thickness_ * time.felt;

  // What is felt turns with a wall that leans: (n . w)(w . ray) / (n . ray), w across the face.
  const double lean = edges ? slope(way.side, h.y, portable::atan2(h.z, h.x), way.radius) : 0.0;
  const double square = 1.0 / (1.0 + lean * lean);
  const Real square_on = static_cast<Real>(square);
  const Real least_chord = static_cast<Real>(kGrazes * way.radius);

  Real sum_x = 0, sum_y = 0, sum_z = 0;
  const int first_row =
      std::max(0, static_cast<int>(std::ceil((h.y - way.radius - bottom_) / thickness_)));
  const int last_row =
      std::min(rows_ - 1, static_cast<int>(std::floor((h.y + way.radius - bottom_) / thickness_)));
  const Real hx = static_cast<Real>(h.x), hz = static_cast<Real>(h.z);
  const Real gone = static_cast<Real>(time.gone);
  for (int j = first_row; j <= last_row; ++j) {
    const double above = h.y - row_height(j);
    const double section =
        std::sqrt(std::max((way.radius - std::fabs(above)) * (way.radius + std::fabs(above)), 0.0));
    if (!(section > 0.0)) continue;
    const double width = std::sqrt(std::max((d - section) * (d + section), 0.0)) * sector;
    const Rays rays =
        rays_of(portable::atan2(h.z, h.x), d, section, edges ? 0.5 * sector : 0.0, sectors_);
    const Real r = static_cast<Real>(section), dy = static_cast<Real>(above);
    const Real aslant = static_cast<Real>((outside ? square : -square) * lean * above);
    // Coverage of an element grows from 0 to 1 over its own width about the edge.
    const Real reach = edges ? static_cast<Real>(section + 0.5 * width) : r;
    const Real per_width = static_cast<Real>(1.0 / std::max(width, 1e-12));
    const Real most = static_cast<Real>(std::min(1.0, 2.0 * section / std::max(width, 1e-12)));
    Real* const face = (outside ? outer_ : inner_).data() +
                       static_cast<std::size_t>(j) * static_cast<std::size_t>(sectors_);
    for (int n = 0; n < rays.count; ++n) {
      const int wrapped = rays.first + n < sectors_ ? rays.first + n : rays.first + n - sectors_;
      const auto i = static_cast<std::size_t>(wrapped);
      const Real off = std::fabs(hz * cos_[i] - hx * sin_[i]);
      if (!(off < reach)) continue;
      const Real along = hx * cos_[i] + hz * sin_[i];
      if (outside && !(along > 0)) continue;
      const Real chord = off < r ? std::sqrt((r - off) * (r + off)) : Real{0};
      const Real end = outside ? along - chord : along + chord;
      const Real now = face[i];
      const Real press = outside ? now - std::max(end, nearest_) : std::min(end, farthest_) - now;
      if (!(press > 0)) continue;
      const Real covered = edges ? std::min((reach - off) * per_width, most) : Real{1};
      const Real given = gone * covered * press;
      face[i] = outside ? now - given : now + given;
      Real felt = covered * press;
      // As a press fades, the face moves as much: the mean of both ends' radii.
      if (law.quadrature != Quadrature::none)
        felt *= law.rule == TimeRule::shipped ? Real(0.5) * (now + face[i]) : now;
      felt *= std::max(square_on - aslant / std::max(chord, least_chord), Real{0});
      sum_x += felt * (hx - end * cos_[i]);
      sum_y += felt * dy;
      sum_z += felt * (hz - end * sin_[i]);
    }
  }
  const double per = weight / way.radius;
  const double x = per * double{sum_x}, z = per * double{sum_z};
  return {x * c - z * s, per * double{sum_y}, x * s + z * c};
}

template class PlainWall<float>;
template class PlainWall<double>;

}  // namespace onggi::lab
