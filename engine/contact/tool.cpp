#include "engine/contact/tool.h"

#include <cmath>

#include "engine/math/portable.h"
#include "engine/math/unit.h"

namespace onggi {
namespace {

constexpr Vec3 kOut{1, 0, 0};
constexpr Vec3 kUp{0, 1, 0};
constexpr Vec3 kTurn{0, 0, 1};
constexpr double kHalfRoot3 = 0.86602540378443865;

// By name: scenes number tools in this order. Metres.
constexpr ToolShape kTools[] = {
    // A disc whose edge shapes the wall to its own curve. Held upright, edge on, inside or outside.
    {.name = "curved_rib",
     .body = BodyKind::cylinder,
     .usual = {.radius = 0.04, .thickness = 0.004},
     .least = {.radius = 0.01, .thickness = 0.001},
     .most = {.radius = 0.1, .thickness = 0.02},
     .hold = {.along = kUp, .across = kTurn},
     .smooths = true,
     .material = ToolMaterial::edge,
     .tray = 5,
     .drawing = "arc 9,12 9,10 -90 90; 9,2 9,22; arc 12.5,12 1.4,1.4 0 360"},
    // A finger's last joint, from the middle of its tip to the middle of the knuckle.
    {.name = "fingertip",
     .body = BodyKind::capsule,
     .usual = {.radius = 0.008, .length = 0.022},
     .least = {.radius = 0.003, .length = 0.001},
     .most = {.radius = 0.02, .length = 0.08},
     .hold = {.along = {0.5, kHalfRoot3, 0.0}, .across = kTurn},
     .tray = 2,
     .drawing = "9,22 9,8; arc 12,8 3,4 180 360; 15,8 15,22; arc 12,7.5 1.6,2.2 180 360"},
    // A thin plate of wood or steel. Upright with its face to the wall, it makes the wall straight.
    // On a still wheel it makes facets.
    {.name = "flat_rib",
     .body = BodyKind::box,
     .usual = {.radius = 0.02, .length = 0.09, .thickness = 0.003},
     .least = {.radius = 0.005, .length = 0.02, .thickness = 0.001},
     .most = {.radius = 0.06, .length = 0.25, .thickness = 0.02},
     .hold = {.along = kUp, .across = kOut},
     .smooths = true,
     .material = ToolMaterial::edge,
     .role = ToolRole::rib,
     .tray = 4,
     .drawing = "8,2 16,2 16,22 8,22 8,2; arc 12,6 1.4,1.4 0 360"},
    // A loop of ribbon, `thickness` wide, at the end of a handle. The clay within the loop comes
    // away with the clay that the ribbon cuts, so the clay meets a disc. It comes away at once.
    {.name = "loop_trimmer",
     .body = BodyKind::cylinder,
     .usual = {.radius = 0.008, .thickness = 0.003},
     .least = {.radius = 0.002, .thickness = 0.0005},
     .most = {.radius = 0.04, .thickness = 0.01},
     .hold = {.along = kOut, .across = kTurn},
     .relaxation = 0.2,
     .cuts = true,
     .material = ToolMaterial::edge,
     .role = ToolRole::trimmer,
     .tray = 6,
     .drawing = "arc 12,6 5,5 115.2 424.8; 10.2,10.6 11,13; 13.8,10.6 13,13; "
                "11,13 13,13 13,23 11,23 11,13"},
    // Incises lines and trims rims. It is thinner than most elements: an element yields by its
    // covered share, so a line is at least one element wide.
    {.name = "needle",
     .body = BodyKind::capsule,
     .usual = {.radius = 0.0006, .length = 0.06},
     .least = {.radius = 0.0002, .length = 0.005},
     .most = {.radius = 0.003, .length = 0.2},
     .hold = {.along = {0.8, 0.6, 0.0}, .across = kTurn},
     .relaxation = 0.2,
     .cuts = true,
     .material = ToolMaterial::edge,
     .tray = 7,
     .drawing = "12,1 12,12; 10.6,12 13.4,12 13.4,23 10.6,23 10.6,12"},
    // The soft side of a hand, laid on the wall: broad, so the wall stays even.
    {.name = "palm",
     .body = BodyKind::ball,
     .usual = {.radius = 0.018},
     .least = {.radius = 0.01},
     .most = {.radius = 0.05},
     .smooths = true,
     .role = ToolRole::outer_hand,
     .tray = 1,
     .drawing = "arc 12,15 6,7.5 0 180; 6,15 6,8; 18,15 18,9; arc 7.5,8 1.5,1.6 180 360; 9,8 9,5; "
                "arc 10.5,5 1.5,1.6 180 360; 12,5 12,12; arc 13.5,5 1.5,1.6 180 360; "
                "15,5 15,12; arc 16.5,8 1.5,1.6 180 360"},
    // The paper's own tool (Lee, Han & Choi 2008).
    {.name = "sphere",
     .body = BodyKind::ball,
     .usual = {.radius = 0.008},
     .least = {.radius = 0.001},
     .most = {.radius = 0.05},
     .tray = 8},
    // Softer than the clay. Wets what it touches.
    {.name = "sponge",
     .body = BodyKind::ball,
     .usual = {.radius = 0.03},
     .least = {.radius = 0.01},
     .most = {.radius = 0.05},
     .softness = 0.15,
     .wets = true,
     .smooths = true,
     .material = ToolMaterial::sponge,
     .tray = 3,
     .drawing = "arc 12,13 9.5,7.5 0 360; arc 8.5,11 1.2,1 0 360; arc 14,9.5 1.2,1 0 360; "
                "arc 12,15 1.2,1 0 360; arc 16.5,14 1,0.9 0 360"},
    // Taut between two hands.
    {.name = "wire",
     .body = BodyKind::wire,
     .usual = {.radius = 0.0005, .length = 0.4},
     .least = {.radius = 0.0001, .length = 0.1},
     .most = {.radius = 0.002, .length = 1.0},
     .hold = {.along = kTurn, .across = kUp},
     .cuts = true,
     .material = ToolMaterial::wire,
     .tray = 9,  // last, because it ends the pot
     .drawing = "3,8 3,16; 21,8 21,16; arc 12,12 9,2.4 180 0"},
};

// Calls `with` with the tool's body at `at`; a wire has only its middle.
template <class With>
auto with_body(BodyKind kind, const ToolPlace& at, const ToolSize& size, With with) {
  switch (kind) {
    case BodyKind::capsule:
      return with(body::Capsule{at.at, at.along, size.length, size.radius});
    case BodyKind::box:
      return with(body::Box{at.at,
                            {at.along, at.across, cross(at.along, at.across)},
                            {0.5 * size.length, 0.5 * size.thickness, size.radius}});
    case BodyKind::cylinder:
      return with(body::Cylinder(at.at, at.across, size.radius, 0.5 * size.thickness));
    case BodyKind::ball:
    case BodyKind::wire:
      break;
  }
  return with(body::Ball{at.at, size.radius});
}

}  // namespace

std::span<const ToolShape> tool_shapes() noexcept { return kTools; }

const ToolShape* find_tool_shape(std::string_view name) noexcept {
  for (const ToolShape& shape : kTools)
    if (shape.name == name) return &shape;
  return nullptr;
}

double ToolShape::reach(const ToolSize& size) const noexcept {
  switch (body) {
    case BodyKind::capsule:
      return size.length + size.radius;
    case BodyKind::box:
      return length(Vec3{0.5 * size.length, size.radius, 0.5 * size.thickness});
    case BodyKind::cylinder:
      return length(Vec2{size.radius, 0.5 * size.thickness});
    case BodyKind::wire:
      return 0.5 * size.length + size.radius;
    case BodyKind::ball:
      break;
  }
  return size.radius;
}

double ToolShape::smallest_feature(const ToolSize& size) const noexcept {
  return body == BodyKind::box || body == BodyKind::cylinder ? size.thickness : size.radius;
}

body::Ball ToolShape::within(const ToolPlace& place, const ToolSize& size,
                             Vec3 towards) const noexcept {
  return with_body(body, place, size,
                   [&](const auto& there) -> body::Ball { return there.within(towards); });
}

body::Ball ToolShape::support(const ToolPlace& place, const ToolSize& size,
                              Vec3 towards) const noexcept {
  return with_body(body, place, size,
                   [&](const auto& there) -> body::Ball { return there.support(towards); });
}

Press ToolShape::press(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
                       double seconds, const Yielding& yielding) const noexcept {
  if (severs()) return {};
  return with_body(body, place, size, [&](const auto& there) {
    return body::press(clay, side, there, place.at, seconds, yielding);
  });
}

double ToolShape::depth(const Clay& clay, WallSide side, const ToolPlace& place,
                        const ToolSize& size, std::int64_t& visited) const noexcept {
  if (severs()) return 0.0;
  return with_body(body, place, size, [&](const auto& there) {
    return body::depth(clay, side, there, place.at, visited);
  });
}

ToolSize sized(const ToolShape& shape, const ToolSize& size) noexcept {
  return {size.radius > 0.0 ? size.radius : shape.usual.radius,
          size.length > 0.0 ? size.length : shape.usual.length,
          size.thickness > 0.0 ? size.thickness : shape.usual.thickness};
}

ToolPlace hold_tool(const ToolShape& shape, Vec3 at, Vec3 handle, double roll,
                    bool inside) noexcept {
  const double away = axis_distance(at);
  const Vec3 out = away > 1e-9 ? Vec3{at.x / away, 0.0, at.z / away} : Vec3{1.0, 0.0, 0.0};
  const Vec3 turn{-out.z, 0.0, out.x};
  const auto to_studio = [&](Vec3 v) {
    return (inside ? -v.x : v.x) * out + Vec3{0.0, v.y, 0.0} + v.z * turn;
  };
  // A tool that leans would turn round as the hand crosses the axis. It stands upright there.
  constexpr double kLeansFrom = 0.008;  // m off the axis
  Vec3 leaning = shape.hold.along;
  if (leaning.y > 0.0) {
    const double t = std::min(away / kLeansFrom, 1.0);
    leaning.x *= t * t * (3.0 - 2.0 * t);
  }
  const Vec3 usual_along = unit(to_studio(leaning));
  const Vec3 usual_across = to_studio(shape.hold.across);
  const double reach = length(handle);
  const Vec3 along = reach > 1e-9 ? (1.0 / reach) * handle : usual_along;
  // The usual direction across, as nearly as the handle allows.
  Vec3 across = usual_across - dot(usual_across, along) * along;
  if (length(across) < 1e-3) across = usual_along - dot(usual_along, along) * along;
  across = unit(across);
  if (roll != 0.0)
    across = unit(portable::cos(roll) * across + portable::sin(roll) * cross(along, across));
  return {at, along, across};
}

}  // namespace onggi
