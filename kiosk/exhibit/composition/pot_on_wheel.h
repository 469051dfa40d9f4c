#pragma once

#include <cstdint>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/loop/fault_log.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// The pot that is being thrown: puts a fresh lump on the wheel when a visit asks for one, in the
/// scene of its vessel, and remembers what it is. Main thread.
class PotOnWheel {
 public:
  /// `seed`: of the scripts that play in attract. All else outlives this.
  PotOnWheel(const Scenes& scenes, loop::WheelHost& wheel_host, render::Renderer& renderer,
             std::uint64_t seed);

  /// A lump for the vessel of `card`; then a recording begins, or the script that was asked for
  /// plays. Problem where the scene cannot be made: the pot before stays.
  Result<void> start(const screens::StartPot& wish, const screens::ShelfCard& card);
  /// Logs what has gone wrong in the ticks since the last call.
  void log_faults();

  const SceneDef& def() const { return def_; }
  /// Of the shelf, or a mission's own; -1 before the first pot.
  int card() const { return card_; }

 private:
  const Scenes& scenes_;
  loop::WheelHost& wheel_host_;
  render::Renderer& renderer_;
  SceneDef def_;
  int card_ = -1;
  std::uint64_t seed_, pots_ = 0;
  loop::FaultLog faults_;
};

}  // namespace onggi::exhibit
