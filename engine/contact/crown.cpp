#include "engine/contact/crown.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/clay/lip.h"
#include "engine/contact/ball_window.h"
#include "engine/contact/kernels.h"
#include "engine/math/portable.h"

namespace onggi::contact {
namespace {

struct Node {
  double at, weight;  // on -1..1
};
// Gauss-Legendre nodes and weights, for heights and for angles.
constexpr std::array<Node, 7> kLevels{{{-0.949107912342759, 0.129484966168870},
                                       {-0.741531185599394, 0.279705391489277},
                                       {-0.405845151377397, 0.381830050505119},
                                       {0.0, 0.417959183673469},
                                       {0.405845151377397, 0.381830050505119},
                                       {0.741531185599394, 0.279705391489277},
                                       {0.949107912342759, 0.129484966168870}}};
constexpr std::array<Node, 6> kAngles{{{-0.932469514203152, 0.171324492379170},
                                       {-0.661209386466265, 0.360761573048139},
                                       {-0.238619186083197, 0.467913934572691},
                                       {0.238619186083197, 0.467913934572691},
                                       {0.661209386466265, 0.360761573048139},
                                       {0.932469514203152, 0.171324492379170}}};
// On a face round about the axis, the wall's law gives a larger press outside and a smaller one
// inside than on a flat face, by this share of press over radius.
constexpr double kRoundness = 0.75;
constexpr double kFar = 1.0;  // m: distance of a face that is missing

// A level of the clay, between two rows.
struct Level {
  int below, above;
  double up;  // 0: at the row below, 1: at the row above

  double of(std::span<const float> low, std::span<const float> high, std::size_t i) const {
    return (1.0 - up) * double{low[i]} + up * double{high[i]};
  }
};
Level level_of(const Clay& clay, double y, int lowest) {
  const int above = std::clamp(clay.first_row_above(y), lowest, clay.rows() - 1);
  const int below = std::max(above - 1, lowest);
  if (above == below) return {above, above, 0.0};
  const double low = clay.row_height(below), high = clay.row_height(above);
  return {below, above, std::clamp((y - low) / (high - low), 0.0, 1.0)};
}

double arc_cosine(double cosine) {
  return 0.5 * portable::kPi - portable::asin(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

double pressure_at(double deep, double radius) noexcept {
  const double share = deep / radius;
  return radius * (portable::expm1(share) - share * share);
}

double push_on_flat(double depth, double radius) noexcept {
  if (!(depth > 0.0)) return 0.0;
  // Integral over the cap of press times the upward part of the normal. For a ball that is fully
  // sunk: the half ball's, plus the remaining depth on its disc.
  const double above = radius - std::min(depth, radius);
  const double cube = radius * radius * radius;
  const double half =
      2.0 * portable::kPi / radius *
      (0.25 * radius * cube - above * cube / 3.0 + above * above * above * above / 12.0);
  return half + std::max(depth - radius, 0.0) * 2.0 / 3.0 * portable::kPi * radius * radius;
}

EdgePush push_at_edge(const Clay& clay, WallSide side, Vec3 at, double radius, double top,
                      bool hollow) noexcept {
  EdgePush out;
  // From inside, the solid part belongs to the floor.
  const bool within = hollow && side == WallSide::inside;
  const int lowest = within ? clay.floor_rows() : 0;
  const double low = std::max(at.y - radius, within ? clay.floor_top() : 0.0);
  const double high = std::min(at.y + radius, top);
  if (high <= low) return out;
  const double d = axis_distance(at);
  const Vec3 away = d > 1e-9 ? Vec3{at.x / d, 0.0, at.z / d} : Vec3{1.0, 0.0, 0.0};
  const double turn = portable::atan2(at.z, at.x);
  const double per_radian = clay.sectors() / (2.0 * portable::kPi);
  // A tool that comes over the rim may leave the wall by its other face. A tool whose middle is
  // below the rim may not, or a deep press would pull it through the wall. In between, the other
  // face counts as this much farther away.
  const double kept = 2.0 * std::max(top + 0.25 * radius - at.y, 0.0);

  const bool outside = side == WallSide::outside;

  // Of a face that leans the way to it is shorter than the way along a ray.
  const BallWindow window(clay, at, radius);
  const auto square = [&](WallSide face) {
    const double slope = slope_beside(clay, window, face);
    return 1.0 / std::sqrt(1.0 + slope * slope);
  };
  const double square_outer = square(WallSide::outside);
  const double square_inner = hollow ? square(WallSide::inside) : 1.0;

  // Measured, because Clay::outer_most() stays wider than the row for some ticks after a press or
  // an undo, and nodes would lie elsewhere.
  const auto extent = [&, of = kernels(clay.vectors()).extent](WallSide face, const auto& row) {
    return of(face, clay.stride(), row.data());
  };

  constexpr int kParts = 2;
  for (int part = 0; part < kParts; ++part)
    for (const Node& node : kLevels) {
      const double half = 0.5 * (high - low) / kParts;
      const double y = low + (2 * part + 1 + node.at) * half;
      const double up = (at.y - y) / radius;  // of the normal, which points from surface to middle
      const double section = radius * std::sqrt(std::max((1.0 - up) * (1.0 + up), 0.0));
      const Level level = level_of(clay, y, lowest);
      const auto outers = std::array{clay.outer(level.below), clay.outer(level.above)};
      const auto inners = std::array{clay.inner(level.below), clay.inner(level.above)};
      // The part of the circle that may lie in clay, on both sides of the direction to the middle.
      // The face that counts as farther away does so here, too, and the other does not: else nodes
      // are spent where no clay is, and missing where some is.
      const double most =
          (outside ? 0.0 : kept) + double{std::max(extent(WallSide::outside, outers[0]),
                                                   extent(WallSide::outside, outers[1]))};
      double least = 0.0;
      if (hollow && !(outside && kept >= radius))
        least = double{std::min(extent(WallSide::inside, inners[0]),
                                extent(WallSide::inside, inners[1]))} -
                (outside ? kept : 0.0);
      const double sum = d * d + section * section, twice = std::max(2.0 * d * section, 1e-12);
      const double begin = arc_cosine((most * most - sum) / twice);
      const double end = least > 0.0 ? arc_cosine((least * least - sum) / twice) : portable::kPi;
      if (end <= begin) continue;
      for (const Node& angle : kAngles) {
        const double psi = 0.5 * (begin + end) + 0.5 * (end - begin) * angle.at;
        const double c = portable::cos(psi), s = portable::sin(psi);
        const double along = d + section * c, off = section * s;
        const double rho = std::sqrt(along * along + off * off);
        const double aside = portable::atan2(off, along);
        const double area = radius * half * node.weight * 0.5 * (end - begin) * angle.weight;
        for (const double sign : {-1.0, 1.0}) {
          // Interpolate between two sectors' rays.
          const double place = (turn + sign * aside) * per_radian - 0.5 + 2 * clay.sectors();
          const int whole = static_cast<int>(place);
          const double part_of = place - whole;
          const auto i = static_cast<std::size_t>(whole % clay.sectors());
          const auto k = static_cast<std::size_t>((whole + 1) % clay.sectors());
          const auto face = [&](const auto& rows) {
            return (1.0 - part_of) * level.of(rows[0], rows[1], i) +
                   part_of * level.of(rows[0], rows[1], k);
          };
          const double outer = face(outers);
          const double inner = hollow ? face(inners) : 0.0;
          const double from_outer = square_outer * (outer - rho);
          const double from_inner = hollow ? square_inner * (rho - inner) : kFar;
          const double to_top = top - y - lip_drop(inner, outer, std::min(rho, outer));
          const double to_face =
              std::min(from_outer + (outside ? 0.0 : kept), from_inner + (outside ? kept : 0.0));
          const double deep = std::min(to_face, to_top);
          if (deep <= 0.0) continue;
          // Only clay that a face pushes out counts as round: more outside, less inside.
          const double which =
              hollow ? std::clamp(2.0 * (from_inner - from_outer) / std::max(outer - inner, 1e-6),
                                  -1.0, 1.0)
                     : 1.0;
          const double by_face = to_top * to_top / (to_top * to_top + to_face * to_face);
          const double round = 1.0 + kRoundness * which * by_face * deep / std::max(rho, radius);
          const double push = pressure_at(deep, radius) * round * area;
          const double out_of = -section / radius * push;  // along the circle's own normal
          const Vec3 force = (out_of * c) * away + Vec3{-away.z * sign * s * out_of, up * push,
                                                        away.x * sign * s * out_of};
          out.face += by_face * force;
          out.face_normal += by_face * push;
          out.top += (1.0 - by_face) * force;
          out.top_normal += (1.0 - by_face) * push;
        }
      }
    }
  return out;
}

}  // namespace onggi::contact
