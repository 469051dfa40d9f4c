#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/contact/tool_contact.h"
#include "engine/contact/wire.h"
#include "engine/force/guard.h"
#include "engine/force/hand_velocity.h"
#include "engine/math/hash.h"
#include "engine/scene/hand_view.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// A tool that lies to hand; nothing of its size at 0.
struct Tool {
  const ToolShape* shape = nullptr;
  ToolSize size;
};
/// By HandInput::tool. Allocates.
std::vector<Tool> tools_of(const SceneDef& def);

/// One hand between ticks.
struct HandState {
  Vec3 at;                // last accepted place,
  Vec3 along, across;     // way of holding
  std::uint8_t tool = 0;  // and tool
  bool present = false;   // active, and its place known
  ToolContact contact;
  WireHand wire;
  force::Guard guard;
  force::HandVelocity velocity;  // kept where friction asks for it

  /// Takes a sample of an active hand, or holds the last one where it makes no sense: false. Then,
  /// if it is present, `sweep` is its way through the tick; angles and seconds are the caller's.
  bool take(const HandInput& in, std::span<const Tool> tools, ToolSweep& sweep) noexcept;
  /// The next good sample counts as an arrival: no sweep from where the hand was, no force yet.
  void leave() noexcept;
  void add_to(StateHash& hash, std::span<const Tool> tools) const;

 private:
  void hold_as(const HandInput& in, const Tool& tool, Vec3 to) noexcept;
};

/// `hand`, which holds `tool`, as it is seen.
HandView seen(const HandState& hand, const Tool& tool) noexcept;

}  // namespace onggi::scene
