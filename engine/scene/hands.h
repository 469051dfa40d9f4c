#pragma once

#include <array>
#include <cstdint>

#include "engine/clay/wall_side.h"
#include "engine/contact/place.h"
#include "engine/force/tool_touch.h"
#include "engine/math/vec.h"

namespace onggi {

/// One tool, as a device reports it. The frame is the studio's: y up along the wheel's axis from
/// the wheel head, x to the visitor's right, z towards the visitor. Metres.
struct HandInput {
  Vec3 position;        ///< Middle of the tool's working part (engine/docs/tools.md).
  bool active = false;  ///< false: lifted away; no contact and no force.
  SideWish side = SideWish::by_position;
  std::uint8_t tool = 0;  ///< 0: the ball of SceneDef::tool; n: SceneDef::tools[n - 1]. A change of
                          ///< tool lifts the hand.
  Vec3 handle{};  ///< Direction of the tool's length; need not be a unit vector. (0, 0, 0): as a
                  ///< potter holds it, by the hand's angle about the axis.
  double roll = 0.0;  ///< Turn about that direction, rad.
  friend bool operator==(const HandInput&, const HandInput&) = default;
};

inline constexpr int kMaxHands = 2;

/// Everything a potter does in one tick; with dt, all that a replay needs.
struct Hands {
  std::array<HandInput, kMaxHands> hand;
  double wheel_speed = 0.0;  ///< Asked speed, rad/s, positive turns the clay from x towards z.
  bool water = false;        ///< A wet sponge is held to the clay.
  bool renew = false;  ///< Put on a fresh lump: starts when it becomes true, takes elements / 8192
                       ///< ticks, in which nothing is pressed.
  bool restore = false;  ///< Take the last stroke or renew back (engine/clay/history.h); starts and
                         ///< lasts likewise.
  friend bool operator==(const Hands&, const Hands&) = default;
};

/// Bits of Feedback::faults. Each is latched by the guard until Scene::clear_faults().
enum FaultBit : std::uint32_t {
  kFaultInput = 1u << 0,  ///< A hand was NaN, infinite, beyond 10 m, or held an unknown tool: the
                          ///< last sample was used.
  kFaultTime = 1u << 1,   ///< dt was not in [1 us, 5 ms] and was clamped; NaN becomes 1 us.
  kFaultForce = 1u << 2,  ///< A force came out non-finite and was set to zero.
};

/// What one hand feels.
struct HandFeedback {
  Vec3 force;  ///< On the hand, studio frame, newtons, guarded.
  bool contact = false;
  WallSide side = WallSide::outside;  ///< Face of the wall; on the rim, the face it came from.
  Place place = Place::outside;       ///< Where it works, or where it is while clear.
  double depth = 0.0;                 ///< Deepest press of this tick, metres.
  force::Touch touch;  ///< The contact before the guard, for devices with a coupling.
};

/// What a tick gives back.
struct Feedback {
  std::array<HandFeedback, kMaxHands> hand;
  double wheel_angle = 0.0;  ///< Radians, 0..2 pi.
  double wheel_speed = 0.0;  ///< rad/s.
  double clay_angle = 0.0;   ///< The wheel's; fixed once the pot is cut free.
  double cut_free = 0.0;     ///< Share of the section that a wire has cut. At 1 the pot is free: it
                          ///< does not turn and tools do not shape it until there is a new lump, or
                          ///< a step is taken back.
  double wetness = 0.0;      ///< 0 dry .. 1 dripping.
  double sinking = 0.0;      ///< Speed at which the rim sinks by itself, m/s (slump).
  bool fallen = false;       ///< See Scene::fallen().
  bool torn = false;         ///< A row is torn: see Scene::torn().
  std::uint32_t faults = 0;  ///< FaultBit.
};

}  // namespace onggi
