#include "engine/contact/tool_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/clay/lip.h"
#include "engine/contact/crown.h"
#include "engine/contact/floor.h"
#include "engine/contact/rim.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

// `p` turned about the axis, from x towards z, by the angle with cosine `c` and sine `s`.
Vec3 turned(Vec3 p, double c, double s) { return {c * p.x - s * p.z, p.y, s * p.x + c * p.z}; }

// The wall's faces at the tool's height (the top row if above the rim) and angle. Clay frame.
struct WallThere {
  double outer, inner;
};

// Distance of a point beyond the rim's crown, the outer face and the inner face, m. The largest
// shows where the point is out of the wall, or nearest to being out.
struct Beyond {
  double crown, outer, inner;
};

WallThere wall_at(const Clay& clay, Vec3 at) {
  const int row = std::clamp(clay.first_row_above(at.y), 0, clay.rows() - 1);
  const double turns = portable::atan2(at.z, at.x) / (2.0 * portable::kPi);
  const int sector = static_cast<int>(std::floor(turns * clay.sectors())) + clay.sectors();
  const auto i = static_cast<std::size_t>(sector % clay.sectors());
  return {double{clay.outer(row)[i]}, double{clay.inner(row)[i]}};
}

Beyond beyond(const Clay& clay, Vec3 at) {
  const WallThere wall = wall_at(clay, at);
  const double d = axis_distance(at);
  return {at.y - clay.rim_height(), d - wall.outer, wall.inner - d};
}

constexpr Vec3 kDown{0.0, -1.0, 0.0};

// The tool's place at `share` (0..1) of the sweep, in a frame turned by the angle with cosine `c`
// and sine `s`.
ToolPlace place_at(const ToolSweep& sweep, double share, double c, double s) {
  ToolPlace place{turned(sweep.from + share * (sweep.to - sweep.from), c, -s)};
  if (!sweep.shape->round()) {
    place.along = turned(sweep.along, c, -s);
    place.across = turned(sweep.across, c, -s);
  }
  return place;
}

// The ball that represents the tool above the rim and the floor, in step `n` of `of`.
BallStep ball_step(const ToolSweep& sweep, int n, int of) {
  const auto lowest = [&](double share) {
    const double angle = sweep.angle_from + share * (sweep.angle_to - sweep.angle_from);
    const ToolPlace place = place_at(sweep, share, portable::cos(angle), portable::sin(angle));
    return sweep.shape->within(place, sweep.size, kDown);
  };
  const body::Ball from = lowest(1.0 * n / of);
  return {from.middle, lowest((n + 1.0) / of).middle, from.radius, sweep.seconds / of};
}

// How the clay yields under this tool. A soft tool is a spring in front of the clay, and the clay
// gets the share `softness` of the press. So the force is that much smaller, and the clay takes
// that much longer to yield.
Yielding yielding_under(const ToolShape& shape, const Yielding& clay) {
  return {clay.relaxation_time * shape.relaxation / shape.softness, clay.stiffness * shape.softness,
          shape.cuts ? 0.0 : clay.along, shape.cuts};
}

// Above the crown, and nearer straight up than the bisector of the rim's corners.
bool over_rim(const Beyond& b) { return b.crown > 0.0 && b.crown >= std::max(b.outer, b.inner); }

// Share of a round tool's force that the edge gives, 0..1. It is 1 where the tool's print comes so
// near the rim that clay is nearer to the crown than to the face, and fades to 0 over 2 mm below.
double edge_share(double above_middle, double radius, double depth) {
  constexpr double kFade = 0.002;  // m
  const double print = std::sqrt(depth * std::max(2.0 * radius - depth, 0.0));
  return std::clamp(1.0 + (print + depth + kLipRadius - above_middle) / kFade, 0.0, 1.0);
}

// Distance from the axis to the clay that `sweep`'s tool presses, m. Clay deep beside a tool is
// farther away than the tool's nearest point to the axis, but never by half.
double clay_distance(const ToolSweep& sweep, std::optional<WallSide> pressed) {
  const double out = std::max(axis_distance(sweep.from), axis_distance(sweep.to));
  const BodyKind body = sweep.shape->body;
  if (!pressed || (body != BodyKind::ball && body != BodyKind::capsule)) return out;
  return *pressed == WallSide::outside ? std::max(out - sweep.size.radius, 0.5 * out)
                                       : out + sweep.size.radius;
}

// Length of the tool that turning clay passes over, m: usually the smallest feature. A flat rib
// that lies on the outside with its face meets clay as a fingertip does, unless an edge is nearer
// to the place where the face is nearest to the axis.
double passed_over(const ToolSweep& sweep, std::optional<WallSide> pressed) {
  const double smallest = sweep.shape->smallest_feature(sweep.size);
  if (sweep.shape->body != BodyKind::box || pressed != WallSide::outside) return smallest;
  const Vec3 wide = cross(sweep.along, sweep.across);
  const auto to_edge = [&](Vec3 at) {
    return sweep.size.radius - std::fabs(at.x * wide.x + at.z * wide.z) -
           0.5 * sweep.size.length * std::fabs(wide.y);
  };
  const double edge = std::min(to_edge(sweep.from), to_edge(sweep.to));
  return std::max(smallest, std::min(edge, body::kBluntestEdge));
}

}  // namespace

int steps_for(const ToolSweep& sweep, double relaxation_time,
              std::optional<WallSide> pressed) noexcept {
  const double way = length(sweep.to - sweep.from);
  const double arc = std::fabs(sweep.angle_to - sweep.angle_from) * clay_distance(sweep, pressed);
  const double by_way = way / (0.25 * sweep.shape->smallest_feature(sweep.size)) +
                        arc / (0.125 * passed_over(sweep, pressed));
  const double by_time = sweep.seconds / (0.25 * relaxation_time * sweep.shape->relaxation);
  return static_cast<int>(
      std::clamp(std::ceil(std::max(by_way, by_time)), 1.0, double{kMostSteps}));
}

bool ToolContact::choose_place(const Clay& clay, const ToolPlace& place, const body::Ball& lowest,
                               const ToolSweep& sweep) noexcept {
  const Vec3 at = lowest.middle;
  const double radius = lowest.radius;
  on_rim_ = on_floor_ = false;
  const WallThere wall = wall_at(clay, at);
  const double d = axis_distance(at);
  const bool beside_wall = at.y < clay.rim_height() && (d > wall.outer || d < wall.inner);
  const bool by_position = beside_wall || sweep.wish == SideWish::by_position;
  const bool nearer = d < 0.5 * (wall.outer + wall.inner);
  const bool inside = by_position ? nearer : sweep.wish == SideWish::inside;
  side_ = inside ? WallSide::inside : WallSide::outside;

  const bool on_floor = at.y - radius < clay.floor_top();
  if (over_rim(beyond(clay, at))) {
    // A solid lump is opened in its middle. Elsewhere its top counts as a rim.
    const bool solid = clay.floor_rows() == clay.rows();
    on_rim_ = !(on_floor && nearer);
    if (solid && !on_rim_) side_ = WallSide::inside;
    return on_rim_ ? at.y - radius < clay.rim_height() : on_floor;
  }
  const auto depth = [&](WallSide side) {
    return sweep.shape->depth(clay, side, place, sweep.size, sum_.visited);
  };
  const double here = depth(side_);
  const bool floor_there = on_floor && side_ == WallSide::inside;
  if (beside_wall || here <= radius) return here > 0.0 || floor_there;
  // Over the rim or within the wall, and deep at first touch: the tool came along the other face.
  // Choosing this face would cut the whole wall away.
  const double there = depth(other(side_));
  if (there < here) side_ = other(side_);
  return there > 0.0 || floor_there;
}

void ToolContact::change_place(const Clay& clay, const body::Ball& lowest) noexcept {
  const Vec3 at = lowest.middle;
  if (!on_rim_ && at.y <= clay.rim_height()) return;
  const Beyond b = beyond(clay, at);
  const double band =
      0.1 * lowest.radius;  // stops a tool that trembles at a corner from flickering between sides
  if (on_rim_) {
    if (b.outer > std::max(0.0, b.crown + band)) {
      on_rim_ = false;
      side_ = WallSide::outside;
    } else if (b.inner > std::max(0.0, b.crown + band)) {
      on_rim_ = false;
      side_ = WallSide::inside;
    }
  } else if (b.inner > b.crown && side_ == WallSide::outside) {
    side_ = WallSide::inside;  // carried across the wall in one step
  } else if (b.outer > b.crown && side_ == WallSide::inside) {
    side_ = WallSide::outside;
  } else {
    // In a hole that is being opened, the tool stays on the floor.
    on_rim_ = !on_floor_ && b.crown > std::max(b.outer, b.inner) + band;
  }
}

namespace {

// The floor ends where the clay ends. A ball near the clay's outer edge feels the edge, and a ball
// beyond it feels nothing.
Press press_on_floor(Clay& clay, const BallStep& step, const body::Ball& ball,
                     const Yielding& yielding) {
  const int row = std::max(clay.floor_rows() - 1, 0);
  const double whole = double{*std::ranges::min_element(clay.outer(row))} - ball.radius;
  constexpr double kFade = 0.002;  // m
  const double share =
      std::min((axis_distance(ball.middle) - whole + kLipRadius) / kFade + 1.0, 1.0);
  if (share <= 0.0) return press_floor(clay, step, yielding);
  const contact::EdgePush edge = contact::push_at_edge(clay, WallSide::outside, ball.middle,
                                                       ball.radius, clay.floor_top(), false);
  if (edge.top_normal + edge.face_normal <= 0.0) return {};
  Press press = press_floor(clay, step, yielding);
  const double stiffness = share * yielding.stiffness;
  press.force = (1.0 - share) * press.force + stiffness * (edge.top + edge.face);
  press.normal = (1.0 - share) * press.normal + stiffness * (edge.top_normal + edge.face_normal);
  return press;
}

// The wall's sum, k_A l n A, ends where its rows end: outside at the wheel head, inside at the
// floor. A ball that this end cuts is pushed across it by less than its push grows along the wall,
// so a path that goes in above the end and out over it would gain. What lacks is a pull down: the
// cut's depth cubed over 6 R, added up along the cut. m^3. `above`: the ball's middle over the end.
// `bend`: of the face, 1/m, > 0 outside.
double pull_across_end(double radius, double depth, double above, double bend) {
  const double square = (radius - above) * (radius + above);
  if (!(square > 0.0)) return 0.0;
  // From the middle to the face. Where the middle is below the end, the cut is the deepest place.
  const double nearest = std::max((above < 0.0 ? std::sqrt(square) : radius) - depth, 0.0);
  const double half = square - nearest * nearest;  // of the cut, squared
  if (!(half > 0.0)) return 0.0;
  constexpr std::array<double, 4> kAt{0.069431844202974, 0.330009478207572, 0.669990521792428,
                                      0.930568155797026};
  constexpr std::array<double, 4> kWeight{0.173927422568727, 0.326072577431273, 0.326072577431273,
                                          0.173927422568727};
  double sum = 0.0;
  for (std::size_t n = 0; n < kAt.size(); ++n) {
    const double deep = std::sqrt(square - half * kAt[n] * kAt[n]) - nearest;
    sum += kWeight[n] * deep * deep * deep;
  }
  // A round face meets the ball in a narrower print, or in a wider one inside.
  return sum * std::sqrt(half / std::max(1.0 + radius * bend, 0.25)) / (3.0 * radius);
}

// Replaces `share` (0..1) of `press`'s force by `edge`'s. Returns the part that is not on a face.
// The part on a face fades during the step as the wall's press does.
contact::FacePush feel_edge(const contact::EdgePush& edge, double share, double seconds,
                            const Yielding& yielding, Press& press) {
  if (share == 0.0) return {};
  const double rate = yielding.relaxation_time / seconds;
  const double on_face = share * yielding.stiffness * rate * -portable::expm1(-1.0 / rate);
  const double off_face = share * yielding.stiffness;
  const contact::FacePush rest{off_face * edge.top, off_face * edge.top_normal};
  press.force = (1.0 - share) * press.force + on_face * edge.face + rest.force;
  press.normal = (1.0 - share) * press.normal + on_face * edge.face_normal + rest.normal;
  return rest;
}

}  // namespace

void ToolContact::step(Clay& clay, const ToolSweep& sweep, int n, int of,
                       const Yielding& clays) noexcept {
  const Yielding yielding = yielding_under(*sweep.shape, clays);
  const double middle = (n + 0.5) / of;
  const double angle = sweep.angle_from + middle * (sweep.angle_to - sweep.angle_from);
  const double c = portable::cos(angle);
  const double s = portable::sin(angle);
  const ToolPlace place = place_at(sweep, middle, c, s);
  const body::Ball lowest = sweep.shape->within(place, sweep.size, kDown);

  // Of a wall that leans the edge may be felt beside the last element that is pressed.
  const bool near = touching_ || choose_place(clay, place, lowest, sweep);
  if (touching_) change_place(clay, lowest);
  // Over the edge and near it, one law gives a round tool's force, whichever part moves the clay.
  // A solid lump's top is a floor in its middle.
  const double above = clay.rim_height() - place.at.y;
  const bool hollow = clay.floor_rows() < clay.rows();
  const bool at_edge = sweep.shape->round() && above < 2.5 * lowest.radius + kLipRadius &&
                       (hollow || on_rim_ || side_ == WallSide::outside);
  contact::EdgePush edge;
  if (at_edge)
    edge = contact::push_at_edge(clay, hollow ? side_ : WallSide::outside, place.at, lowest.radius,
                                 clay.rim_height(), hollow);
  if (!near && edge.top_normal + edge.face_normal <= 0.0) return;

  Press press;
  contact::FacePush off_face;
  on_floor_ = false;
  const double seconds = sweep.seconds / of;
  if (on_rim_) {
    press = press_rim(clay, ball_step(sweep, n, of), yielding);
    face_depth_ = std::max(face_depth_, press.depth);
    off_face = at_edge ? feel_edge(edge, 1.0, seconds, yielding, press)
                       : contact::FacePush{press.force, press.normal};
  } else {
    press = sweep.shape->press(clay, side_, place, sweep.size, seconds, yielding);
    if (at_edge)
      off_face =
          feel_edge(edge, edge_share(above, lowest.radius, press.depth), seconds, yielding, press);
    if (sweep.shape->round() && press.touched > 0) {
      const bool outside = side_ == WallSide::outside;
      const double gap = press.depth - lowest.radius;
      const double face = std::max(axis_distance(place.at) + (outside ? gap : -gap), lowest.radius);
      const double pull = pull_across_end(lowest.radius, press.depth,
                                          place.at.y - (outside ? 0.0 : clay.floor_top()),
                                          (outside ? 1.0 : -1.0) / face);
      if (pull > 0.0) {
        const double rate = yielding.relaxation_time / seconds;
        press.force.y -= yielding.stiffness * rate * -portable::expm1(-1.0 / rate) * pull;
      }
    }
    face_depth_ = std::max(face_depth_, press.depth);
    const double hangs = place.at.y - (lowest.middle.y - lowest.radius);  // below `at`
    const double bottom = std::min(sweep.from.y, sweep.to.y) - hangs;
    if (side_ == WallSide::inside && bottom < clay.floor_top()) {
      const Press floor = press_on_floor(clay, ball_step(sweep, n, of), lowest, yielding);
      on_floor_ = floor.touched > 0;
      press.force += floor.force;
      press.normal += floor.normal;
      press.depth = std::max(press.depth, floor.depth);
      press.visited += floor.visited;
      press.touched += floor.touched;
      off_face.force += floor.force;
      off_face.normal += floor.normal;
    }
  }
  if (press.normal > 0.0) press.touched = std::max<std::int64_t>(press.touched, 1);
  touching_ = press.touched > 0;
  const double share = 1.0 / of;
  sum_.force += share * turned(press.force, c, s);
  sum_.normal += share * press.normal;
  sum_.depth = std::max(sum_.depth, press.depth);
  sum_.visited += press.visited;
  sum_.touched += press.touched;
  if (off_face.normal == 0.0) return;
  off_face_.force += share * turned(off_face.force, c, s);
  off_face_.normal += share * off_face.normal;
}

}  // namespace onggi
