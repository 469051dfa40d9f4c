#pragma once

#include <cstdint>
#include <string_view>

#include "engine/math/vec.h"

namespace onggi {

/// What a tool is to the eye and to the clay, whatever a potter calls it.
enum class BodyKind : std::uint8_t { ball, capsule, box, cylinder, wire };

/// One hand as it is seen: what it holds, where, and how. Plain values; studio frame, metres.
///   ball      of `radius` round `at`
///   capsule   of `radius` from `at`, `length` along
///   box       round `at`: `length` along, `thickness` across, 2 `radius` the third way
///   cylinder  round `at`: of `radius`, `thickness` across, which is its axis
///   wire      of `radius`, round `at`: `length` along
struct HandView {
  bool present = false;     ///< At the wheel; else nothing of it is seen.
  std::uint8_t tool = 0;    ///< HandInput::tool.
  std::string_view name{};  ///< The tool's, as in a scene's TOML; lives as long as the program.
  BodyKind body = BodyKind::ball;
  double radius = 0.0, length = 0.0, thickness = 0.0;
  Vec3 at;               ///< Middle of the working part.
  Vec3 along{0, 1, 0};   ///< Unit.
  Vec3 across{0, 0, 1};  ///< Unit, at a right angle to `along`.
};

}  // namespace onggi
