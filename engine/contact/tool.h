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

/// What a tool's working part is made of: how it is drawn, and what is heard when clay rubs on it.
enum class ToolMaterial : std::uint8_t {
  skin,    ///< A hand's.
  sponge,  ///< Porous and soft.
  edge,    ///< Of wood or metal, with a handle if its body is a capsule or it cuts.
  wire     ///< Taut.
};

/// What scripted hands and programs that help a visitor take a tool for. One tool has each.
enum class ToolRole : std::uint8_t {
  none,
  outer_hand,  ///< It supports the wall from outside.
  rib,         ///< It makes the wall even.
  trimmer      ///< It takes clay off the foot.
};

/// A potter's tool: a body and its use. One row of engine/contact/tool.cpp.
struct ToolShape {
  std::string_view name;  ///< As in a scene's TOML: "sphere".
  BodyKind body = BodyKind::ball;
  ToolSize usual;        ///< Its size where a ToolSize has 0. A tool without a length has 0 here.
  ToolSize least, most;  ///< How small and how large it may be made; at least 0.0001 where it has
                         ///< that size at all.
  Hold hold{};           ///< The usual grip of a potter.
  double softness =
      1.0;  ///< Share of a press that the clay takes up, 0..1; a sponge takes the rest.
  double relaxation =
      1.0;               ///< Its clay's relaxation time, as a share: an edge cuts at once. 0.1..1
  bool cuts = false;     ///< It removes clay instead of pushing it aside.
  bool wets = false;     ///< It brings water to the clay it touches.
  bool smooths = false;  ///< It smooths the wall that it passes, if the scene has that effect.

  ToolMaterial material = ToolMaterial::skin;
  ToolRole role = ToolRole::none;
  int tray = 0;  ///< Its place beside the wheel, the smallest first: the order of use.
  /// Its drawing there: strokes in a square of 24, y down; "9,22 9,8; arc 12,8 3,4 180 360"
  /// (kiosk/visit/screens/pen_strokes.h).
  std::string_view drawing{};

  bool round() const { return body == BodyKind::ball; }  ///< Its orientation does not matter.
  bool severs() const { return body == BodyKind::wire; }

  /// Largest distance of any part from `at`, m.
  double reach(const ToolSize& size) const noexcept;
  /// Its finest part, m, > 0: in one step it goes at most a quarter of that.
  double smallest_feature(const ToolSize& size) const noexcept;
  /// The ball in it that stands for it above the rim and the floor: none of it lies outside the
  /// tool, so that a tool that touches nothing feels nothing; and none of its kind lies farther
  /// `towards` (unit).
  body::Ball within(const ToolPlace& place, const ToolSize& size, Vec3 towards) const noexcept;
  /// Its farthest point `towards` (unit) is this ball's: where it touches the wheel head, and where
  /// clay rubs on it.
  body::Ball support(const ToolPlace& place, const ToolSize& size, Vec3 towards) const noexcept;

  /// body::press() and body::depth() of what it is there. A wire presses nothing.
  Press press(Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
              double seconds, const Yielding& yielding) const noexcept;
  double depth(const Clay& clay, WallSide side, const ToolPlace& place, const ToolSize& size,
               std::int64_t& visited) const noexcept;
};

/// All tools, by name.
std::span<const ToolShape> tool_shapes() noexcept;
/// Null if there is no tool of that name.
const ToolShape* find_tool_shape(std::string_view name) noexcept;

/// `size` with the shape's usual figures in place of 0.
ToolSize sized(const ToolShape& shape, const ToolSize& size) noexcept;

/// A tool at `at` (studio frame) with its handle towards `handle`, turned about it by `roll` (rad);
/// without a handle (0, 0, 0) as the shape is usually held, by the angle of `at` about the axis.
/// `inside`: it works the inner face.
ToolPlace hold_tool(const ToolShape& shape, Vec3 at, Vec3 handle, double roll,
                    bool inside) noexcept;

}  // namespace onggi
