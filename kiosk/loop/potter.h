#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/scene/replay.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/loop/status.h"

namespace onggi::loop {

/// What the screens ask of the wheel. Given by value; nothing here waits.
class PotterCommands {
 public:
  virtual ~PotterCommands() = default;
  /// A new pot. Ends any script.
  virtual void start(std::unique_ptr<Scene> scene) = 0;
  /// Lets a script move the hands (nullptr: the visitor again).
  virtual void play(std::unique_ptr<Script> script) = 0;
  virtual void hand(int index,
                    const HandInput& target) = 0;  ///< The loop glides there at a hand's speed.
  virtual void wheel(double rad_per_s) = 0;
  virtual void water(bool held) = 0;
  virtual void renew() = 0;
  virtual void restore() = 0;
  virtual void pause(bool on) = 0;
};

}  // namespace onggi::loop
