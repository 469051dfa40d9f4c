#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/body_kind.h"
#include "engine/contact/press.h"
#include "engine/math/vec.h"

namespace onggi {

/// The size of a tool. The meaning of each figure depends on its body (BodyKind); 0 means the
/// tool's usual size. Metres.
struct ToolSize {
  double radius = 0.0;     ///< Of the working edge or tip.
  double length = 0.0;     ///< Along the tool.
  double thickness = 0.0;  ///< Across it.
};

/// The position of a tool during one step, and its orientation. In the clay's turning frame.
struct ToolPlace {
  Vec3 at;               ///< Centre of the working part, m.
  Vec3 along{0, 1, 0};   ///< Direction of the tool's length; unit.
  Vec3 across{0, 0, 1};  ///< Direction of the tool's thickness; unit, at a right angle to `along`.
};

/// How a tool is held, in directions relative to the hand's place: x away from the axis (inside the
/// pot, towards it), y up, z with the wheel's turn. Unit, at right angles.
struct Hold {
  Vec3 along{0, 1, 0};
  Vec3 across{0, 0, 1};
};

/// What a tool's working part is made of. It decides how the tool is drawn and how clay sounds on
/// it.
enum class ToolMaterial : std::uint8_t {
  skin,    ///< A hand.
  sponge,  ///< Porous and soft.
  edge,    ///< Wood or metal; with a handle if its body is a capsule or it cuts.
  wire     ///< Taut.
};

/// The use of a tool for scripted hands and for programs that help a visitor. One tool has each.
enum class ToolRole : std::uint8_t {
  none,
  outer_hand,  ///< Supports the wall from outside.
  rib,         ///< Evens the wall.
  trimmer      ///< Takes clay off the foot.
};

/// A potter's tool: a body and its use. One row of engine/contact/tool.cpp.
struct ToolShape {
  std::string_view name;  ///< As in a scene's TOML: "sphere".
  BodyKind body = BodyKind::ball;
  ToolSize usual;        ///< Replaces a 0 in a ToolSize. 0 if the tool has no such size.
  ToolSize least, most;  ///< Range of sizes; at least 0.0001 for a size that the tool has.
  Hold hold{};           ///< A potter's usual grip.
  /// Share of a press that the clay takes, 0..1. The tool takes the rest (sponge).
  double softness = 1.0;
  /// Factor on the clay's relaxation time under it, 0.1..1: an edge cuts at once.
  double relaxation = 1.0;
  bool cuts = false;     ///< Removes clay instead of pushing it aside.
  bool wets = false;     ///< Brings water to the clay it touches.
  bool smooths = false;  ///< Smooths the wall that it passes, if the scene has that effect.

  ToolMaterial material = ToolMaterial::skin;
  ToolRole role = ToolRole::none;
  int tray = 0;  ///< Order beside the wheel, smallest first: the order of use.
  /// Its drawing beside the wheel: strokes in a square of 24, y down; "9,22 9,8; arc 12,8 3,4 180
  /// 360" (kiosk/visit/screens/pen_strokes.h).
  std::string_view drawing{};

  bool round() const { return body == BodyKind::ball; }  ///< Its orientation does not matter.
  bool severs() const { return body == BodyKind::wire; }

  /// Largest distance of any part from `at`, m.
  double reach(const ToolSize& size) const noexcept;
  /// Its finest part, m, > 0. A step moves the tool at most a quarter of that.
  double smallest_feature(const ToolSize& size) const noexcept;
  /// The ball inside the tool that lies farthest `towards` (unit). It represents the tool above the
  /// rim and the floor. It lies wholly inside, so a tool that touches nothing feels nothing.
  body::Ball within(const ToolPlace& place, const ToolSize& size, Vec3 towards) const noexcept;
  /// The ball at the tool's farthest point `towards` (unit): where it touches the wheel head, and
  /// where clay rubs on it.
  body::Ball support(const ToolPlace& place, const ToolSize& size, Vec3 towards) const noexcept;

  /// body::press() and body::depth() of the tool's body at `place`. A wire presses nothing.
  Press press(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
              double seconds, const Yielding& yielding) const noexcept;
  double depth(const Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
               std::int64_t& visited) const noexcept;
};

/// All tools, by name.
std::span<const ToolShape> tool_shapes() noexcept;
/// Null if there is no tool of that name.
const ToolShape* find_tool_shape(std::string_view name) noexcept;

/// `size` with each 0 replaced by the shape's usual figure.
ToolSize sized(const ToolShape& shape, const ToolSize& size) noexcept;

/// A tool at `at` (studio frame) with its handle towards `handle`, turned about the handle by
/// `roll` (rad). If `handle` is (0, 0, 0), the shape's usual grip is turned to the angle of `at`
/// about the axis. `inside`: it works the inner face. A grip that leans stands up within 8 mm of
/// the axis, so that it does not turn round there.
ToolPlace hold_tool(const ToolShape& shape, Vec3 at, Vec3 handle, double roll,
                    bool inside) noexcept;

}  // namespace onggi
