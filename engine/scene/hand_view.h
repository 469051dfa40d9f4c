#pragma once

#include <cstdint>
#include <string_view>

#include "engine/contact/bodies/body_kind.h"
#include "engine/math/vec.h"

namespace onggi {

namespace scene {
/// HandView::name of a paddle, which is held in place of a tool.
inline constexpr std::string_view kPaddle = "paddle";
}  // namespace scene

/// One hand for drawing: what it holds, where, and how. BodyKind says what the sizes mean. Plain
/// values; studio frame, metres.
struct HandView {
  bool present = false;     ///< At the wheel; otherwise nothing is drawn.
  std::uint8_t tool = 0;    ///< HandInput::tool.
  std::string_view name{};  ///< The tool's, as in a scene's TOML; lives as long as the program.
  BodyKind body = BodyKind::ball;
  double radius = 0.0, length = 0.0, thickness = 0.0;
  Vec3 at;               ///< Middle of the working part.
  Vec3 along{0, 1, 0};   ///< Unit.
  Vec3 across{0, 0, 1};  ///< Unit, at a right angle to `along`.
  friend bool operator==(const HandView&, const HandView&) = default;
};

}  // namespace onggi
