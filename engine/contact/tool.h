#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi {

/// How large a tool is. What each figure means is the tool's own (engine/docs/tools.md); 0 stands
/// for the tool's usual size. Metres.
struct ToolSize {
  double radius = 0.0;     ///< Of the working edge or tip.
  double length = 0.0;     ///< Along the tool.
  double thickness = 0.0;  ///< Across it.
};

/// Where a tool is during one step, and how it is held. In the clay's turning frame.
struct ToolPlace {
  Vec3 at;               ///< Middle of the tool's working part, m.
  Vec3 along{0, 1, 0};   ///< Direction of the tool's length; unit.
  Vec3 across{0, 0, 1};  ///< Direction of its thickness; unit, at a right angle to `along`.
};

/// How a tool is held: directions by the hand's place. x away from the axis (inside the pot,
/// towards it), y up, z with the wheel's turn; unit, at right angles.
struct Hold {
  Vec3 along{0, 1, 0};
  Vec3 across{0, 0, 1};
};

/// The ball that stands for a tool where only its farthest point one way counts.
struct ToolBall {
  Vec3 middle;        ///< m
  double radius = 0;  ///< m, > 0.
};

/// How the clay gives way and pushes back.
struct Yielding {
  double relaxation_time = 0;  ///< tau, s, > 0.
  double stiffness = 0;        ///< k_A, N per metre of press and m^2 of wall.
  double along = 0;  ///< Share of the area that a pressed face loses with which the other face goes
                     ///< along, 0..1: 1 moves the wall, 0 thins it. Only where the clay keeps its
                     ///< rows' areas (Clay::keep_areas).
  bool cut = false;  ///< What is pressed away is gone, not displaced; only there, too.
};

/// What one step of pressing came to.
struct Press {
  Vec3 force;                ///< On the tool, clay frame, mean over the step, N.
  double normal = 0;         ///< Sum of the elements' normal forces, N; friction is made of it.
  double depth = 0;          ///< Deepest press, m.
  std::int64_t visited = 0;  ///< Elements looked at.
  std::int64_t touched = 0;  ///< Elements pressed.
};

/// One shape of tool: what it is called, its usual size, and how it presses. Each stands in one
/// file of engine/contact/tools, which tells how it meets a row (engine/docs/tools.md).
struct ToolShape {
  std::string_view name;  ///< As in a scene's TOML: "sphere".
  ToolSize usual;         ///< Its size where a ToolSize has 0. A tool without a length has 0 here.
  ToolSize least, most;   ///< How small and how large it may be made; at least 0.0001 where it has
                          ///< that size at all.
  Hold hold{};            ///< As a potter holds it.
  bool round = false;     ///< A ball: how it is held is all one.
  double softness =
      1.0;  ///< Share of a press that the clay takes up, 0..1; a sponge takes the rest.
  double relaxation =
      1.0;               ///< Its clay's relaxation time, as a share: an edge cuts at once. 0.1..1
  bool cuts = false;     ///< What it takes away is gone, not pushed aside.
  bool wets = false;     ///< It brings water to the clay it touches.
  bool smooths = false;  ///< It evens the wall that it goes along, where there is the effect.
  bool severs = false;   ///< It presses nothing, and cuts the pot from the wheel (wire.h).
  double (*reach)(const ToolSize& size);  ///< Nothing of it is farther from `at`, m.
  double (*grain)(const ToolSize& size);  ///< Its finest part, m, > 0: in one step it goes at most
                                          ///< a quarter of that.
  /// Its farthest point `towards` (unit) is this ball's: above the rim and the floor, where it
  /// touches the wheel head, and where clay rubs on it.
  ToolBall (*ball)(const ToolPlace& place, const ToolSize& size, Vec3 towards);

  /// Presses the tool on the `side` face for one step of `seconds` (> 0) and lets the clay give
  /// way: Lee, Han & Choi 2008, eqs. 3-9, corrected (engine/docs/contact.md). `place` is the tool's
  /// in the middle of the step; it moves at most about a quarter of its grain in one. Marks dirty
  /// rows. No allocation. Equal bits on every machine.
  Press (*press)(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
                 double seconds, const Yielding& yielding);

  /// How deep the tool at rest would press the `side` face: the deepest element, metres, 0 when
  /// clear. Changes nothing. `visited` grows by the elements looked at.
  double (*depth)(const Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
                  std::int64_t& visited);
};

/// shape.ball(), without the call where the tool is a ball.
inline ToolBall ball_towards(const ToolShape& shape, const ToolPlace& place, const ToolSize& size,
                             Vec3 towards) {
  if (shape.round) return {place.at, size.radius};
  return shape.ball(place, size, towards);
}

/// Every shape there is, by name.
std::span<const ToolShape* const> tool_shapes();
/// Null where there is none of that name.
const ToolShape* find_tool_shape(std::string_view name);

/// `size` with the shape's usual figures where it has 0.
ToolSize sized(const ToolShape& shape, const ToolSize& size) noexcept;

/// A tool at `at` (studio frame) with its handle towards `handle`, turned about it by `roll` (rad);
/// without a handle (0, 0, 0) as the shape is usually held, by the angle of `at` about the axis.
/// `inside`: it works the inner face.
ToolPlace hold_tool(const ToolShape& shape, Vec3 at, Vec3 handle, double roll,
                    bool inside) noexcept;

}  // namespace onggi
