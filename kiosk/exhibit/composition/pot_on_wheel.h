#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_def.h"
#include "engine/script/script.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/loop/fault_log.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// The pot that is being thrown: puts a fresh lump on the wheel when a visit asks for one, in the
/// scene of its vessel, and remembers what it is. A worker makes the lump, which takes a second on
/// the largest grid, while the pot before stays. Main thread.
class PotOnWheel {
 public:
  /// `seed`: of the scripts that play in attract. `at_once`: without a worker, so that a stepped
  /// visit is the same every time. All else outlives this.
  PotOnWheel(const Scenes& scenes, loop::WheelHost& wheel_host, render::Renderer& renderer,
             std::uint64_t seed, bool at_once);

  /// Begins to make a lump for the vessel of `card`. A wish that comes before it is made replaces
  /// it.
  void start(const screens::StartPot& wish, const screens::ShelfCard& card);
  /// True when the last wish can be put on the wheel.
  bool made();
  /// What that wish named; its card is put() with it.
  int wished_card() const { return wish_.card; }
  /// Puts it on the wheel; then a recording begins, or the script that was asked for plays.
  /// Problem where the scene cannot be made: the pot before stays.
  Result<void> put(const screens::ShelfCard& card);
  /// Logs what has gone wrong in the ticks since the last call.
  void log_faults();

  const SceneDef& def() const { return def_; }
  /// Of the shelf, or a mission's own; -1 before the first pot.
  int card() const { return card_; }

 private:
  /// What a worker needs: nothing of it changes.
  struct Order {
    SceneDef def;
    Profile target;
    std::string script;
    std::uint64_t seed = 0;
  };
  struct Made {
    SceneDef def;
    Result<std::unique_ptr<Scene>> scene;
    Result<std::unique_ptr<Script>> script;
  };
  static Made make(Order order);
  void begin(Order order);

  const Scenes& scenes_;
  loop::WheelHost& wheel_host_;
  render::Renderer& renderer_;
  bool at_once_;
  screens::StartPot wish_;        ///< The last.
  std::optional<Order> waiting_;  ///< Its order, until the one before is made.
  std::future<Made> making_;
  SceneDef def_;
  int card_ = -1;
  std::uint64_t seed_, pots_ = 0;
  loop::FaultLog faults_;
};

}  // namespace onggi::exhibit
