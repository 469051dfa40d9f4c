#include "engine/effects/laid_coil.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/math/portable.h"

namespace onggi::effects {
namespace {

constexpr double kTurn = 2.0 * portable::kPi;
constexpr double kEdge = 0.003;  // m
constexpr double kLeast = 1e-9;  // m: nearer than this there is no way out to point to

// Angle of `at` about the axis, 0..2 pi.
double turned(Vec3 at) {
  const double angle = portable::atan2(at.z, at.x);
  return angle < 0.0 ? angle + kTurn : angle;
}

// `from`: from the nearest point of a body's middle line to the middle of a ball of `radius`.
Overlap from_middle(Vec3 from, double radius, double section) {
  const double apart = length(from);
  const Vec3 out = apart > kLeast ? (1.0 / apart) * from : Vec3{0.0, 1.0, 0.0};
  return {std::max(radius + section - apart, 0.0), out};
}

}  // namespace

LaidCoil::LaidCoil(int sectors, std::size_t most)
    : centre_(static_cast<std::size_t>(sectors)), most_(most) {
  events_.reserve(2 * most + 2);
}

double LaidCoil::volume(double section) const noexcept {
  double centres = 0.0;
  for (const float centre : centre_) centres += double{centre};
  return section * kTurn / sectors() * centres;
}

void LaidCoil::note(const Event& event) noexcept {
  events_.push_back(event);
  take(event);
}

void LaidCoil::take(const Event& event) noexcept {
  if (event.what >= 0) {
    centre_[static_cast<std::size_t>(event.what)] = event.centre;
    ++count_;
    return;
  }
  added_ = event.what == kFreshLump ? 0.0 : added_ + event.row.volume;
  ++raised_;
  if (event.what == kRow) return;
  std::ranges::fill(centre_, 0.0f);
  count_ = raised_ = 0;
}

// The first event after the lump was laid.
std::size_t LaidCoil::lump() const noexcept {
  const auto fresh = std::find_if(events_.rbegin(), events_.rend(),
                                  [](const Event& event) { return event.what == kFreshLump; });
  return static_cast<std::size_t>(fresh.base() - events_.begin());
}

void LaidCoil::lay(int sector, float centre, std::uint64_t step) noexcept {
  note({step, sector, centre, {}});
}

// Free sectors onwards from a laid one.
int LaidCoil::gap_after(int sector) const noexcept {
  int gap = 0;
  while (gap < sectors() && centre((sector + gap + 1) % sectors()) == 0.0f) ++gap;
  return gap;
}

void LaidCoil::close_gaps(double length, std::uint64_t step) noexcept {
  const int n = sectors();
  for (int i = 0; i < n; ++i) {
    const int gap = centre(i) != 0.0f ? gap_after(i) : 0;
    if (gap == 0 || gap > n / 8) continue;
    const auto from = double{centre(i)}, to = double{centre((i + gap + 1) % n)};
    if (gap * kTurn / n * std::min(from, to) >= length) continue;
    for (int k = 1; k <= gap; ++k)
      lay((i + k) % n, static_cast<float>(from + (to - from) * k / (gap + 1)), step);
  }
}

void LaidCoil::raise(const Row& row, bool last, std::uint64_t step) noexcept {
  note({step, last ? kLastRow : kRow, 0.0f, row});
}

// Undo brings back at most the lump before this one.
void LaidCoil::clear(std::uint64_t step) noexcept {
  events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(lump()));
  note({step, kFreshLump, 0.0f, {}});
}

void LaidCoil::go_back(std::uint64_t step) noexcept {
  while (!events_.empty() && events_.back().step >= step) events_.pop_back();
  take({0, kFreshLump, 0.0f, {}});
  for (std::size_t n = lump(); n < events_.size(); ++n) take(events_[n]);
}

Overlap LaidCoil::touched(const Clay& clay, Vec3 at, double radius, double coil,
                          double height) const noexcept {
  const double out = length(Vec2{at.x, at.z});
  const double reach = radius + 0.5 * coil;
  if (!any() || std::fabs(at.y - height) >= reach) return {};
  // Beyond this many sectors to either side, everything is out of reach.
  const double wide = out > reach ? portable::asin(reach / out) : portable::kPi;
  const int n = sectors();
  const int each = std::min(static_cast<int>(wide / kTurn * n) + 2, n / 2);
  const int here = sector_at(clay, at);
  const auto middle = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const auto centre = double{centre_[k]};
    return Vec3{centre * double{clay.ray_cos()[k]}, height, centre * double{clay.ray_sin()[k]}};
  };
  Overlap deepest;
  for (int k = here - each; k <= here + each; ++k) {
    const int i = (k + 2 * n) % n;
    if (centre(i) == 0.0f) continue;
    const Vec3 a = middle(i);
    Vec3 nearest = a;
    if (const int next = (i + 1) % n; centre(next) != 0.0f) {
      const Vec3 way = middle(next) - a;
      const double share = dot(at - a, way) / std::max(dot(way, way), kLeast * kLeast);
      nearest = a + std::clamp(share, 0.0, 1.0) * way;
    }
    const Overlap found = from_middle(at - nearest, radius, 0.5 * coil);
    if (found.depth > deepest.depth) deepest = found;
  }
  return deepest;
}

void LaidCoil::add_to(StateHash& hash) const {
  hash.add(static_cast<std::uint64_t>(events_.size()) << 32 | static_cast<std::uint64_t>(raised_));
  for (int i = 0; any() && i < sectors(); ++i) hash.add(double{centre(i)});
}

Overlap rim_touched(const Clay& clay, Vec3 at, double radius) noexcept {
  const int top = clay.rows() - 1;
  const double rays = turned(at) / kTurn * clay.sectors() - 0.5;
  const double below = std::floor(rays);
  const auto n = static_cast<std::size_t>(clay.sectors());
  const auto i = static_cast<std::size_t>(static_cast<int>(below) + clay.sectors()) % n;
  const auto between = [&](std::span<const float> face) {
    return double{face[i]} + (rays - below) * (double{face[(i + 1) % n]} - double{face[i]});
  };
  const double outer = between(clay.outer(top)), inner = between(clay.inner(top));
  const double section = std::min(kEdge, 0.5 * (outer - inner));
  const double out = length(Vec2{at.x, at.z});
  const double nearest = std::max(std::min(out, outer - section), inner + section);
  const double up = std::max(at.y - (clay.rim_height() - section), 0.0);
  const Overlap flat = from_middle({out - nearest, up, 0.0}, radius, section);
  if (!(flat.depth > 0.0)) return {};
  const double x = out > kLeast ? at.x / out : 1.0, z = out > kLeast ? at.z / out : 0.0;
  return {flat.depth, {flat.out.x * x, flat.out.y, flat.out.x * z}};
}

int sector_at(const Clay& clay, Vec3 at) noexcept {
  const int n = clay.sectors();
  return std::clamp(static_cast<int>(turned(at) / kTurn * n), 0, n - 1);
}

}  // namespace onggi::effects
