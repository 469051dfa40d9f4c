#pragma once

#include <cstdint>
#include <memory>

#include "engine/force/leather_hand.h"
#include "engine/scene/scene.h"
#include "engine/script/ring_plan.h"
#include "engine/script/script.h"
#include "kiosk/wheel/loop/in_hand.h"

namespace onggi::loop {

/// The wheel's commands for the screens. Arguments are values; only settle() waits.
class WheelCommands {
 public:
  virtual ~WheelCommands() = default;
  /// Puts a new pot on the wheel. Ends any script; hands are lifted and lose their tools.
  virtual void start(std::unique_ptr<Scene> scene) = 0;
  /// Lets a script move the hands (nullptr: the visitor again).
  virtual void play(std::unique_ptr<Script> script) = 0;
  /// Sets the target for the devices of hand `index` that follow a finger or keys; they glide
  /// there.
  virtual void hand(int index, const HandInput& target) = 0;
  /// Gives hand `index` a tool (HandInput::tool), whatever device leads it, until another tool or a
  /// new pot.
  virtual void take(int index, std::uint8_t tool) = 0;
  /// Until another one or a new pot, which finds hand 0 with its tool.
  virtual void hold(InHand what) = 0;
  /// How hard the paddle and its anvil strike from now on. hold() makes both full.
  virtual void swing(const script::Swings& swings) = 0;
  virtual void wheel(double rad_per_s) = 0;
  virtual void water(bool held) = 0;
  /// Charcoal hangs inside the pot and dries it, until it is taken out or a new pot comes.
  virtual void fire(bool hangs) = 0;
  virtual void renew() = 0;
  virtual void restore() = 0;
  /// Pauses the simulation and lifts all hands.
  virtual void pause(bool on) = 0;
  /// The clay on the wheel is leather-hard from now on (nullptr: soft again), and `wall` is its
  /// outline. Meanwhile it is not stepped, paused or not; hands of force devices hold the tool of
  /// decorate() and feel the wall, and status tells where they are (LoopStatus::at_leather). A new
  /// pot or a script ends it.
  virtual void harden(std::unique_ptr<force::LeatherOutline> wall) = 0;
  /// While the clay is leather-hard: the tool in every hand, and how the pot stands on the screen.
  /// Call once a frame.
  virtual void decorate(const force::DecoratingTool& tool, const force::LeatherTurn& turn) = 0;
  /// Acknowledges these FaultBits, so that a repeat is reported again.
  virtual void clear_faults(std::uint32_t which) = 0;
  /// Updates every row of the clay's view, and the prints on it, to the last tick. False if the
  /// loop did not answer within a second; then call again.
  virtual bool refresh_every_row() = 0;
};

}  // namespace onggi::loop
