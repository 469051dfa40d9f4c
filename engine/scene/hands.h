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
  Vec3 position;        ///< Centre of the tool's working part (engine/docs/tools.md).
  bool active = false;  ///< false: lifted; no contact and no force.
  SideWish side = SideWish::by_position;
  std::uint8_t tool = 0;  ///< 0: the ball of SceneDef::tool; n: SceneDef::tools[n - 1]. A change of
                          ///< tool lifts the hand.
  Vec3 handle{};      ///< Direction of the tool's length; need not be a unit vector. (0, 0, 0): a
                      ///< potter's usual grip, turned with the hand's angle about the axis.
  double roll = 0.0;  ///< Turn about that direction, rad.
  bool coil = false;  ///< It holds a coil of clay, with its middle at `position`, and lays it on
                      ///< the rim; its tool presses nothing. Only where the scene has BuildingDef.
                      ///< A change lifts the hand.
  /// It holds a paddle, and its tool presses nothing: the wall is firm for a ball at `position`.
  /// Only where the scene has BeatingDef; before a coil. A change lifts the hand.
  bool paddle = false;
  double anvil = 0.0;  ///< How hard an anvil behind the wall comes against the paddle: share of
                       ///< BeatingDef::energy, 0..1. 0: there is none. A hand on the other face
                       ///< holds the wall too, as far as it reaches; the harder one counts.
  double swing = 1.0;  ///< How hard the paddle strikes: share of the energy, 0..1.
  bool blow = false;   ///< The paddle strikes the wall in front of `position`, once, in the tick in
                       ///< which this becomes true, and lies there until it is false.
  friend bool operator==(const HandInput&, const HandInput&) = default;
};

inline constexpr int kMaxHands = 2;

/// Everything a potter does in one tick. With dt, all that a replay needs.
struct Hands {
  std::array<HandInput, kMaxHands> hand;
  double wheel_speed = 0.0;  ///< Asked speed, rad/s, positive turns the clay from x towards z.
  bool water = false;        ///< A wet sponge is held against the clay.
  bool fire = false;         ///< A pot of glowing charcoal hangs inside and dries the clay
                             ///< (MoistureDef::fire_time).
  bool renew = false;  ///< Lay a fresh lump. Starts when it becomes true and takes elements / 8192
                       ///< ticks, during which nothing is pressed.
  bool restore = false;  ///< Undo the last stroke or renew (engine/clay/history.h). Starts and
                         ///< lasts like renew.
  friend bool operator==(const Hands&, const Hands&) = default;
};

/// Bits of Feedback::faults. Each is latched by the guard until Scene::clear_faults().
enum FaultBit : std::uint32_t {
  kFaultInput = 1u << 0,  ///< A hand was NaN, infinite, beyond 10 m, or held an unknown tool. The
                          ///< last sample was used.
  kFaultTime = 1u << 1,   ///< dt was not in [1 us, 5 ms] and was clamped; NaN becomes 1 us.
  kFaultForce = 1u << 2,  ///< A force was not finite and was set to zero.
};

/// What one hand feels.
struct HandFeedback {
  Vec3 force;            ///< On the hand, studio frame, newtons, guarded.
  bool contact = false;  ///< It presses the clay, its coil rests on the rim, or its
                         ///< paddle on the wall.
  double blow = 0.0;  ///< Force of its blow while the paddle lies there, N: the mean while the clay
                      ///< yielded, times the share of the energy that it had, so that a light blow
                      ///< is felt lightly. 0: none, or it missed.
  Vec3 blow_out;      ///< The way back from that blow; unit, studio frame.
  WallSide side = WallSide::outside;  ///< Face of the wall; on the rim, the face it came from.
  Place place = Place::outside;       ///< Where it works, or would work if it is clear.
  double depth = 0.0;                 ///< Deepest press of this tick, metres.
  force::Touch touch;  ///< The contact before the guard, for devices with a coupling.
};

/// The result of a tick.
struct Feedback {
  std::array<HandFeedback, kMaxHands> hand;
  double wheel_angle = 0.0;  ///< Radians, 0..2 pi.
  double wheel_speed = 0.0;  ///< rad/s.
  double clay_angle = 0.0;   ///< As wheel_angle; fixed once the pot is cut free.
  double cut_free = 0.0;     ///< Share of the section that a wire has cut. At 1 the pot is free: it
                             ///< does not turn, and tools do not shape it, until a new lump or an
                             ///< undo.
  double wetness = 0.0;      ///< 0 dry .. 1 dripping.
  double sinking = 0.0;      ///< Speed at which the rim sinks by itself, m/s (slump).
  bool fallen = false;       ///< See Scene::fallen().
  bool torn = false;         ///< A row is torn: see Scene::torn().
  std::uint32_t faults = 0;  ///< FaultBit.
};

}  // namespace onggi
