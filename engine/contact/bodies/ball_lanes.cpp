#include "engine/contact/press_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

// A ball's section with a row is a circle. Every end E lies on the ball, so |H - E| is the radius
// and no normal needs a length. The row sums weight, and weight times E; H is added once.
struct BallLaw {
  using Body = body::Ball;
  static constexpr bool kPlain = true;
  static constexpr bool kEdges = false;

  struct Met : Meeting {
    Float8 half_chord;  // (H - E) . ray, m
  };

  struct Row {
    using Met = BallLaw::Met;
    Float8 section;     // radius of the row's circle; negative if there is none
    Float8 at_x, at_z;  // the circle's middle
    Float8 edge;  // farthest from the middle that the ray of a partly covered element may pass
    Float8 per_width, most_covered;
    Float8 above;  // H above the row, over the ball's radius
    Float8 squareness, slant, least_chord;

    ONGGI_INLINE Row(const BodyFigures<Body>& ball, const BodyRow<Body>& row)
        : section(all(ball.rows->section[row.k])),
          at_x(all(ball.x)),
          at_z(all(ball.z)),
          edge(all(ball.rows->edge[row.k])),
          per_width(all(ball.rows->per_width[row.k])),
          most_covered(all(ball.rows->most_covered[row.k])),
          above(all(ball.rows->above_radii[row.k])),
          squareness(all(ball.squareness)),
          slant(all(ball.slant * ball.rows->above_radii[row.k])),
          least_chord(all(ball.least_chord)) {}

    template <WallSide side, bool careful>
    ONGGI_INLINE void meet(Float8 c, Float8 s, Float8, Met& m) const {
      const Float8 along = at_x * c + at_z * s;
      const Float8 off = at_z * c - at_x * s;
      // Instead of r^2 - s^2: at a tangent ray the squares would cancel.
      const Float8 square = (section - off) * (section + off);
      m.half_chord = sqrt(larger(square, all(0.0f)));
      m.end = side == WallSide::outside ? along - m.half_chord : along + m.half_chord;
      m.hit = square > all(0.0f);
      if constexpr (!careful) return;
      const Float8 inside_edge = edge - abs(off);
      m.hit = inside_edge > all(0.0f);
      if constexpr (side == WallSide::outside) m.hit = m.hit & (along > all(0.0f));
      m.covered = smaller(inside_edge * per_width, most_covered);
    }
    // With w the face's own direction, one for the whole print, k_A l n A (n . w)(w . ray) / (n .
    // ray). On an upright face, where w is the ray, that is k_A l n A. On a face that leans it is
    // that law turned with the face: k_A l n A would push the ball along it, because elements are
    // weighed by the area that their rays see. On clay that has taken the ball's shape k_A l n A
    // would be right at any lean, and this leaves up to 4 % of the push along the face at a slope
    // of 0.5.
    ONGGI_INLINE void react(RowSum& sum, Float8 by_rays, Float8, const Met& m, Float8 c,
                            Float8 s) const {
      const Float8 facing = squareness - slant / larger(m.half_chord, least_chord);
      const Float8 weight = by_rays * larger(facing, all(0.0f));
      const Float8 out = weight * m.end;
      sum.weight = sum.weight + weight;
      sum.x = sum.x + out * c;
      sum.y = sum.y + weight * above;
      sum.z = sum.z + out * s;
    }
  };

  ONGGI_INLINE static void collect(const BodyFigures<Body>& ball, const RowSum& sum, float area,
                                   Reaction& total) {
    const Float8 weight = sum.weight * all(area);
    const Float8 share = all(area * ball.per_radius);
    total.normal = total.normal + weight;
    total.x = total.x + (weight * all(ball.x_radii) - sum.x * share);
    total.y = total.y + sum.y * all(area);
    total.z = total.z + (weight * all(ball.z_radii) - sum.z * share);
  }
};

}  // namespace

extern const contact::BodyKernel<body::Ball> kBall = Kernel<BallLaw>::kAll;

}  // namespace onggi::ONGGI_LANES
