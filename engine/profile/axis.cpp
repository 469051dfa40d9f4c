#include "engine/profile/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/unit.h"
#include "engine/profile/axis_candidates.h"
#include "engine/profile/median.h"

namespace onggi::extraction {

namespace {

constexpr int kJudgeSlices = 24;
constexpr int kRefineSlices = 48;
constexpr int kAxisRays = 48;
constexpr int kCrowdSlices = 7, kCrowdRays = 12;
/// A radius counts as agreeing within this share of the vessel's largest radius...
constexpr double kAgree = 0.03;
/// ...and as entirely elsewhere beyond this one.
constexpr double kElsewhere = 0.15;
/// An axis this good needs no rival.
constexpr double kSurely = 0.01;
/// No tilt can make slices rounder than this by more than rounding errors.
constexpr double kPerfect = 2e-4;
/// A tilt must better the cost by this factor, or the axis as the file has it is kept.
constexpr double kWorthTilting = 0.97;

std::vector<double> even_heights(const Slicer& slicer, int n) {
  std::vector<double> out;
  for (int i = 0; i < n; ++i)
    out.push_back(slicer.lowest() + (slicer.highest() - slicer.lowest()) * (i + 0.5) / n);
  return out;
}

/// Middle of an outline by the lengths of its pieces.
Vec2 centroid(std::span<const CutSegment> outline) {
  Vec2 sum;
  double total = 0.0;
  for (const CutSegment& s : outline) {
    const double weight = length(s.b - s.a);
    sum = sum + (s.a + s.b) * (0.5 * weight);
    total += weight;
  }
  return total > 0.0 ? sum * (1.0 / total) : sum;
}

/// The circle through three points; false where they lie on a line.
bool circle_through(Vec2 a, Vec2 b, Vec2 c, FittedCircle& out) {
  const Vec2 u = b - a, v = c - a;
  const double twice = 2.0 * (u.x * v.y - u.y * v.x);
  if (twice == 0.0) return false;
  const double uu = dot(u, u), vv = dot(v, v);
  const Vec2 centre{(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
  out.centre = a + centre;
  out.radius = length(centre);
  return std::isfinite(out.radius);
}

/// One Gauss-Newton step of the weighted geometric fit.
void improve_circle(std::span<const Vec2> points, double scale, FittedCircle& c) {
  std::array<double, 6> m{};  // normal equations of (dx, dy, dr), upper half
  std::array<double, 3> rhs{};
  for (const Vec2& p : points) {
    const Vec2 d = p - c.centre;
    const double r = length(d);
    if (r <= 0.0) continue;
    const double miss = r - c.radius, x = miss / scale;
    if (x * x >= 1.0) continue;
    const double w = (1.0 - x * x) * (1.0 - x * x);  // Tukey's biweight
    const double ux = d.x / r, uy = d.y / r;
    m[0] += w * ux * ux, m[1] += w * ux * uy, m[2] += w * ux;
    m[3] += w * uy * uy, m[4] += w * uy, m[5] += w;
    rhs[0] += w * ux * miss, rhs[1] += w * uy * miss, rhs[2] += w * miss;
  }
  const double c00 = m[3] * m[5] - m[4] * m[4], c01 = m[2] * m[4] - m[1] * m[5],
               c02 = m[1] * m[4] - m[2] * m[3], c11 = m[0] * m[5] - m[2] * m[2],
               c12 = m[1] * m[2] - m[0] * m[4], c22 = m[0] * m[3] - m[1] * m[1];
  const double det = m[0] * c00 + m[1] * c01 + m[2] * c02;
  if (!(det > 1e-9 * m[5] * m[5] * m[5])) return;
  c.centre = c.centre + Vec2{(c00 * rhs[0] + c01 * rhs[1] + c02 * rhs[2]) / det,
                             (c01 * rhs[0] + c11 * rhs[1] + c12 * rhs[2]) / det};
  c.radius += (c02 * rhs[0] + c12 * rhs[1] + c22 * rhs[2]) / det;
}

/// Where each ray leaves an outline for good.
std::vector<Vec2> outermost(std::span<const CutSegment> outline, Vec2 centre, RayCrossings& rays) {
  std::vector<Vec2> out;
  const std::span<const double> radii = rays.outermost(outline, centre);
  out.reserve(radii.size());
  for (std::size_t k = 0; k < radii.size(); ++k)
    if (radii[k] > 0.0) out.push_back(centre + rays.fan().direction(k) * radii[k]);
  return out;
}

/// A line through the circles' centres: x and y as linear functions of height.
struct CentreLine {
  Vec2 at_zero, slope;
};
CentreLine fit_centres(const std::vector<FittedCircle>& circles, const std::vector<double>& heights,
                       double tolerance) {
  std::vector<double> xs, ys;
  for (const FittedCircle& c : circles)
    if (c.support > 0.0) xs.push_back(c.centre.x), ys.push_back(c.centre.y);
  CentreLine line{{median(xs), median(ys)}, {}};
  for (int pass = 0; pass < 12; ++pass) {
    // Wide at first, so that a tilted axis is not taken for stray centres.
    const double scale = tolerance * (pass < 4 ? 10.0 : pass < 8 ? 3.0 : 1.0);
    double w0 = 0.0, w1 = 0.0, w2 = 0.0;
    Vec2 s0, s1;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Vec2 miss = circles[i].centre - (line.at_zero + line.slope * heights[i]);
      const double x2 = dot(miss, miss) / (scale * scale);
      const double w = circles[i].support * circles[i].radius / ((1.0 + x2) * (1.0 + x2));
      w0 += w, w1 += w * heights[i], w2 += w * heights[i] * heights[i];
      s0 = s0 + circles[i].centre * w;
      s1 = s1 + circles[i].centre * (w * heights[i]);
    }
    const double det = w0 * w2 - w1 * w1;
    if (!(det > 1e-12 * w0 * w2)) break;
    line.at_zero = (s0 * w2 - s1 * w1) * (1.0 / det);
    line.slope = (s1 * w0 - s0 * w1) * (1.0 / det);
  }
  return line;
}

struct Judged {
  FoundAxis axis;
  Vec3 tilted;  ///< Where the circles' centres point.
  Vec3 tilted_origin;
};

/// Slices across `direction`: the best common centre, how far they are circles about it, and which
/// way the centres of the circles themselves run.
Judged judge(const TriangleMesh& mesh, Vec3 origin, Vec3 direction, int slices, bool keep_origin,
             RayCrossings& rays) {
  const AxisFrame frame = axis_frame(origin, direction);
  const Slicer slicer(mesh, frame);
  const std::vector<double> heights = even_heights(slicer, slices);
  const std::size_t n = rays.fan().count();

  double size = 0.0;
  std::vector<FittedCircle> circles(heights.size());
  slicer.each_cut(heights, [&](std::size_t i, std::span<const CutSegment> outline) {
    const auto points = outermost(outline, centroid(outline), rays);
    if (points.size() < n / 2) return;
    double reach = 0.0;
    for (const Vec2& p : points) reach = std::max(reach, length(p - points[0]));
    circles[i] = fit_circle(points, kAgree * 0.5 * reach);
    circles[i].support *= static_cast<double>(points.size()) / static_cast<double>(n);
    if (circles[i].support < 0.3 || circles[i].radius > reach) circles[i] = {};
    size = std::max(size, circles[i].radius);
  });
  Judged out;
  out.axis = {frame.origin, frame.up, 1.0};
  out.tilted = frame.up;
  out.tilted_origin = frame.origin;
  if (size <= 0.0) return out;

  const CentreLine line = fit_centres(circles, heights, 0.01 * size);
  const Vec3 tilt = frame.up + frame.across * line.slope.x + frame.along * line.slope.y;
  out.tilted = unit(tilt);
  out.tilted_origin = frame.origin + frame.across * line.at_zero.x + frame.along * line.at_zero.y;

  Vec2 centre{};
  if (!keep_origin) {
    std::vector<double> xs, ys;
    for (const FittedCircle& c : circles)
      if (c.support > 0.0) xs.push_back(c.centre.x), ys.push_back(c.centre.y);
    centre = {median(xs), median(ys)};
    out.axis.origin = frame.origin + frame.across * centre.x + frame.along * centre.y;
  }
  double cost = 0.0;
  slicer.each_cut(heights, [&](std::size_t, std::span<const CutSegment> outline) {
    std::vector<double> radii;
    for (const Vec2& p : outermost(outline, centre, rays)) radii.push_back(length(p - centre));
    const Agreement mode = agreement(radii, n, 0.5);
    double missed = static_cast<double>(n - radii.size());
    for (const double r : radii)
      missed += mode.found ? std::min(1.0, std::abs(r - mode.middle()) / (kElsewhere * size)) : 1.0;
    cost += missed / static_cast<double>(n);
  });
  out.axis.cost = cost / static_cast<double>(heights.size());
  return out;
}

Vec3 middle_of(const TriangleMesh& mesh) {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const auto& p : mesh.positions) {
    low = {std::min<double>(low.x, p[0]), std::min<double>(low.y, p[1]),
           std::min<double>(low.z, p[2])};
    high = {std::max<double>(high.x, p[0]), std::max<double>(high.y, p[1]),
            std::max<double>(high.z, p[2])};
  }
  return (low + high) * 0.5;
}

}  // namespace

int surfaces_met(const TriangleMesh& mesh) {
  const RayFan fan(kCrowdRays);
  RayCrossings rays(fan);
  const Slicer slicer(mesh, axis_frame(middle_of(mesh), {0, 1, 0}));
  std::vector<double> met;
  slicer.each_cut(even_heights(slicer, kCrowdSlices), [&](std::size_t, auto outline) {
    rays.meet(outline, {});
    for (std::size_t k = 0; k < fan.count(); ++k)
      met.push_back(static_cast<double>(rays.ray(k).size()));
  });
  return static_cast<int>(median(met));
}

FittedCircle fit_circle(std::span<const Vec2> points, double tolerance) {
  FittedCircle best;
  const std::size_t n = points.size();
  if (n < 6) return best;
  // Triples spread over the circle, turned a little further each time.
  double least = 1e300;
  std::vector<double> misses(n);
  for (std::size_t k = 0; k < std::min<std::size_t>(n, 24); ++k) {
    const std::size_t start = k * n / 24;
    FittedCircle c;
    if (!circle_through(points[start % n], points[(start + n / 3) % n],
                        points[(start + 2 * n / 3) % n], c))
      continue;
    for (std::size_t i = 0; i < n; ++i)
      misses[i] = std::abs(length(points[i] - c.centre) - c.radius);
    const double middle = median(misses);
    if (middle < least) {
      least = middle;
      best = c;
    }
  }
  for (int step = 0; step < 6; ++step)
    improve_circle(points, std::max(tolerance, 4.0 * least), best);
  std::size_t close = 0;
  for (const Vec2& p : points)
    if (std::abs(length(p - best.centre) - best.radius) <= tolerance) ++close;
  best.support = static_cast<double>(close) / static_cast<double>(n);
  return best;
}

FoundAxis axis_along(const TriangleMesh& mesh, Vec3 direction) {
  const RayFan fan(kAxisRays);
  RayCrossings rays(fan);
  return judge(mesh, middle_of(mesh), direction, kRefineSlices, false, rays).axis;
}

FoundAxis find_axis(const TriangleMesh& mesh) {
  const RayFan fan(kAxisRays);
  RayCrossings rays(fan);
  const Vec3 middle = middle_of(mesh);
  FoundAxis best;
  const auto try_axis = [&](Vec3 direction) {
    const Judged judged = judge(mesh, middle, direction, kJudgeSlices, false, rays);
    if (judged.axis.cost < kWorthTilting * best.cost - 1e-4) best = judged.axis;
  };
  // The file's own axes come first, y before z; another must be clearly better.
  for (const Vec3& direction : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}})
    if (best.cost >= kSurely) try_axis(direction);
  if (best.cost >= kSurely)
    for (const Vec3& direction : axis_candidates(mesh)) try_axis(direction);
  if (best.cost >= 1.0) return best;

  // Follow the centres of the circles, as long as that makes the slices rounder.
  Judged now = judge(mesh, best.origin, best.direction, kRefineSlices, false, rays);
  best = now.axis;
  const auto along = [&](double part) { return std::abs(part) > 1.0 - 1e-12; };
  const bool as_filed =
      along(best.direction.x) || along(best.direction.y) || along(best.direction.z);
  for (int step = 0; step < 6; ++step) {
    if (best.cost < kPerfect) break;
    const Judged tilted = judge(mesh, now.tilted_origin, now.tilted, kRefineSlices, true, rays);
    if (tilted.axis.cost > (as_filed ? kWorthTilting * best.cost - 1e-5 : best.cost)) break;
    best = tilted.axis;
    now = tilted;
  }
  return best;
}

}  // namespace onggi::extraction
