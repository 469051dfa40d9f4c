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

/// A tool of the scene, with all sizes filled in.
struct Tool {
  const ToolShape* shape = nullptr;
  ToolSize size;
};
/// The tools by HandInput::tool. Allocates.
std::vector<Tool> tools_of(const SceneDef& def);

/// One hand between ticks.
struct HandState {
  Vec3 at;                // last accepted position,
  Vec3 along, across;     // directions of handle and face,
  std::uint8_t tool = 0;  // and tool
  bool present = false;   // active, with a known position
  bool coil = false;      // it holds a coil,
  bool rests = false;     // which lay on the rim in this tick,
  bool used_up = false;   // or is part of a ring, until the hand is on top of the rim again
  bool paddle = false;    // it holds a paddle,
  bool blow = false;      // which was swung,
  bool strikes = false;   // in this tick,
  double swing = 1.0;     // so hard,
  double anvil = 0.0;     // against an anvil that came so hard (HandInput),
  double struck = 0.0;    // and hit the wall with so much force, N,
  Vec3 struck_out;        // and back that way
  ToolContact contact;
  WireHand wire;
  force::Guard guard;
  force::HandVelocity velocity;  // used only if the scene has friction

  /// Takes a sample of an active hand. An invalid one is dropped: the last one stays, and the
  /// result is false. For a present hand, sets the path of `sweep` for the tick; the caller fills
  /// in angles and seconds.
  /// `in`: without a coil or a paddle that the scene does not have.
  bool take(const HandInput& in, std::span<const Tool> tools, ToolSweep& sweep) noexcept;
  /// Call when the hand leaves. The next valid sample is an arrival: no sweep from the last
  /// position, no force yet.
  void leave() noexcept;
  void add_to(StateHash& hash, std::span<const Tool> tools) const;

 private:
  void hold_as(const HandInput& in, const Tool& tool, Vec3 to) noexcept;
};

/// `hand` with its `tool`, for drawing; `beating`: null if the scene has no paddle.
HandView seen(const HandState& hand, const Tool& tool, const BeatingDef* beating) noexcept;

}  // namespace onggi::scene
