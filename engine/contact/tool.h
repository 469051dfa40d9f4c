#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/clay/clay.h"
#include "engine/contact/wall_side.h"
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

/// How the clay gives way and pushes back.
struct Yielding {
  double relaxation_time = 0;  ///< tau, s, > 0.
  double stiffness = 0;        ///< k_A, N per metre of press and m^2 of wall.
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
  ToolSize usual;         ///< Its size where a ToolSize has 0.
  double softness = 1.0;  ///< Its stiffness against the clay's, 0..1: a sponge gives way itself.
  double (*reach)(const ToolSize& size);  ///< Nothing of it is farther from `at`, m.

  /// Presses the tool on the `side` face for one step of `seconds` (> 0) and lets the clay give
  /// way: Lee, Han & Choi 2008, eqs. 3-9, corrected (engine/docs/contact.md). `place` is the tool's
  /// in the middle of the step; it moves at most about a quarter of its radius in one. Marks dirty
  /// rows. No allocation. Equal bits on every machine.
  Press (*press)(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
                 double seconds, const Yielding& yielding);

  /// How deep the tool at rest would press the `side` face: the deepest element, metres, 0 when
  /// clear. Changes nothing. `visited` grows by the elements looked at.
  double (*depth)(const Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
                  std::int64_t& visited);
};

/// Every shape there is, by name.
std::span<const ToolShape* const> tool_shapes();
/// Null where there is none of that name.
const ToolShape* find_tool_shape(std::string_view name);

}  // namespace onggi
