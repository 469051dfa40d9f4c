#include "engine/contact/solid_window.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/ball_window.h"
#include "engine/contact/bodies/ball.h"
#include "engine/contact/kernels.h"
#include "engine/math/portable.h"

namespace onggi::contact {
namespace {

constexpr int kFew = 8;

// For each row's circle, half the angle between the outermost elements it reaches; negative: none.
struct Circles {
  float half[kFew];
  float extent[kFew];
  body::Circle circle[kFew];

  bool reaches(int k) const { return half[k] >= 0.0f; }
};

float extent_of(const Clay& clay, WallSide side, int j) {
  return side == WallSide::outside ? clay.outer_most(j) : clay.inner_least(j);
}

Circles circles_of(const Clay& clay, WallSide side, int first, int count, const bool* covered,
                   const SolidReach* rows) {
  Circles out;
  float distance[kFew] = {};
  float radius[kFew] = {};
  float tangent[kFew] = {};
  std::fill_n(out.extent, kFew, 0.0f);
  int like = -1;  // the last row with a circle
  for (int k = 0; k < count; ++k) {
    radius[k] = -1.0f;
    if (!covered[k]) continue;
    if (like >= 0 && rows[k].outline == rows[like].outline) {
      out.extent[k] = extent_of(clay, side, first + k);
      out.circle[k] = out.circle[like];
      distance[k] = distance[like];
      radius[k] = radius[like];
      tangent[k] = tangent[like];
      continue;
    }
    const body::Circle circle = rows[k].outline.circle();
    if (circle.radius <= 0.0) continue;
    out.extent[k] = extent_of(clay, side, first + k);
    out.circle[k] = circle;
    const double away = std::sqrt(circle.x * circle.x + circle.z * circle.z);
    distance[k] = static_cast<float>(away);
    radius[k] = static_cast<float>(circle.radius);
    tangent[k] = std::max(static_cast<float>(body::cross_section(away, circle.radius)), 0.0f);
    like = k;
  }
  kernels(clay.vectors()).half_windows(side, distance, radius, tangent, out.extent, out.half);
  for (int k = 0; k < count; ++k)
    if (!(radius[k] > 0.0f)) out.half[k] = -1.0f;
  return out;
}

// How many elements beyond the body's angles may be partly covered. It is half an element, as wide
// as at the face. Seen from the axis, that is a larger angle if the body is nearer the axis.
double margin_of(const Clay& clay, const SolidWindow& window, WallSide side, double face) {
  if (side == WallSide::inside || window.nearest >= face) return 0.5;
  return window.nearest * clay.sectors() > face ? 0.5 * face / window.nearest : clay.sectors();
}

// Finds the blocks at those angles, widened by `margin` elements. Returns the number of runs.
int blocks_within(const Clay& clay, const RowShape& shape, const body::Turn& turn, double margin,
                  BlockRun* ranges) {
  if (turn.half < 0.0) return 0;
  const double per_radian = clay.sectors() / (2.0 * portable::kPi);
  // Between minus one turn and plus one turn, because a hull's angle starts from a point in it.
  const double beyond = turn.middle * per_radian - 0.5;
  const double middle = beyond < 0.0 ? beyond + clay.sectors() : beyond;
  // One more element for rounding.
  const double reach = turn.half * per_radian + margin;
  return wrapped_blocks(shape, static_cast<int>(std::floor(middle - reach)),
                        static_cast<int>(std::floor(middle + reach)) + 1, ranges);
}

}  // namespace

SolidWindow::SolidWindow(const Clay& clay, const body::Heights& between, const body::Hull& hull,
                         const body::Approach& of, Vec3 at) noexcept
    : heights(between),
      // Rows whose middle the body misses may still be partly covered.
      first_row(std::max(clay.first_row_above(between.low) - 1, 0)),
      end_row(std::min(clay.first_row_above(between.high) + 1, clay.rows())),
      turn(body::turn_of(hull, at)),
      approach(of) {
  const body::AxisReach reach = body::reach_of(hull, at);
  // The ray of an element whose edge touches the body meets it a little nearer the axis.
  const double half_sector = portable::kPi / clay.sectors();
  slanting = 1.0 - 0.5 * half_sector * half_sector;
  nearest = reach.nearest * slanting;
  farthest = reach.farthest;
}

bool cover_row(const Clay& clay, const SolidWindow& window, WallSide side, int j,
               SolidReach& row) noexcept {
  row.used = 0;
  const double half = 0.5 * clay.row_thickness(j);
  const double low = std::max(clay.row_height(j) - half, window.heights.low);
  const double high = std::min(clay.row_height(j) + half, window.heights.high);
  row.share = static_cast<float>((high - low) / (2.0 * half));
  row.y = 0.5 * (low + high);
  if (high <= low) return false;
  if (side == WallSide::inside) return window.farthest >= double{clay.inner_least(j)};
  const double face = double{clay.outer_most(j)};
  return window.nearest <= face && window.approach.nearest(row.y) * window.slanting <= face;
}

void plan_rows(const Clay& clay, const SolidWindow& window, WallSide side, int first, int count,
               const bool* covered, SolidReach* rows) noexcept {
  const Circles circles = circles_of(clay, side, first, count, covered, rows);
  // Rows with the same cut of a rod share the angles of the row that reaches farthest, computed
  // once. One extra element costs less than the row's own arc tangents.
  const RowShape shape(clay);
  int like = -1;
  double margin = 0.0;  // elements beyond
  body::Turn both;
  body::Circle last;
  double angle = 0.0;
  for (int k = 0; k < count; ++k) {
    if (!circles.reaches(k)) continue;
    if (like < 0 || !(rows[k].outline == rows[like].outline)) {
      like = k;
      double most = double{circles.extent[k]};
      double widest = double{circles.half[k]};
      for (int n = k + 1; n < count; ++n) {
        if (!circles.reaches(n) || !(rows[n].outline == rows[k].outline)) continue;
        most = side == WallSide::outside ? std::max(most, double{circles.extent[n]})
                                         : std::min(most, double{circles.extent[n]});
        widest = std::max(widest, double{circles.half[n]});
      }
      const body::Circle& circle = circles.circle[k];
      if (circle.x != last.x || circle.z != last.z) {
        last = circle;
        angle = portable::atan2(circle.z, circle.x);
      }
      both =
          body::turn_of(rows[k].outline, side, most, body::overlap({angle, widest}, window.turn));
      margin = margin_of(clay, window, side, most);
    }
    rows[k].used = blocks_within(clay, shape, both, margin, rows[k].ranges);
  }
}

AlikeRows::AlikeRows(const body::Outline& of) noexcept : outline(of) {
  const body::Circle circle = of.circle();
  if (circle.radius <= 0.0) return;
  angle = portable::atan2(circle.z, circle.x);
  const double away = std::sqrt(circle.x * circle.x + circle.z * circle.z);
  distance = static_cast<float>(away);
  radius = static_cast<float>(circle.radius);
  tangent = std::max(static_cast<float>(body::cross_section(away, circle.radius)), 0.0f);
}

// Rows share the angles of the row that the body reaches farthest, computed once. One extra element
// costs less than the row's own arc tangents.
void plan_alike_rows(const Clay& clay, const SolidWindow& window, WallSide side,
                     const AlikeRows& alike, int first, int count, const bool* covered,
                     SolidReach* rows) noexcept {
  if (alike.radius <= 0.0f) return;
  float distance[kFew];
  float radius[kFew];
  float tangent[kFew];
  float extent[kFew] = {};
  float half[kFew];
  std::fill_n(distance, kFew, alike.distance);
  std::fill_n(radius, kFew, alike.radius);
  std::fill_n(tangent, kFew, alike.tangent);
  for (int k = 0; k < count; ++k)
    if (covered[k]) extent[k] = extent_of(clay, side, first + k);
  kernels(clay.vectors()).half_windows(side, distance, radius, tangent, extent, half);
  const bool outside = side == WallSide::outside;
  float farthest = outside ? 0.0f : 1e9f;
  float widest = -1.0f;
  for (int k = 0; k < count; ++k) {
    if (!covered[k] || half[k] < 0.0f) continue;
    farthest = outside ? std::max(farthest, extent[k]) : std::min(farthest, extent[k]);
    widest = std::max(widest, half[k]);
  }
  if (widest < 0.0f) return;
  const double most = double{farthest};
  const body::Turn both = body::turn_of(alike.outline, side, most,
                                        body::overlap({alike.angle, double{widest}}, window.turn));
  BlockRun ranges[2];
  const int used =
      blocks_within(clay, RowShape(clay), both, margin_of(clay, window, side, most), ranges);
  for (int k = 0; k < count; ++k) {
    if (!covered[k] || half[k] < 0.0f) continue;
    rows[k].used = used;
    rows[k].ranges[0] = ranges[0];
    rows[k].ranges[1] = ranges[1];
  }
}

}  // namespace onggi::contact
