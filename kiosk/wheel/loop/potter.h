#pragma once

#include <cstdint>
#include <memory>

#include "engine/scene/scene.h"
#include "engine/script/script.h"

namespace onggi::loop {

/// What the screens ask of the wheel. Given by value; nothing waits but settle().
class PotterCommands {
 public:
  virtual ~PotterCommands() = default;
  /// A new pot. Ends any script; hands are lifted and hold nothing of their own.
  virtual void start(std::unique_ptr<Scene> scene) = 0;
  /// Lets a script move the hands (nullptr: the visitor again).
  virtual void play(std::unique_ptr<Script> script) = 0;
  /// Leads the devices of hand `index` that follow a finger or keys: they glide there.
  virtual void hand(int index, const HandInput& target) = 0;
  /// Gives hand `index` a tool (HandInput::tool), whatever device leads it, until it takes another
  /// or there is a new pot.
  virtual void take(int index, std::uint8_t tool) = 0;
  virtual void wheel(double rad_per_s) = 0;
  virtual void water(bool held) = 0;
  virtual void renew() = 0;
  virtual void restore() = 0;
  /// The pot rests: no time passes for it, and no hand is at it.
  virtual void pause(bool on) = 0;
  /// These FaultBits are told; should they come again, they are new.
  virtual void clear_faults(std::uint32_t which) = 0;
  /// Brings the view of the clay up to the last tick, every row of it. False when the loop did not
  /// answer within a second; then ask again.
  virtual bool settle() = 0;
};

}  // namespace onggi::loop
